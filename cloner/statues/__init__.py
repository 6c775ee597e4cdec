"""Statues: clones in stone, photographs of statues laid on meshes, bodies of blobs, heads of clay."""
