"""Corrections as constraints on a finished person, and the deformation of skin and pose that meets them."""
