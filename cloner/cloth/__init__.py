"""Garments: drafted from a clone's measures, sewn, and moved on the walking clone."""
