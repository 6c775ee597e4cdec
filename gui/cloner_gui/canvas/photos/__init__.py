"""A photo with its points and outlines, and their editing."""
