"""Named points of the face: from the net in front, along the profile at the side."""
