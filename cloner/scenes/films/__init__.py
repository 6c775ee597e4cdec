"""The film language: lines become footings of clones, light and cameras."""
