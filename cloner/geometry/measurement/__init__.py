"""Lengths and girths of bodies, as a tape measure lies, with and without clothes."""
