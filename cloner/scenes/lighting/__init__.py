"""Light and sound in a room: rays, direct light, light maps, probes, echoes."""
