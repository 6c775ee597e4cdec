"""A visitor: person, place in the queue, earlier work, and the operator's effort."""
