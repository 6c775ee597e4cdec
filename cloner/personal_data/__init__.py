"""Personal data: where it is held, its export and its deletion."""
