"""Frozen values that stages take and give; no algorithms, no files."""
