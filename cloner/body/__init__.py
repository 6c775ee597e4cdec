"""The body: poses, cameras, shape and outlines, and the head's pose in each photo."""
