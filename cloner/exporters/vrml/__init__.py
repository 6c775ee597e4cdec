"""VRML97 and its successor X3D."""
