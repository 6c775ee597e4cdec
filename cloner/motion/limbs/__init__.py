"""Moving parts of a person: joint chains, rotations, clearance, hanging hair."""
