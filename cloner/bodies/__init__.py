"""Bodies from measures: a clone where there is no photograph, and a clone that is told new measures."""
