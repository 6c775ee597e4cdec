"""Hair as a volume, from the evidence of all photos."""
