"""Loose clothes, headscarves, hoods, and the peaks of caps."""
