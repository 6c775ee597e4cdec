"""One module a file format; ``table`` lists them."""
