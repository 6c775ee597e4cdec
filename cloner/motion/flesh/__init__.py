"""Volume of flesh around bent joints, and other rest poses."""
