"""Photos at the booth: cameras, new files, where they are stored, and what a look at them tells."""
