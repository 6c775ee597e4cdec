"""Where a texel's colour is looked up: photos as sources, and how far each is believed."""
