"""One clone made ready for a crowd: levels of detail, clips, colours, its numbers for shaders."""
