"""Garments: drafted from a clone's measures, sewn, and simulated on the walking clone."""
