"""Scenes that go on while browsers show them."""
