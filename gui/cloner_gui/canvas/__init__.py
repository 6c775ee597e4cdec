"""Widgets that show photos and clones, and accept mouse and touch."""
