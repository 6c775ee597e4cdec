"""Flesh around bent joints, and other rest poses."""
