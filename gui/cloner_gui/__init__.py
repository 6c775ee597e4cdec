"""The window: photos with their points, correcting by hand, cloning, and looking at the result."""
