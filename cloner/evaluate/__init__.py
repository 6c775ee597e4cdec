"""Scoring finished clones of visitors whose truth is known; nothing here feeds a clone."""

from cloner.evaluate.scoreboard import evaluate_visitors, format_table

__all__ = ["evaluate_visitors", "format_table"]
