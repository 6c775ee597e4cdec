"""The head: observations in the face photos and body photos, and the fit of one head to all of them."""
