"""Words and sentences in the window's language."""
