"""Packs: made, read, checked, listed, and drawn as stills or films."""
