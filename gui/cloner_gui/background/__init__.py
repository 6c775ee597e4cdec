"""Work in other threads than the window's."""
