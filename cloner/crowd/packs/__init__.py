"""Packs: made, read, validated, listed, and drawn as stills or films."""
