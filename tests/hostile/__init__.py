"""Bad input, and what must be said about it."""
