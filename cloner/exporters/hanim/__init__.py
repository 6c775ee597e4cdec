"""The H-Anim standard on a clone: names, sites, limits, prototypes, rigid pieces."""
