"""The page of the operator's effort: error against drags, who is there after twelve, and what was dragged first."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

PAGE = Path(__file__).resolve().parents[1] / "docs" / "operator_effort.md"
BAR: Final = "12"
#: Share of the way to the true features, and rest of it (mm; % of the eyes' distance), that count as there.
ENOUGH, NEAR = 0.9, 0.1
INTRO = """# What drags buy

Written by `python benchmarks/operator_effort.py --heads {heads} --page`. A scripted operator goes through the points in
the window's order and drags what lies off its place to its true place (farther than 2 % of the eyes' distance in face
photos); every drag teaches the other points of its photo. Landmarks and surfaces are 3-D errors of the fitted head, mm;
points those of the face photos, % of the eyes' distance. *There*: nine tenths of the way from no drag to all true
features, or within 0.1 of them, after 12 drags; *no way to go*: true features are no better than proposed ones.
"""


def write_page(folder: Path) -> Path:
    """Write the page from the JSON files of a folder and return its path."""
    works = [json.loads(path.read_text()) for path in sorted(folder.glob("*.json"))]
    done = [work for work in works if "rows" in work]
    heads = [work for work in done if work["name"].startswith("head")]
    sets = [work for work in done if not work["name"].startswith("head")]
    parts = [INTRO.format(heads=len(heads))]
    for title, chosen in (("The six sample sets", sets), ("Random painted heads, face photos only", heads)):
        if chosen:
            parts += [f"## {title}\n", *mean_table(chosen), ""]
    parts += ["## Every case, landmarks (mm)\n", *case_table(done), ""]
    parts += ["## Dragged within the first 12\n", first_dragged(done), ""]
    lost = [f"{work['name']}: {work['error']}" for work in works if "error" in work]
    parts += ["Refused: " + "; ".join(lost) + ".\n"] if lost else []
    PAGE.write_text("\n".join(parts))
    return PAGE


def at(work: dict[str, Any], count: str, metric: str) -> float:
    """Return a metric after some drags; all true features where fewer were wanted."""
    return float(work["rows"].get(count, work["rows"]["all"])[metric])


def counts_of(works: Sequence[dict[str, Any]]) -> list[str]:
    """Return the columns: numbers of drags in order, all last."""
    found = {count for work in works for count in work["rows"]} - {"all"}
    return [*sorted(found, key=int), "all"]


def share_gone(works: Sequence[dict[str, Any]], metric: str) -> str:
    """Return the share of the way that 12 drags went on the average, or that they are there."""
    none, some, every = (float(np.mean([at(work, count, metric) for work in works])) for count in ("0", BAR, "all"))
    if some - every <= NEAR:
        return "there"
    gone = (none - some) / (none - every) if none - every > NEAR else None
    return "no way to go" if gone is None else "there" if gone >= ENOUGH else f"{100 * gone:.0f} %"


def mean_table(works: Sequence[dict[str, Any]]) -> list[str]:
    """Return the lines of a table of means: a row a metric, a column a number of drags."""
    counts = counts_of(works)
    lines = [
        f"| mean of {len(works)} | " + " | ".join(counts) + " | after 12 |",
        "| --- |" + " --- |" * (len(counts) + 1),
    ]
    for metric in works[0]["rows"]["0"]:
        cells = [f"{np.mean([at(work, count, metric) for work in works]):.2f}" for count in counts]
        lines.append(f"| {metric} | " + " | ".join(cells) + f" | {share_gone(works, metric)} |")
    return lines


def case_table(works: Sequence[dict[str, Any]]) -> list[str]:
    """Return the lines of a table of 3-D landmark errors: a row a case."""
    counts = counts_of(works)
    lines = ["| case | " + " | ".join(counts) + " | points off | after 12 |", "| --- |" + " --- |" * (len(counts) + 2)]
    for work in works:
        cells = [f"{at(work, count, 'landmarks'):.2f}" for count in counts]
        lines.append(
            f"| {work['name']} | " + " | ".join(cells) + f" | {work['wanted']} | {share_gone([work], 'landmarks')} |"
        )
    return lines


def first_dragged(works: Sequence[dict[str, Any]]) -> str:
    """Return a sentence of the points dragged most often."""
    every = Counter(what for work in works for what in work["dragged"][: int(BAR)])
    return ", ".join(f"{what} {times}" for what, times in every.most_common(24)) + f" (of {len(works)} cases)."
