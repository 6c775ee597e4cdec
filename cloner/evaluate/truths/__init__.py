"""What is truly known of visitors, and baselines that a clone must beat."""
