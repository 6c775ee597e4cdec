"""Who stands where in which look, cameras, light and rooms."""
