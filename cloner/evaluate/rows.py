"""Scores as rows, and held-out pictures."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cloner.evaluate.scores import Score
from cloner.evaluate.truths.truth import Truth
from cloner.exporters.shared.files import jpeg_bytes, write_bytes

Row = dict[str, Any]
Figures = Mapping[str, Mapping[tuple[str, str], Score]]
"""Scores of the clone ("value") and the baselines ("generic", "other") by metric and view."""


def rows_of(visitor: str, set_name: str, scores: Iterable[Score], figures: Figures) -> list[Row]:
    """Return one row a score, with what the baselines reach."""

    def baseline(column: str, score: Score) -> float | None:
        found = figures.get(column, {}).get((score.metric, score.view))
        return None if found is None else found.value

    return [
        {
            "visitor": visitor,
            "set": set_name,
            "view": score.view or None,
            "metric": score.metric,
            "value": score.value,
            "unit": score.unit,
            "generic": baseline("generic", score),
            "other": baseline("other", score),
        }
        for score in scores
    ]


def save_held_out(folder: Path, truth: Truth, pictures: Mapping[str, Sequence[NDArray[np.uint8]]]) -> None:
    """Write every held-out photo with the pictures drawn for it side by side."""
    for view, drawn in pictures.items():
        strip = np.concatenate([truth.views[view].photo, *drawn], axis=1)
        write_bytes(folder / f"held_out_{view}.jpg", jpeg_bytes(strip))
