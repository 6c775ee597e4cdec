"""Texture charts: the atlas, planar charts of surfaces, which photo paints what."""
