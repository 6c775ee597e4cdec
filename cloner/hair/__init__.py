"""Shells around the person: hair, beards, hoods and loose clothes."""
