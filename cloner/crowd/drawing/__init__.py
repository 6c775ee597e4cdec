"""Rendering of a crowd: shaders, impostors, offscreen and in the browser."""
