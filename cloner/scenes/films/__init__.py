"""The language of films: lines become footings of clones, light and cameras."""
