"""Results of a stage: values, residuals, warnings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Residual:
    """One figure that says how well a stage did.

    Attributes
    ----------
    name : str
    value : float
    unit : str
        "px", "mm", "percent" or "levels".
    view : str
        View the figure belongs to, "" for all.
    """

    name: str
    value: float
    unit: str
    view: str = ""


@dataclass(frozen=True, slots=True)
class StageResult:
    """Values a stage gives, its residuals, and warnings in plain words."""

    values: Mapping[str, object]
    residuals: tuple[Residual, ...] = field(default=())
    warnings: tuple[str, ...] = field(default=())
