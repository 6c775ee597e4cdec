"""Shapes that change: free-form deformation, completion, shape coefficients from points and curves."""
