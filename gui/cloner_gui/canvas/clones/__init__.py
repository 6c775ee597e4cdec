"""The clone in 3-D: rotated, zoomed, dressed, waving."""
