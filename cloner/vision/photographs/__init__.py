"""Photographs as arrays: decoded, cut out, blended, freed of noise, and written as films."""
