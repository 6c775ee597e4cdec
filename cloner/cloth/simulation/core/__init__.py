"""The cloth engine: `engine.wasm`, compiled from the AssemblyScript here."""
