"""Truth of visitors, and baselines."""
