"""Faces over time: expressions, speech, and MPEG-4 parameters."""
