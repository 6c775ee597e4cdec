"""Where hair is: what every photo says, and hair as a volume."""
