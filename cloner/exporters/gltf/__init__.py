"""Binary glTF: skin, morph targets, motions, and a compressed version for the web."""
