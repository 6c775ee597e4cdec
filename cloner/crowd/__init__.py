"""Crowds of thousands of clones: packs for engines, a browser player, stills and films."""
