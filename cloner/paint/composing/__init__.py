"""The atlas composed from photos, tile by tile."""
