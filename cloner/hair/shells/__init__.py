"""Hair as surfaces: shells, their textures, soft edges, single hairs, beards."""
