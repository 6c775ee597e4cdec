"""The product's own WebAssembly modules: shared code, and their use from Python."""
