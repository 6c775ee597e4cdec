"""Scoring of finished clones against known truth; nothing here feeds a clone."""

from cloner.evaluate.scoreboard import evaluate_visitors, format_table

__all__ = ["evaluate_visitors", "format_table"]
