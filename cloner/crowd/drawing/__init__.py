"""Drawing a crowd: shaders, impostors, off screen and in the browser's page."""
