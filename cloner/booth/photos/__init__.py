"""Photos at the booth: cameras, new files, storage, and the check of each new photo."""
