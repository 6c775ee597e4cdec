"""The crowd engine: `engine.wasm`, compiled from the AssemblyScript here; deterministic in Python,
node and browsers.
"""
