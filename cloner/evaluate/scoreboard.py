"""Cloning and scoring of visitors with known truth: one row per figure, beside two baselines."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.evaluate.kit_scores import evaluate_people
from cloner.evaluate.measuring import CloneRun, clone_in_process
from cloner.evaluate.rows import Row, rows_of, save_held_out
from cloner.evaluate.scores import Score, score_run, score_subject
from cloner.evaluate.truths.baselines import generic_clone
from cloner.evaluate.truths.kit import is_kit_person, kit_people
from cloner.evaluate.truths.truth import SETS, given_height_m, read_truth
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.project.atomic import write_text
from cloner.records.clones import Clone

Progress = Callable[[str, float], None]


def evaluate_visitors(
    paths: Sequence[Path],
    sets: Sequence[str] = SETS,
    out: Path | None = None,
    *,
    shown: Collection[ViewId] = tuple(ViewId),
    progress: Progress = lambda what, fraction: None,
    report: Callable[[str], None] = lambda sentence: None,
    seed: int = 0,
) -> list[Row]:
    """Clone visitors from their photos alone, then score the clones against the truth.

    Parameters
    ----------
    paths : sequence of Path
        Folders laid out like ``samples/anna``, people of the generator of synthetic people, or folders of such people.
    sets : sequence of str
        Sets of photos to clone: plain, booth, handheld. A set that a visitor
        lacks is left out.
    out : Path or None
        Folder for the clones as ``cloner clone`` writes them, ``scoreboard.json``
        and the held-out pictures: photo, clone, generic and other side by side.
        None keeps nothing.
    shown : collection of ViewId
        Photos to clone generated people from; those kept back are scored too. The samples keep all of theirs.
    progress : callable
        Called with what is done now and the fraction of the whole, 0..1.
    report : callable
        Called with a sentence for every person of the generator who was refused, and every warning.
    seed : int
        For the samples drawn on surfaces.

    Returns
    -------
    list of dict
        One row a figure: visitor, set, view (None for the whole clone),
        metric, value, unit, generic, other.

    Raises
    ------
    ClonerError
        If a folder is no visitor, or a clone fails.
    """
    people = kit_people(paths)
    paths = [path for path in paths if (path / "truth.json").is_file() and not is_kit_person(path)] if people else paths
    rows: list[Row] = evaluate_people(people, out, shown=shown, progress=progress, report=report) if people else []
    rows += _evaluate_sets(paths, sets, out, progress, seed) if paths or not people else []
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
        write_text(out / "scoreboard.json", json.dumps(rows, indent=1) + "\n")
    progress("done", 1.0)
    return rows


def _evaluate_sets(
    paths: Sequence[Path], sets: Sequence[str], out: Path | None, progress: Progress, seed: int
) -> list[Row]:
    """Return the rows of visitors laid out like the samples."""
    jobs = [(path, name) for path in paths for name in sets if (path / name).is_dir()]
    if not jobs:
        raise ClonerError("there is nothing to evaluate", "Give folders laid out like samples/anna", "evaluate")
    runs: dict[tuple[Path, str], CloneRun] = {}
    others = {path: _other(path, paths) for path in paths}
    compared = [(other, name) for path, name in jobs if (other := others[path]) is not None and (other / name).is_dir()]
    needed = list(dict.fromkeys([*jobs, *compared]))
    steps = len(needed) + len(jobs)
    for done, (path, name) in enumerate(needed):
        progress(f"clone {path.name} {name}", done / steps)
        with _clone_folder(out, path.name) as folder:
            runs[path, name] = clone_in_process(path / name, given_height_m(path), folder)
    rows: list[Row] = []
    for done, (path, name) in enumerate(jobs, start=len(needed)):
        progress(f"score {path.name} {name}", done / steps)
        beside = others[path]
        near = None if beside is None else runs.get((beside, name))
        rows += _score_set(path, name, runs[path, name], None if near is None else near.clone, out, seed)
    return rows


def format_table(rows: Sequence[Row]) -> str:
    """Return the rows as a text table, one line each, baselines in the last two columns."""
    head = ("visitor", "set", "view", "metric", "value", "generic", "other", "unit")
    lines = [tuple(_cell(row[name]) for name in head) for row in rows]
    widths = [max(len(line[k]) for line in [head, *lines]) for k in range(len(head))]
    right = {"value", "generic", "other"}
    return "\n".join(
        "  ".join(
            text.rjust(width) if name in right else text.ljust(width)
            for name, text, width in zip(head, line, widths, strict=True)
        ).rstrip()
        for line in [head, *lines]
    )


def _cell(value: object) -> str:
    if value is None:
        return "-"
    return f"{value:.3f}" if isinstance(value, float) else str(value)


@contextmanager
def _clone_folder(out: Path | None, visitor: str) -> Iterator[Path]:
    """Give the folder that receives a visitor's clones; a temporary one when nothing is kept."""
    if out is not None:
        yield out / visitor
        return
    with tempfile.TemporaryDirectory(prefix="cloner-evaluate-") as folder:
        yield Path(folder)


def _other(path: Path, paths: Sequence[Path]) -> Path | None:
    """Return the visitor to compare with: the next of the call, or a neighbour folder with a truth."""
    if len(paths) > 1:
        return paths[(list(paths).index(path) + 1) % len(paths)]
    place = path.resolve()
    near = sorted(folder for folder in place.parent.iterdir() if (folder / "truth.json").is_file() and folder != place)
    return near[0] if near else None


def _score_set(path: Path, set_name: str, run: CloneRun, other: Clone | None, out: Path | None, seed: int) -> list[Row]:
    """Return all rows of one visitor in one set; the truth is first read here, the clone exists."""
    truth, generic = read_truth(path, set_name), load_generic()
    subjects = {"value": run.clone, "generic": generic_clone(generic, truth.stature_m), "other": other}
    pictures: dict[str, list[NDArray[np.uint8]]] = {}
    figures: dict[str, dict[tuple[str, str], Score]] = {}
    for column, subject in subjects.items():
        if subject is None:
            continue
        rng = np.random.default_rng(seed)
        scores = score_subject(
            subject, run.clone, generic, truth,
            rng=rng,
            keep=lambda view, p: pictures.setdefault(view, []).append(p),
            measures=run.measures if column == "value" else None,
        )  # fmt: skip
        figures[column] = {(score.metric, score.view): score for score in scores}
    own = [*score_run(run, truth), *figures["value"].values()]
    if out is not None:
        save_held_out(out / path.name / set_name, truth, pictures)
    return rows_of(path.name, set_name, own, figures)
