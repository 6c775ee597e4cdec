"""Photographs prepared as texture: normalised, repaired, aligned; and colours of what no photo shows."""
