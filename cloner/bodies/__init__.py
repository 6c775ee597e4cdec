"""Bodies from measures: a clone without photographs, and a clone changed to new measures."""
