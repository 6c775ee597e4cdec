"""Captured motions: read from files, their joints named, laid on a clone."""
