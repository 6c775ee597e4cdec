"""How good is the body? ``python benchmarks/body.py --people 60 [--jobs 2] [--resume FOLDER] [--page]``.

Random people of known shape (``generic_models/build/painted_people.py``) are photographed, cloned by the product's
own stages and scored after every step with the rulers of docs/method. Every finished person is one JSON and one picture
in the folder, so a kill loses nothing; ``--page`` turns what is there into ``docs/body_benchmark.md``.
``--foreign FOLDER`` scores a body from outside the family (shared/foreign/stein_woman; not ours to ship). What each
step is worth: ``benchmarks/ablation.py``.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import sys
import traceback
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor, as_completed
from functools import partial
from pathlib import Path
from typing import Any

from body_foreign import score_foreign
from body_page import write_page
from body_people import Case, cases, painted_case, write_json

DEFAULT_FOLDER = Path("/tmp/cloner_body_benchmark")


def guarded(work: Callable[[], Any], path: Path) -> dict[str, Any]:
    """Return a row, or what went wrong: one person must not end the run of all."""
    try:
        return dict(work())
    except Exception:  # noqa: BLE001 - the batch loop tells it and goes on
        row = {"name": path.stem, "error": traceback.format_exc()}
        write_json(path.with_suffix(".error.json"), row)
        return row


def one_person(case: Case, folder: Path) -> dict[str, Any]:
    """Score one random person; see :func:`painted_case`."""
    return guarded(partial(painted_case, case, folder), folder / f"{case.name}.json")


def run_all(work: Callable[[Case, Path], dict[str, Any]], todo: Iterable[Case], folder: Path, jobs: int) -> None:
    """Run the people left to do, some at a time, telling each on one line."""
    with ProcessPoolExecutor(jobs, mp_context=multiprocessing.get_context("spawn")) as pool:
        for done in as_completed([pool.submit(work, case, folder) for case in todo]):
            row = done.result()
            sys.stdout.write(f"{row['name']}: {told(row)}\n")
            sys.stdout.flush()


def told(row: dict[str, Any]) -> str:
    """Return one line about a finished person."""
    if "error" in row:
        return str(row["error"]).strip().splitlines()[-1]
    last = row["steps"]["finished"]
    overlaps = " ".join(f"{value:.3f}" for value in last["silhouette_iou"].values())
    return (
        f"IoU {overlaps}  surface {last['surface_mean_mm']:.1f}/{last['surface_p95_mm']:.1f} mm  {row['wall_s']:.0f} s"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--people", type=int, default=0, help="random people to have in the folder at the end")
    parser.add_argument("--first", type=int, default=1000, metavar="SEED")
    parser.add_argument("--foreign", type=Path, default=None, metavar="FOLDER")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--resume", type=Path, default=DEFAULT_FOLDER, metavar="FOLDER", help="where the results lie")
    parser.add_argument("--page", action="store_true", help="write docs/body_benchmark.md and its pictures")
    chosen = parser.parse_args()
    folder: Path = chosen.resume
    todo = [case for case in cases(chosen.people, chosen.first) if not (folder / f"{case.name}.json").exists()]
    run_all(one_person, todo, folder, chosen.jobs)
    if chosen.foreign is not None:
        for name in ("input", "input_clutter"):
            row = score_foreign(chosen.foreign, name)
            write_json(folder / f"foreign_{chosen.foreign.name}_{name}.json", row)
            sys.stdout.write(f"{row['name']}: {told({'wall_s': 0.0, **row})}\n")
    if chosen.page:
        rows = [json.loads(path.read_text()) for path in sorted(folder.glob("*.json"))]
        sys.stdout.write(f"{write_page(rows, folder)}\n")


if __name__ == "__main__":
    main()
