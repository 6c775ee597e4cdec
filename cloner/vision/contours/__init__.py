"""Outlines from edges: edge segments linked along a mask's contour, and corrected by hand."""
