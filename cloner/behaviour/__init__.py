"""Crowds with a mind: a world, people who walk in it, groups that know, believe and feel, and a language to say so."""
