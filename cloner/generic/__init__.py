"""The shipped generic human, and what belongs to its mesh."""
