"""Photos laid on the generic human: between the stages and the plain vision and geometry below."""
