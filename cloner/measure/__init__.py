"""What stands between a clone's measures and those of the body below its clothes."""
