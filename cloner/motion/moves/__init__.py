"""Procedural motions: walk, idle, acts and a greeting, with planted feet."""
