"""Building blocks of pages: cards, fields, rows, bars."""
