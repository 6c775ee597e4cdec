"""Figures of one clone against its truth: skin, silhouettes, texture, seams."""
