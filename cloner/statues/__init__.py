"""Statues: clones in stone, photographs fitted to meshes, bodies of blobs, clay heads."""
