"""Nets and rules that propose what a photo shows; ``table`` lists them."""
