"""Garment patterns: drafted from measures or read from files, and triangulated."""
