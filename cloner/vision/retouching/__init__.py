"""Photographs made ready to be texture: evened, repaired, aligned, and colours that no photo shows."""
