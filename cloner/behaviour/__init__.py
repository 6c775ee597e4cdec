"""Crowd simulation: a world, people who walk in it, groups that know, believe and feel, and a scenario language."""
