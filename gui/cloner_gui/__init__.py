"""The window: photos with their points, corrections by hand, cloning, and the result."""
