"""Write docs/body_benchmark.md from the benchmark's JSON files: bars, distributions, worst cases."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from body_explained import explain
from body_tables import (
    Row,
    commits,
    foreign_table,
    girths,
    groups,
    outline_value,
    outlines,
    parts,
    points,
    seconds,
    step_value,
    steps,
    table,
)

DOCS: Final = Path(__file__).resolve().parents[1] / "docs"
PAGE: Final = DOCS / "body_benchmark.md"
WORST: Final = 5
WIDEST_PX: Final = 1100
#: Stages that the bar of the body's seconds does not mean.
_OTHERS: Final = ("proposals", "points", "head", "hair")


def write_page(rows: Sequence[Row], folder: Path) -> Path:
    """Write the page and the pictures of the worst; returns its path."""
    people = [row for row in rows if "steps" in row and not row.get("foreign")]
    failed = [row for row in rows if "error" in row]
    foreign = [row for row in rows if row.get("foreign") and "steps" in row]
    sections = [_INTRODUCTION.format(people=len(people), commits=commits(people))]
    if people:
        sections += [bars(people, foreign), steps(people), groups(people), parts(people), outlines(people)]
        sections += [girths(people), points(people), seconds(people), worst(people, folder)]
    if foreign:
        sections.append(foreign_table(foreign))
    if failed:
        told = "\n".join(f"- {row['name']}: {_last_line(row['error'])}" for row in failed)
        sections.append("## Not cloned\n\n" + told)
    PAGE.write_text("\n\n".join(sections) + "\n")
    return PAGE


_INTRODUCTION: Final = """# How good the body is

Written by `python benchmarks/body.py --page` from runs of commit {commits}. {people} random people
(`generic_models/build/painted_people.py`): all shape coefficients drawn, smooth bumps that no coefficient can make,
statures 1.45 to 1.95 m, a new pose (limbs ±8°) and a new camera (2.5 to 4.5 m away, 0.9 to 1.6 m high, 45 to 75 mm,
tilted) for every photo, three tightnesses of clothes before three kinds of background; half of the people's photos
tell their focal length. Besides the photos only the stature is told. Rulers as in docs/method (surface: posed to the
truth's joints, rigid, no scale, symmetric), without head, hair and hands. No operator corrected anything, and no face
photos were given."""


def _last_line(words: str) -> str:
    return words.strip().splitlines()[-1]


def bars(people: Sequence[Row], foreign: Sequence[Row]) -> str:
    """Return the bars of the issue beside what was measured."""
    tight = [row for row in people if row["tightness"] == "tight"]
    dull = [row for row in people if row["background"] == "low_contrast"]

    def middle(rows: Sequence[Row], read: Callable[[Row], float], digits: int) -> str:
        return f"{np.median([read(row) for row in rows]):.{digits}f}" if rows else "-"

    tapes = [girth for row in people for girth in row["measures"]["girths"].values()]
    covered = np.mean([abs(g["value"] - g["true"]) <= g["plus_minus"] for g in tapes])
    main = {
        name: [abs(row["measures"]["girths"][name]["value"] - row["measures"]["girths"][name]["true"]) for row in tight]
        for name in ("chest", "waist", "hip")
        if tight
    }
    body_s = [sum(s["cpu_s"] for n, s in row["seconds"].items() if n not in _OTHERS) for row in people]
    lines = [
        ("silhouette IoU, input views, median", middle(people, step_value("input"), 4), "≥ 0.98"),
        ("silhouette IoU, held-out view, median", middle(people, step_value("held_out"), 4), "≥ 0.95"),
        ("surface mean, tight clothes, median, mm", middle(tight, step_value("surface_mean_mm"), 2), "≤ 5"),
        ("surface p95, tight clothes, median, mm", middle(tight, step_value("surface_p95_mm"), 1), "≤ 12"),
        ("surface mean, foreign body, mm", middle(foreign, step_value("surface_mean_mm"), 2), "≤ 8"),
        *((f"{name}, tight clothes, median error, mm", f"{np.median(v):.0f}", "≤ 15") for name, v in main.items()),
        ("true girth inside the printed ±, all clothes", f"{100 * covered:.0f} %", "≥ 90 %"),
        ("low contrast: outline IoU, median", middle(dull, outline_value("outline_iou"), 4),
         f"> mask alone, {middle(dull, outline_value('mask_iou'), 4)}"),
        ("body stages, CPU seconds, median", f"{np.median(body_s):.1f}", "≤ 8 of wall time on two cores (idle ones)"),
    ]  # fmt: skip
    return "## Bars\n\n" + table(("what", "measured", "bar"), lines)


def badness(row: Row) -> float:
    """Return how bad a clone is: surface error over its bar and lost overlap over what the bars allow."""
    lost = (1.0 - step_value("input")(row)) / 0.02 + (1.0 - step_value("held_out")(row)) / 0.05
    return step_value("surface_mean_mm")(row) / 5.0 + lost


def worst(people: Sequence[Row], folder: Path) -> str:
    """Return the worst people with their pictures, which are copied beside the page, and why they are bad."""
    lines = []
    chosen = sorted(people, key=badness, reverse=True)[:WORST]
    for number, row in enumerate(chosen, start=1):
        picture = cv2.imread(str(folder / f"{row['name']}.png"))
        place = DOCS / "pictures" / f"body_worst_{number}.png"
        if picture is not None:
            scale = min(1.0, WIDEST_PX / picture.shape[1])
            cv2.imwrite(str(place), cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA))
        figures = (("input", 3), ("held_out", 3), ("surface_mean_mm", 1))
        told = [f"{step_value(name)(row):.{digits}f}" for name, digits in figures]
        lines.append([f"{row['name']} ![]({place.relative_to(DOCS)})", *told, explain(row)])
    return (
        "## The worst five\n\nAbove: front, side, back and the held-out view; red only in the truth, blue only in the"
        " clone. Below: true and cloned surface.\n\n"
        + table(("person", "IoU input", "IoU held-out", "surface mm", "why"), lines)
    )
