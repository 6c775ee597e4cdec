"""Garments put on a clone and moved with it."""
