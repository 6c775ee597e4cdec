"""Triangle meshes: edges and neighbours, nearest points, normals, pixels they cover."""
