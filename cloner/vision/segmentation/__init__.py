"""Masks: the pixels of the person, hair, limbs or loose clothing."""
