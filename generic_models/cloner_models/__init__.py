"""The generic human and the nets that Cloner ships: data only, no code."""
