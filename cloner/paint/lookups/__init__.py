"""Lookups of texel colours in photos, and their reliability."""
