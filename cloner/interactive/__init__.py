"""Immediate response to an operator's points: the body, the outline, the distances."""
