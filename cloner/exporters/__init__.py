"""Exporters, one module per file format; ``table`` lists them."""
