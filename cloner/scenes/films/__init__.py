"""The film language: its lines become footings of clones, light and cameras."""
