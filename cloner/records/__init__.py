"""Frozen records that stages take and give; no algorithms, no files."""
