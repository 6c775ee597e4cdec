"""The studio: windows for what an operator makes of finished clones, and of nobody's."""
