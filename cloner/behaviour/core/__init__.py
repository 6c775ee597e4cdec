"""The engine of crowds: `engine.wasm`, made of the AssemblyScript here, run alike by Python, node and browsers."""
