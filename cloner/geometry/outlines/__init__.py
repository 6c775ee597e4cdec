"""Outlines of photos, silhouettes of posed bodies, and their matching."""
