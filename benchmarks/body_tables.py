"""Sections of docs/body_benchmark.md that are tables of distributions: median / 90th percentile / worst."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from body_scores import HELD_OUT, PARTS, STEPS

Row = Mapping[str, Any]
Read = Callable[[Row], float]

BACKGROUNDS: Final = ("plain", "cluttered", "low_contrast")
TIGHTNESSES: Final = ("tight", "regular", "loose")


@dataclass(frozen=True, slots=True)
class Column:
    """One column: its title, how to read the figure, its digits, and whether more is better."""

    title: str
    read: Read
    digits: int
    high: bool = False

    def cell(self, rows: Iterable[Row]) -> str:
        """Return the distribution over some rows."""
        return spread([self.read(row) for row in rows], self.digits, high=self.high)


def commits(rows: Iterable[Row]) -> str:
    """Return the versions of the product that some rows were measured with."""
    return ", ".join(sorted({str(row["commit"]) for row in rows if row.get("commit")})) or "unknown"


def spread(values: Iterable[float], digits: int, *, high: bool = False) -> str:
    """Return median, 90th percentile and worst as one cell; ``high`` says that more is better."""
    found = np.array([value for value in values if value is not None and np.isfinite(value)])
    if not len(found):
        return "-"
    numbers = (np.median(found), np.percentile(found, 10 if high else 90), found.min() if high else found.max())
    return " / ".join(f"{number:.{digits}f}" for number in numbers)


def table(head: Sequence[str], lines: Iterable[Sequence[str]]) -> str:
    """Return a table in Markdown."""
    rows = [head, ["---"] * len(head), *lines]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def table_of(columns: Sequence[Column], groups: Mapping[str, Sequence[Row]]) -> str:
    """Return a table with one line a group of rows."""
    head = ["", *(column.title for column in columns)]
    return table(head, [[name, *(column.cell(rows) for column in columns)] for name, rows in groups.items()])


def step_value(name: str, step: str = "finished") -> Read:
    """Return how to read one figure of a step from a row."""

    def read(row: Row) -> float:
        found = row["steps"][step]
        if name in ("input", "below_head"):
            overlaps = found["silhouette_iou" if name == "input" else "below_head_iou"]
            return float(np.mean([value for view, value in overlaps.items() if view != HELD_OUT]))
        if name in ("held_out", "held_out_below"):
            return float(found["silhouette_iou" if name == "held_out" else "below_head_iou"][HELD_OUT])
        return float(found[name])

    return read


def outline_value(name: str) -> Read:
    """Return how to read one figure of the outlines, the mean of the three photos."""
    return lambda row: float(np.mean([view[name] for view in row["outlines"].values()]))


def step_columns(step: str) -> tuple[Column, ...]:
    """Return the columns that tell how good a body is after a step."""
    return (
        Column("surface mean mm", step_value("surface_mean_mm", step), 2),
        Column("surface p95 mm", step_value("surface_p95_mm", step), 1),
        Column("IoU below the head, input views", step_value("below_head", step), 4, high=True),
        Column("below the head, held-out", step_value("held_out_below", step), 4, high=True),
        Column("IoU whole, input views", step_value("input", step), 4, high=True),
        Column("whole, held-out", step_value("held_out", step), 4, high=True),
    )


def steps(people: Sequence[Row]) -> str:
    """Return what every step gives."""
    lines = [[step, *(column.cell(people) for column in step_columns(step))] for step in STEPS]
    head = ["after", *(column.title for column in step_columns("fine"))]
    return (
        "## What each step gives\n\nMedian / 90th percentile / worst person. *generic*: the mean human of that stature"
        " in the fitted poses; *finished*: with head, feet and hair joined on.\n\n" + table(head, lines)
    )


def groups(people: Sequence[Row]) -> str:
    """Return the finished clone by clothes and background."""
    split = {
        f"{name} ({len(own)})": own
        for key, names in (("tightness", TIGHTNESSES), ("background", BACKGROUNDS))
        for name in names
        for own in [[row for row in people if row[key] == name]]
    }
    return (
        "## By clothes and background\n\nFinished clone, number of people; median / 90th percentile / worst.\n\n"
        + table_of(step_columns("finished"), split)
    )


def parts(people: Sequence[Row]) -> str:
    """Return where on the body the error is."""

    def cell(step: str, part: str, which: int) -> str:
        found = [row["steps"][step]["part_mm"] for row in people]
        return spread([own[part][which] for own in found if part in own], 1)

    lines = [
        [
            part,
            *(cell(step, part, 0) for step in ("generic", "phenotype", "fine", "finished")),
            cell("finished", part, 1),
        ]
        for part in PARTS
    ]
    head = ("part", "generic", "phenotype", "fine", "finished", "finished, p95 of the surface")
    return (
        "## Where the error is\n\nMean surface error by part, mm; median / 90th percentile / worst.\n\n"
        f"{table(head, lines)}\n\n{joints(people)}"
    )


def joints(people: Sequence[Row]) -> str:
    """Return how far the finished clone's joints lie from the truth's, and to which side on average."""
    lines = []
    for name in people[0]["steps"]["finished"]["joints_mm"]:
        found = [row["steps"]["finished"] for row in people]
        offsets = np.array([own["joints_off_mm"][name] for own in found if "joints_off_mm" in own]).reshape(-1, 3)
        sides = [f"{value:+.0f}" for value in np.median(offsets, axis=0)] if len(offsets) else ["-"] * 3
        lines.append([name, spread([own["joints_mm"][name] for own in found], 0), *sides])
    head = ("joint", "distance", "median offset to the left", "up", "forward")
    return "Joints of the finished clone beside the truth's after alignment, mm.\n\n" + table(head, lines)


def outlines(people: Sequence[Row]) -> str:
    """Return the outlines beside the net's mask alone."""
    columns = (
        Column("outline error px", outline_value("outline_px"), 2),
        Column("mask alone px", outline_value("mask_px"), 2),
        Column("outline p95 px", outline_value("outline_p95_px"), 1),
        Column("outline IoU", outline_value("outline_iou"), 4, high=True),
        Column("mask alone IoU", outline_value("mask_iou"), 4, high=True),
        Column("on edges", outline_value("edges_share"), 2, high=True),
    )
    split = {name: [row for row in people if row["background"] == name] for name in BACKGROUNDS}
    return (
        "## Outlines\n\nPhotos scaled to 1,800 px; mean of three photos; median / 90th percentile / worst.\n\n"
        + table_of(columns, split)
    )


def girths(people: Sequence[Row]) -> str:
    """Return the errors of the naked girths and how honest their ± is."""

    def cell(name: str, tightness: str) -> str:
        own = [row["measures"]["girths"][name] for row in people if row["tightness"] == tightness]
        if not own:
            return "-"
        errors = np.array([girth["value"] - girth["true"] for girth in own])
        inside = np.mean(np.abs(errors) <= [girth["plus_minus"] for girth in own])
        return f"{np.median(errors):+.0f}, {spread(np.abs(errors), 0)}, {100 * inside:.0f} %"

    names = people[0]["measures"]["girths"]
    return (
        "## Naked girths\n\nMedian error with its sign; size of the error (median / 90th percentile / worst), mm; how"
        " often the truth lies inside the printed ±.\n\n"
        + table(("girth", *TIGHTNESSES), [[name, *(cell(name, worn) for worn in TIGHTNESSES)] for name in names])
        + "\n\nThe clone's skin beside the dressed truth under the same tapes, median of clone minus truth, mm.\n\n"
        + table(
            ("girth", *TIGHTNESSES),
            [[name, *(too_large(people, name, worn) for worn in TIGHTNESSES)] for name in names],
        )
    )


def too_large(people: Sequence[Row], name: str, tightness: str) -> str:
    """Return how much too large the clone's skin is at one girth, with its sign."""
    own = [row["measures"]["girths"][name] for row in people if row["tightness"] == tightness]
    off = [girth["shown"] - girth["true_dressed"] for girth in own if girth["shown"] and girth["true_dressed"]]
    return f"{np.median(off):+.0f}" if off else "-"


def points(people: Sequence[Row]) -> str:
    """Return how many proposed feature points are wrong, and which."""
    wrong = Counter(name for row in people for name in row["points"]["wrong"])
    counts = [float(len(row["points"]["wrong"])) for row in people]
    proposed = [sum(len(by) for by in row["points"]["percent"].values()) for row in people]
    told = ", ".join(f"{name} {count}" for name, count in wrong.most_common(12))
    return (
        "## Feature points more than 5 % of the height away\n\n"
        f"Per person: {spread(counts, 0)} (median / 90th percentile / worst) of {np.median(proposed):.0f}."
        f" Most often: {told or 'none'}."
    )


def seconds(people: Sequence[Row]) -> str:
    """Return the profile: CPU seconds of every stage."""
    lines = [
        [name, spread([row["seconds"][name]["cpu_s"] for row in people if name in row["seconds"]], 1)]
        for name in people[0]["seconds"]
    ]
    return "## Profile\n\nCPU seconds a person; median / 90th percentile / worst.\n\n" + table(
        ("stage", "CPU s"), lines
    )


def foreign_table(rows: Sequence[Row]) -> str:
    """Return the steps on bodies from outside the family."""
    lines = [
        [row["name"], step, *(f"{column.read(row):.{column.digits}f}" for column in step_columns(step)[:4])]
        for row in rows
        for step in row["steps"]
    ]
    tapes = [
        f"{row['name']}: {name} {girth['value'] - girth['true']:+.0f} ± {girth['plus_minus']:.0f}"
        for row in rows
        for name, girth in row["measures"]["girths"].items()
    ]
    head = ("body", "after", *(column.title for column in step_columns("fine")[:4]))
    return (
        f"## A body from outside the family\n\nCommit {commits(rows)}."
        " `shared/foreign/stein_woman` (O. Stein, CC BY 4.0; not ours to ship). Its"
        " joints are unknown: the clone's pose follows its surface, which is kinder than the other tables.\n\n"
        f"{table(head, lines)}\n\nGirths, mm: {'; '.join(tapes)}."
    )
