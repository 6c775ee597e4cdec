"""Parts that pages are made of: cards, fields, rows, bars."""
