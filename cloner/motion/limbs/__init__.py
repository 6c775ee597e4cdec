"""The parts of a person that move: chains of joints, rotations, clearance, hanging hair."""
