"""A photo with its points and outlines, and the hand that moves them."""
