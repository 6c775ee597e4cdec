"""Motions of our own: walk, idle, acts and a greeting, with feet that stay where they stand."""
