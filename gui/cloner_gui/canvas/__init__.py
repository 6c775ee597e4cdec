"""Widgets that show photos and clones, and take the mouse."""
