"""The body: pose, cameras, build and outlines, and how the head is carried."""
