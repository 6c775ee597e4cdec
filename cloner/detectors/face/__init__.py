"""Named points of the face: from the face net in front, along the profile at the side."""
