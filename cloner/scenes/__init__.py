"""Rooms: a plan becomes meshes, light maps and probes, and clones act in it."""
