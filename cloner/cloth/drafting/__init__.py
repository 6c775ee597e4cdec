"""Garments as patterns: drafted from measures, drawn, and cut into triangles."""
