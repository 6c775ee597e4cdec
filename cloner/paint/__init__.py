"""From photographs to texels of the atlas."""
