"""From a plan to walls, surfaces, light-map charts and files."""
