"""The clone in three dimensions: turned, zoomed, dressed, greeting."""
