"""Clones prepared for a crowd: levels of detail, clips, colours, shader arrays."""
