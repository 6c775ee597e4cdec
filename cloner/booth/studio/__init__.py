"""The studio: clothes, bodies from measures and statues, made from finished clones or from nothing."""
