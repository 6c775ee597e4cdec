"""The head: evidence of the face photos, and the fit of one head to all of it."""
