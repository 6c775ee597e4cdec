"""Cloner: five photographs and a height in, an animatable textured human out."""

__version__ = "0.1.0"
