"""Pixels in, pixels or outlines out."""
