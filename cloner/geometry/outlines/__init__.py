"""Outlines of photos and of posed bodies, and what matches them."""
