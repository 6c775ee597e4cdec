"""The studio: windows that work on finished clones, or start from nothing."""
