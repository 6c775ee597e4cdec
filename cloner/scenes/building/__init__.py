"""A plan becomes walls, surfaces, charts of light, and files."""
