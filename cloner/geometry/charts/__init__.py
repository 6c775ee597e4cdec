"""Texture charts: the atlas, planar charts of surfaces, and the assignment of photos to the surface."""
