"""What follows an operator's points while they move: the body, the outline, the gaps."""
