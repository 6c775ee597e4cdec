"""Simulation of garments on a moving clone."""
