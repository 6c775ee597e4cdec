"""Binary glTF: skin, morph targets, motions, and a packed one for the web."""
