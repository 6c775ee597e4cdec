"""The core of the walkers: `walkers.wasm`, made of the AssemblyScript here, run alike by Python, node and browsers."""
