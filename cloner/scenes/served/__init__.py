"""Scenes that run while browsers show them."""
