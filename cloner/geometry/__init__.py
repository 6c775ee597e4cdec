"""Arrays in, arrays out: skinning, slices, free-form deformation, meshes."""
