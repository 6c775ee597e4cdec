"""People of the generator cloned and judged: a page with figures, refusals and warnings, and a sheet to look at.

    python benchmarks/people.py DIR --count 12 --workers 1

DIR holds people as the generator writes them (with held-out views). Every person is cloned and scored in a process of
its own and kept as a file; what is kept is not made again, so that a run can be stopped and continued.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import subprocess
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any, Final

import numpy as np
from PIL import Image, ImageDraw

from cloner.evaluate.kit_scores import clone_person, score_person
from cloner.evaluate.measuring import CloneRun
from cloner.evaluate.rows import Row
from cloner.evaluate.truths.kit import kit_people
from cloner.project.clone_file import CLONE_FILE, load_clone
from cloner.records.labels import LABELS

ROOT: Final = Path(__file__).resolve().parents[1]
PAGE: Final = ROOT / "docs" / "people_benchmark.md"
SHEET: Final = ROOT / "docs" / "pictures" / "people.jpg"
#: What stands in the table, with its unit and whether less is better.
FIGURES: Final = (
    ("face_surface_similarity_mm", "mm", True),
    ("face_landmarks_mean_mm", "mm", True),
    ("silhouette_iou", "", False),
    ("outline_iou", "", False),
    ("joints_mean_mm", "mm", True),
    ("ssim", "", False),
    ("delta_e", "dE00", True),
    ("wrong_part_texels", "%", True),
    ("girth_chest_error_mm", "mm", True),
    ("girth_waist_error_mm", "mm", True),
    ("girth_hip_error_mm", "mm", True),
    ("girth_neck_error_mm", "mm", True),
    ("cpu_seconds", "s", True),
)
BARS: Final = {"hair": 0.86, "body_skin": 0.90, "face_skin": 0.90, "upper_clothes": 0.92}
ROW_PX: Final = 420
SHOWN: Final = ("beside_body_front", "beside_body_side", "beside_body_back", "beside_face_front", "beside_face_side")
PEOPLE_A_SHEET: Final = 12
WORST: Final = 12


def judge(person: Path, keep: Path, before: Path) -> dict[str, Any]:
    """Clone and score one person beside the clone of the one before, keep what was found and return it."""
    kept = keep / f"{person.name}.json"
    if kept.is_file():
        return dict(json.loads(kept.read_text()))
    told: list[str] = []
    run: CloneRun | None = None
    try:
        run = clone_person(person, keep / "clones", told.append)
        other = keep / "clones" / before.name / CLONE_FILE
        beside = load_clone(other) if other.is_file() and before != person else None
        rows = score_person(person, run, beside, keep / "clones")
    except Exception as error:  # noqa: BLE001 a defect of one person must not end the night
        told.append(f"{person.name}: DEFECT {type(error).__name__}: {error}")
        rows = score_person(person, None, None, None)
    found = {"name": person.name, "rows": rows, "told": told, "looks": looks(person), "commit": commit()}
    keep.mkdir(parents=True, exist_ok=True)
    kept.write_text(json.dumps(found))
    return found


def looks(person: Path) -> str:
    """Return what a person looks like, in a few words of the generator."""
    drawn = json.loads((person / "truth.json").read_text())["person"]
    hair, outfit = drawn["hair"], drawn["outfit"]
    suit = outfit.get("kind") or outfit.get("suit", {}).get("name", "")
    style = " ".join(filter(None, (hair["style"], str(hair.get("asset", "")))))
    words = [drawn["sex"], f"{drawn['age_years']:.0f}", drawn["tone"], style, suit, *drawn.get("acc", {})]
    beard = drawn["beard"]["kind"]
    return ", ".join([*words, *([f"beard {beard}"] if beard != "none" else [])])


def commit() -> str:
    """Return the commit that judged."""
    asked = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True)
    return asked.stdout.strip()


def rows_named(people: Iterable[Mapping[str, Any]], metric: str) -> list[Row]:
    """Return all rows of a metric that have a value."""
    return [r for one in people for r in one["rows"] if r["metric"] == metric and r["value"] is not None]


def page(people: Sequence[Mapping[str, Any]]) -> str:
    """Return the page."""
    cloned = {one["name"]: one["rows"][0]["value"] > 0 for one in people}
    commits = ", ".join(sorted({one["commit"] for one in people}))
    lines = [
        "# People of the generator, cloned",
        "",
        f"{len(people)} people ({people[0]['name']} to {people[-1]['name']}) of whom nothing was learned, five "
        f"photographs each; {sum(cloned.values())} cloned, {len(people) - sum(cloned.values())} refused. Made by "
        f"`python benchmarks/people.py DIR --count {len(people)}` at {commits}; nobody corrected a point.",
        "",
        "![photographs beside their clones](pictures/people.jpg)",
        "",
        *figures_table(people),
        "",
        *held_out(people),
        "",
        *labels_table(people),
        "",
        *refusals(people, cloned),
        "",
        *worst(people),
    ]
    return "\n".join(lines) + "\n"


def figures_table(people: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return mean, median and worst of the figures beside the baselines' means."""
    out = [
        "| figure | view | mean | median | worst | generic | another's |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]
    for metric, unit, less in FIGURES:
        by_view: dict[str, list[Row]] = defaultdict(list)
        for row in rows_named(people, metric):
            by_view[row["view"] or "-"].append(row)
        for view, rows in by_view.items():
            values = np.array([row["value"] for row in rows])
            worst_value = values.max() if less else values.min()
            beside = [mean_of(rows, column) for column in ("generic", "other")]
            numbers = " | ".join(f"{x:.3g}" for x in (values.mean(), np.median(values), worst_value))
            out.append(f"| {metric} {unit} | {view} | {numbers} | {beside[0]} | {beside[1]} |")
    return out


def mean_of(rows: Sequence[Row], column: str) -> str:
    """Return the mean of a baseline, or a dash."""
    values = [row[column] for row in rows if row[column] is not None]
    return f"{np.mean(values):.3g}" if values else "-"


def held_out(people: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return how many people beat both baselines in views no clone saw."""
    out = []
    for metric, sign in (("ssim", 1.0), ("delta_e", -1.0)):
        rows = [r for r in rows_named(people, metric) if r["generic"] is not None]
        won = [all(sign * r["value"] > sign * r[c] for c in ("generic", "other") if r[c] is not None) for r in rows]
        out.append(f"Held-out views whose {metric} beats both baselines: {sum(won)} of {len(won)}.")
    return out


def labels_table(people: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return label IoU a view and label."""
    by: dict[tuple[str, str], list[float]] = defaultdict(list)
    for row in rows_named(people, "label_iou"):
        view, label = row["view"].split("/")
        by[view, label].append(row["value"])
    views = sorted({view for view, _ in by})
    out = [f"| label IoU | {' | '.join(views)} | bar |", "| --- |" + " --- |" * (len(views) + 1)]
    for label in LABELS:
        cells = [
            f"{np.mean(by[view, label]):.2f} ({len(by[view, label])})" if by[view, label] else "-" for view in views
        ]
        out.append(f"| {label} | {' | '.join(cells)} | {BARS.get(label, '')} |")
    every = [value for values in by.values() for value in values]
    return [*out, "", f"Mean of all: {np.mean(every):.3f}." if every else ""]


def refusals(people: Sequence[Mapping[str, Any]], cloned: Mapping[str, bool]) -> list[str]:
    """Return who was refused, and every warning with how often it was told."""
    out = ["## Refused", ""]
    out += [f"- {'; '.join(one['told'])} ({one['looks']})" for one in people if not cloned[one["name"]]] or ["nobody"]
    counted: dict[str, int] = defaultdict(int)
    for one in people:
        for sentence in one["told"] if cloned[one["name"]] else ():
            counted[sentence.partition(": ")[2]] += 1
    out += ["", "## Warnings", ""]
    return out + [f"- {count} x {text}" for text, count in sorted(counted.items(), key=lambda item: -item[1])]


def worst(people: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the people whose input silhouettes or held-out face fit worst."""
    scored = []
    for one in people:
        seen = [r["value"] for r in one["rows"] if r["metric"] == "silhouette_iou" and r["value"] is not None]
        face = [r["value"] for r in one["rows"] if r["metric"] == "ssim" and str(r["view"]).startswith("face")]
        if seen:
            scored.append((min(seen), min(face, default=0.0), one))
    out = ["## Worst", "", "| person | lowest silhouette IoU | held-out face SSIM | who |", "| --- | --- | --- | --- |"]
    scored.sort(key=lambda item: item[0] + item[1])
    return out + [f"| {o['name']} | {iou:.3f} | {face:.3f} | {o['looks']} |" for iou, face, o in scored[:WORST]]


def sheet(people: Sequence[Mapping[str, Any]], keep: Path) -> Image.Image | None:
    """Return photographs beside clones, a person a row."""
    rows = []
    for one in people:
        folder = keep / "clones" / one["name"]
        pictures = [folder / "previews" / f"{name}.jpg" for name in SHOWN]
        pictures = [path for path in pictures if path.is_file()] or list(folder.rglob("beside_*.jpg"))
        if not pictures:
            continue
        drawn = [fitted(Image.open(path)) for path in pictures]
        drawn += [fitted(first_half(Image.open(path))) for path in sorted(folder.glob("held_out_*.jpg"))]
        row = Image.new("RGB", (sum(p.width for p in drawn), ROW_PX + 16), "white")
        left = 0
        for picture in drawn:
            row.paste(picture, (left, 16))
            left += picture.width
        ImageDraw.Draw(row).text((4, 2), f"{one['name']}: {one['looks']}", fill="black")
        rows.append(row)
    if not rows:
        return None
    whole = Image.new("RGB", (max(row.width for row in rows), sum(row.height for row in rows)), "white")
    top = 0
    for row in rows:
        whole.paste(row, (0, top))
        top += row.height
    return whole


def fitted(picture: Image.Image) -> Image.Image:
    """Return a picture of the row's height."""
    return picture.convert("RGB").resize((round(picture.width * ROW_PX / picture.height), ROW_PX))


def first_half(strip: Image.Image) -> Image.Image:
    """Return photo and clone of a held-out strip: photo, clone, generic and other, all of one width."""
    width = strip.height * 2 // 3 if strip.width % (strip.height * 2 // 3) == 0 else strip.height * 3 // 4
    return strip.crop((0, 0, 2 * width, strip.height))


def main() -> None:
    """Judge people and write the page."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("people", type=Path)
    asked.add_argument("--count", type=int, default=100)
    asked.add_argument("--workers", type=int, default=1)
    asked.add_argument("--keep", type=Path, default=ROOT / "build" / "people")
    asked.add_argument("--write", action="store_true", help="write the page and the sheet into docs")
    given = asked.parse_args()
    chosen = kit_people([given.people])[: given.count]
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(given.workers, mp_context=context, max_tasks_per_child=1) as pool:
        jobs = [pool.submit(judge, person, given.keep, chosen[row - 1]) for row, person in enumerate(chosen)]
        for person, job in zip(chosen, jobs, strict=True):
            told = job.result()["told"]
            print(person.name, "; ".join(told) or "ok", flush=True)
    people = [judge(person, given.keep, person) for person in chosen]
    print(page(people))
    if given.write:
        PAGE.write_text(page(people))
        picture = sheet(people[:PEOPLE_A_SHEET], given.keep)
        if picture is not None:
            picture.save(SHEET, quality=80)


if __name__ == "__main__":
    main()
