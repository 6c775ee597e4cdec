"""Results of a batch, one row per visitor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

CLONED: Final = "cloned"
SKIPPED: Final = "skipped"
FAILED: Final = "failed"


@dataclass(frozen=True, slots=True)
class BatchRow:
    """What became of one visitor.

    Attributes
    ----------
    identifier : str
    status : str
        "cloned", "skipped" (its result is current, or another run has it) or "failed".
    seconds : float
    warnings : int
    message : str
        One line for people.
    worst_iou : float or None
        Least overlap of the clone with a photo's silhouette; None where nothing was cloned.
    """

    identifier: str
    status: str
    seconds: float
    warnings: int
    message: str
    worst_iou: float | None = None
