"""Thousands of clones at once: packs for engines, a player for browsers, stills and films."""
