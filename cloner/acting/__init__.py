"""Scenarios acted by clones: trajectories become footings of a pack's people, and a page that plays them."""
