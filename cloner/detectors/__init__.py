"""Detectors: nets and rules that propose points, masks and labels for a photo; ``table`` lists them."""
