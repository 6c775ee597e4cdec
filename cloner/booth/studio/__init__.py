"""What an operator makes of finished clones and of nobody's: clothes, bodies from measures, statues."""
