"""Hair as surfaces: shells, their texture, soft edges, single hairs, beards."""
