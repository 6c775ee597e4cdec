"""Learned nets: people, poses, faces and masks, and where in a photo the nets look."""
