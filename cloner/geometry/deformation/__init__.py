"""Deformation: free-form deformation and piecewise affine completion."""
