"""Masks: which pixels are the person, hair, limbs or loose cloth."""
