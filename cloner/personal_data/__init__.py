"""Whose data is held where, handed out or forgotten."""
