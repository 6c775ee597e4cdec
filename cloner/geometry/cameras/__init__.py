"""Cameras: where they stand, what they see of a surface, and pose from known points."""
