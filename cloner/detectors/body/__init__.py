"""Named points of a body photo, from the pose net and the outline."""
