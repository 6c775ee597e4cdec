"""Score the sample visitors in all sets and write docs/scoreboard.md: bars, rows lost to a baseline, all figures.

``python benchmarks/scoreboard.py`` clones and scores (ten minutes on two cores); with ``--rows FOLDER`` it reads what
``cloner evaluate samples/anna samples/boris --out FOLDER`` left.
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import platform
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from cloner.evaluate import evaluate_visitors
from cloner.frames import ViewId
from cloner.project.clone_file import load_clone
from cloner.terminal import ProgressLine

ROOT = Path(__file__).resolve().parents[1]
Row = dict[str, Any]
#: Larger is better; of everything else less is.
MORE = ("outline_iou", "silhouette_iou", "ssim", "region_agreement")
#: Bars: metric and its largest value. Silhouettes have theirs below.
BARS = (
    ("stature_error_mm", 5.0), ("seconds", 60.0), ("peak_mib", 1536.0), ("reprojected_percent_iod", 3.0),
    ("seam_front_back_ratio", 1.3), ("seam_head_body_ratio", 1.3), ("background_texels", 0.0),
)  # fmt: skip


def reprojected(folder: Path) -> float | None:
    """Return how far the finished clone's landmarks fall from the proposed ones in the front face photo, % of IOD."""
    clone, report = load_clone(folder / "clone.npz"), json.loads((folder / "report.json").read_text())
    seen = clone.views.get(ViewId.FACE_FRONT)
    proposed = report["features"].get("face_front", {})
    names = [name for name in proposed if name in clone.features_m and not name.startswith("head_top")]
    if seen is None or not names:
        return None
    own = seen.camera.project(np.array([clone.features_m[name] for name in names]))
    goal = np.array([[proposed[name]["x_px"], proposed[name]["y_px"]] for name in names])
    pupils = [goal[names.index(f"pupil_{side}")] for side in "LR"]
    return float(100 * np.linalg.norm(own - goal, axis=1).mean() / np.linalg.norm(pupils[0] - pupils[1]))


def least_overlap(row: Row) -> float:
    """Return the issue's bar for a silhouette row."""
    held_out = "three_quarter" in (row["view"] or "")
    return 0.90 if held_out or row["set"] == "handheld" else 0.94


def missed(rows: list[Row]) -> Iterator[str]:
    """Yield a line for every figure below its bar."""
    for row in rows:
        where = f"{row['visitor']} {row['set']} {row['view'] or ''}".strip()
        if row["metric"] == "silhouette_iou" and row["value"] is not None and row["value"] < least_overlap(row):
            yield f"{where}: silhouette IoU {row['value']:.3f}, wanted {least_overlap(row):.2f}"
        for metric, limit in BARS:
            if row["metric"] == metric and row["value"] is not None and row["value"] > limit:
                yield f"{where}: {metric} {row['value']:.1f}, wanted at most {limit:g}"


def lost(rows: list[Row]) -> Iterator[str]:
    """Yield a line for every figure that a baseline reaches or beats."""
    for row in rows:
        sign = 1.0 if row["metric"] in MORE else -1.0
        for name in ("generic", "other"):
            if row["value"] is not None and row[name] is not None and sign * row["value"] <= sign * row[name]:
                where = f"{row['visitor']} {row['set']} {row['view'] or ''}".strip()
                yield f"{where}: {row['metric']} {_number(row['value'])}, {name} {_number(row[name])}"


def girth_means(rows: list[Row]) -> str:
    """Return the mean girth error of the clone and both baselines, in words."""
    girths = [row for row in rows if row["metric"].startswith("girth_")]
    each = {
        label: [row[name] for row in girths if row[name] is not None]
        for label, name in (("clone", "value"), ("generic human", "generic"), ("other visitor", "other"))
    }
    return ", ".join(f"{label} {np.mean(errors):.0f} mm" for label, errors in each.items() if errors) or "none measured"


def page(rows: list[Row], command: str, seconds: float) -> str:
    """Return the scoreboard as Markdown."""
    runs = list(dict.fromkeys((row["visitor"], row["set"]) for row in rows))
    cells: dict[tuple[str, str], dict[tuple[str, str], str]] = {}
    for row in rows:
        cell = _number(row["value"])
        if row["generic"] is not None or row["other"] is not None:
            cell += f" ({_number(row['generic'])}, {_number(row['other'])})"
        cells.setdefault((row["metric"], row["view"] or ""), {})[row["visitor"], row["set"]] = cell
    compared = [row for row in rows if row["value"] is not None and (row["generic"], row["other"]) != (None, None)]
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True).stdout
    misses, losses = list(missed(rows)), list(lost(rows))
    lines = [
        "# Scoreboard",
        "",
        f"{datetime.datetime.now(datetime.UTC):%Y-%m-%d %H:%M} UTC, commit {commit.strip()}, {_machine()}.",
        f"`{command}`, {seconds:.0f} s for the clones. Written by `benchmarks/scoreboard.py`.",
        "A cell is the clone's figure; in brackets the generic human's and the other visitor's clone's.",
        "",
        "## Bars that are missed",
        "",
        *([f"- {line}" for line in misses] or ["None."]),
        "",
        f"## Rows where a baseline is as good or better ({len(losses)} comparisons in {len(compared)} rows)",
        "",
        *([f"- {line}" for line in losses] or ["None."]),
        "",
        f"All girths together, mean error: {girth_means(rows)}.",
        "",
        "## All figures",
        "",
        "| metric | view | " + " | ".join(f"{visitor} {name}" for visitor, name in runs) + " |",
        "| --- | --- |" + " --- |" * len(runs),
    ]
    for (metric, view), values in cells.items():
        lines.append(f"| {metric} | {view} | " + " | ".join(values.get(run, "-") for run in runs) + " |")
    return "\n".join(lines) + "\n"


def _number(value: float | None) -> str:
    if value is None:
        return "-"
    return f"{value:.3f}" if abs(value) < 10 else f"{value:.1f}"


def _machine() -> str:
    info = Path("/proc/cpuinfo")
    named = [line.split(":")[1].strip() for line in info.read_text().splitlines() if line.startswith("model name")]
    return f"{(named or [platform.processor()])[0]}, {os.cpu_count()} cores, Python {platform.python_version()}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", type=Path, help="folder that `cloner evaluate --out` left")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "scoreboard.md")
    chosen = parser.parse_args()
    command = "cloner evaluate samples/anna samples/boris"
    with tempfile.TemporaryDirectory(prefix="cloner-scoreboard-") as scratch:
        folder = chosen.rows or Path(scratch)
        if chosen.rows is None:
            with ProgressLine() as progress:
                evaluate_visitors(
                    [ROOT / "samples" / name for name in ("anna", "boris")], out=folder, progress=progress
                )
        rows = json.loads((folder / "scoreboard.json").read_text())
        for visitor, name in dict.fromkeys((row["visitor"], row["set"]) for row in rows):
            value = reprojected(folder / visitor / name)
            extra = {"visitor": visitor, "set": name, "view": "face_front", "metric": "reprojected_percent_iod"}
            rows.append({**extra, "value": value, "unit": "%", "generic": None, "other": None})
    seconds = sum(row["value"] for row in rows if row["metric"] == "seconds")
    chosen.out.write_text(page(rows, command, seconds), encoding="utf-8")
    print(chosen.out)


if __name__ == "__main__":
    main()
