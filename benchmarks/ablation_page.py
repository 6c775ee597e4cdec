"""Write docs/ablation.md: what each step is worth, paired with the product as it is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final, NamedTuple

import numpy as np

Row = Mapping[str, Any]

PAGE: Final = Path(__file__).resolve().parents[1] / "docs" / "ablation.md"
#: The product itself, which every way is compared with.
ALL: Final = "all steps"
#: Every figure, how many decimals it has, and whether less is better.
FIGURES: Final = {
    "outline px": (3, True),
    "outline IoU": (4, False),
    "input IoU": (4, False),
    "45 degrees IoU": (4, False),
    "joints mm": (2, True),
    "lids and lips %": (2, True),
    "face mm": (3, True),
    "landmarks mm": (2, True),
    "photos apart mm": (2, True),
}
#: A step that is worth its name makes its own figure better by this share (issue 19).
WORTH: Final = 0.1
MEANT: Final = (
    "*outline px*: mean distance of the body's outlines from the true ones, photos of 1,800 px; *outline IoU*: their "
    "overlap; *input IoU*, *45 degrees IoU*: overlap of the fine body with the true silhouette below the head, in the "
    "photos and from a direction that no photo showed; *joints*: twelve joints of the fitted pose beside the true "
    "ones, in the photos; *lids and lips*: how far the curves found in the face's front photo lie beside the true "
    "ones, percent of the irises' distance; *face*: surface, size free; *landmarks*: 20 points of the face; *photos "
    "apart*: how far apart on the skin the face's front and side photo put the same texel."
)


class Difference(NamedTuple):
    """A figure without a step beside all steps, over the people who have both."""

    mean: float
    without: float
    away: float
    half: float
    people: int

    def is_worse(self, *, less_is_better: bool) -> bool:
        """Return whether the step's absence harms beyond the 95 % interval."""
        return (self.away if less_is_better else -self.away) > self.half


def difference(rows: Sequence[Row], way: str, figure: str) -> Difference | None:
    """Return a figure's paired difference with half of its 95 % interval, None where a way cannot move it."""
    pairs = [(row["ways"][ALL].get(figure), row["ways"].get(way, {}).get(figure)) for row in rows]
    both = np.array([pair for pair in pairs if None not in pair], np.float64)
    if len(both) < 2:
        return None
    away = both[:, 1] - both[:, 0]
    half = 1.96 * away.std(ddof=1) / np.sqrt(len(away))
    return Difference(*(float(x) for x in (*both.mean(axis=0), away.mean(), half)), len(both))


def table(rows: Sequence[Row]) -> str:
    """Return the means of all figures, and each way's differences from them; what is worse without a step is bold."""
    lines = ["| | " + " | ".join(FIGURES) + " |", "| --- |" + " --- |" * len(FIGURES)]
    for way in rows[0]["ways"]:
        cells = [_cell(difference(rows, way, figure), way, *rule) for figure, rule in FIGURES.items()]
        lines.append(f"| {way} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _cell(found: Difference | None, way: str, digits: int, less: bool) -> str:
    if found is None:
        return ""
    if way == ALL:
        return f"{found.mean:.{digits}f}"
    cell = f"{found.away:+.{digits}f} ± {found.half:.{digits}f}"
    return f"**{cell}**" if found.is_worse(less_is_better=less) else cell


def own_table(rows: Sequence[Row], own: Mapping[str, str]) -> str:
    """Return every step's own figure with and without it, and whether that is worth the step."""
    lines = ["| step | figure | with it | without it | gain | worth it |", "| --- | --- | --- | --- | --- | --- |"]
    for way, figure in own.items():
        found = difference(rows, way, figure)
        if found is None:
            continue
        digits, less = FIGURES[figure]
        ends = (found.mean, found.without) if less else (1.0 - found.mean, 1.0 - found.without)
        gain = 1.0 - ends[0] / ends[1]
        name = figure if less else f"1 − {figure}"
        worth = "yes" if gain >= WORTH and found.is_worse(less_is_better=less) else "no"
        lines.append(
            f"| {way} | {name} | {ends[0]:.{digits}f} | {ends[1]:.{digits}f} | {100.0 * gain:.0f} % | {worth} |"
        )
    return "\n".join(lines)


def write_page(rows: Sequence[Row], own: Mapping[str, str], command: str) -> None:
    """Write the page."""
    commits = ", ".join(sorted({row["commit"] for row in rows}))
    text = f"""# What each step is worth

{len(rows)} people of the generator ({rows[0]["name"]} to {rows[-1]["name"]}) of whom nothing was learned,
five photographs each. Written by `{command}`
at {commits}; what each way changes stands in `benchmarks/ablation.py`. Nobody corrected a point.

Means over the people. Below *{ALL}*, what changes without a step: mean paired difference and its 95 % interval, bold
where the product is worse off without the step. Empty where a step cannot move a figure.

{table(rows)}

{MEANT}

## Every step by its own figure

A step is worth its name where its own figure is better by {100.0 * WORTH:.0f} % with it and the interval is clear of 0.

{own_table(rows, own)}

What became of steps that are not: [the method, step by step](algorithms.md).
"""
    PAGE.write_text(text)
