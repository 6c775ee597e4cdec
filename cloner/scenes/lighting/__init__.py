"""Light and sound of a room: rays, direct light, light maps, probes, echoes."""
