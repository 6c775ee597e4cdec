"""A visitor: person, place in the queue, earlier work, and what they cost the operator."""
