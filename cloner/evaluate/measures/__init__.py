"""Measures as pure functions of arrays: distances, poses, crossings, moving faces."""
