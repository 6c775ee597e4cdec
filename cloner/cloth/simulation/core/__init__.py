"""The engine of cloth: `engine.wasm`, made of the AssemblyScript here."""
