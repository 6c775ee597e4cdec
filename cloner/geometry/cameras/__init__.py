"""Cameras: placement, visibility of surfaces, pose from known points."""
