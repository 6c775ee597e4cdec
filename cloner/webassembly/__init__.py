"""Modules of the product's own in WebAssembly: what they share, and how Python runs them."""
