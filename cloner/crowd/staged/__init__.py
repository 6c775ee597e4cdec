"""Staging: positions and looks of people, cameras, light and rooms."""
