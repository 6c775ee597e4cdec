"""Triangle meshes: adjacency, nearest points, normals, rasterisation."""
