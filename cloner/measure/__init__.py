"""From a clone's measures to those of the body below its clothes."""
