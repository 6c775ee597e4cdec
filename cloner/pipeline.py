"""The stages with their inputs and outputs, and their execution."""

from __future__ import annotations

import hashlib
import logging
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from cloner.memory import peak_mib, release_free_memory
from cloner.parallel import as_completed
from cloner.records.results import Residual, StageResult
from cloner.stages import (
    fine,
    hair,
    head,
    join,
    measures,
    obeyed,
    phenotype,
    points,
    proposals,
    regions,
    rough,
    silhouettes,
    skeleton,
    textures,
    views,
)

log = logging.getLogger(__name__)

Progress = Callable[[str, float], None]
"""Called with a step's name and the fraction 0..1 of the whole; may raise Cancelled."""

Found = Callable[[str, Mapping[str, object]], None]
"""Called with a stage's name and all values known after it."""


@dataclass(frozen=True, slots=True)
class Stage:
    """One step of the method.

    ``run(**needs, tick=...)`` takes the named values and gives a :class:`StageResult` whose ``values`` hold exactly
    the names in ``gives``; a stage that ``draws`` takes ``rng`` as well, its own random generator.
    """

    name: str
    version: int
    needs: tuple[str, ...]
    gives: tuple[str, ...]
    run: Callable[..., StageResult]
    draws: bool = False


def taking_obeyed(run: Callable[..., StageResult]) -> Callable[..., StageResult]:
    """Return a stage's function that takes person and outlines with the corrections obeyed."""

    def run_obeyed(*, obeyed: object, obeyed_silhouettes: object, **values: object) -> StageResult:
        return run(joined=obeyed, silhouettes=obeyed_silhouettes, **values)

    return run_obeyed


#: Name, version of what it gives, needs, gives, and what runs.
STAGES: tuple[Stage, ...] = (
    Stage("proposals", 1, ("photos",), ("proposals",), proposals.run),
    Stage("points", 1, ("photos", "proposals", "corrections"), ("body_points", "face_points"), points.run),
    Stage("views", 1, ("photos", "body_points", "person"), ("views",), views.run),
    Stage("silhouettes", 1, ("photos", "proposals", "body_points"), ("silhouettes",), silhouettes.run),
    Stage(
        "phenotype", 1, ("proposals", "body_points", "silhouettes", "views", "person"), ("phenotype",), phenotype.run
    ),
    Stage("skeleton", 1, ("proposals", "silhouettes", "phenotype"), ("skeletons",), skeleton.run),
    Stage("rough", 1, ("proposals", "skeletons", "silhouettes", "phenotype"), ("rough_bodies",), rough.run),
    Stage(
        "fine",
        2,
        ("proposals", "body_points", "rough_bodies", "silhouettes", "phenotype", "person"),
        ("body",),
        fine.run,
    ),
    Stage("head", 2, ("photos", "proposals", "face_points", "silhouettes", "phenotype"), ("head",), head.run),
    Stage(
        "join",
        1,
        ("photos", "proposals", "body_points", "silhouettes", "body", "head", "phenotype"),
        ("joined",),
        join.run,
    ),
    Stage(
        "obeyed",
        1,
        ("body_points", "joined", "silhouettes"),
        ("obeyed", "obeyed_silhouettes", "obeyed_points"),
        obeyed.run,
    ),
    Stage(
        "measures",
        2,
        ("proposals", "obeyed_silhouettes", "phenotype", "body", "obeyed", "person"),
        ("measures",),
        taking_obeyed(measures.run),
    ),
    Stage("hair", 1, ("photos", "proposals", "obeyed_silhouettes", "obeyed"), ("shells",), taking_obeyed(hair.run)),
    Stage(
        "textures",
        1,
        ("photos", "proposals", "obeyed_silhouettes", "obeyed", "shells", "head"),
        ("painted", "surfaces"),
        taking_obeyed(textures.run),
        draws=True,
    ),
    Stage("regions", 1, ("painted", "surfaces"), ("clone",), regions.run),
)


@dataclass(frozen=True, slots=True)
class StageReport:
    """Time, memory, residuals and warnings of one stage.

    Attributes
    ----------
    name : str
    seconds : float
    cpu_seconds : float
        Of the whole process meanwhile: two stages that run abreast both count it.
    peak_mib : float
        Of the process so far.
    residuals : tuple of Residual
    warnings : tuple of str
    """

    name: str
    seconds: float
    cpu_seconds: float
    peak_mib: float
    residuals: tuple[Residual, ...]
    warnings: tuple[str, ...]


def stage_rng(seed: int, name: str) -> np.random.Generator:
    """Return the random generator of one stage; a new stage does not change the others'."""
    digest = hashlib.sha256(f"{seed}/{name}".encode()).digest()
    return np.random.default_rng(int.from_bytes(digest[:8], "little"))


def no_progress(step: str, fraction: float) -> None:
    """Ignore progress."""


def ignore_values(name: str, values: Mapping[str, object]) -> None:
    """Ignore what a stage produced."""


def run(
    values: Mapping[str, object],
    *,
    seed: int = 0,
    progress: Progress = no_progress,
    found: Found = ignore_values,
    stages: tuple[Stage, ...] = STAGES,
) -> tuple[dict[str, object], list[StageReport]]:
    """Run the stages, each as soon as its inputs are known, two at a time; return all values and one report a stage.

    Parameters
    ----------
    values : mapping
        At least "photos", "corrections" and "person".
    seed : int
        Project seed, from which every stage that draws derives its own generator.
    progress : callable
        Called with (stage name, fraction of the whole 0..1), by one thread at a time; may raise Cancelled.
    found : callable
        Called on this thread after every stage that ran, with its name and all values known by then.
    stages : tuple of Stage
        The stages to run; a stage whose values are all present is skipped.

    Raises
    ------
    KeyError
        If nobody gives what a stage needs. What ``progress`` or a stage raises is raised too.
    """
    known = dict(values)
    waiting = [stage for stage in stages if not all(name in known for name in stage.gives)]
    board = _Progress(progress, stages, waiting)

    def take() -> Stage | None:
        ready = next((stage for stage in waiting if all(name in known for name in stage.needs)), None)
        if ready is not None:
            waiting.remove(ready)
        return ready

    def work(stage: Stage) -> tuple[StageResult, StageReport]:
        return _run_stage(stage, {name: known[name] for name in stage.needs}, seed, board)

    reports: dict[str, StageReport] = {}
    for stage, (result, reports[stage.name]) in as_completed(work, take, board.stop):
        known.update(result.values)
        found(stage.name, known)
    if waiting:
        raise KeyError(next(name for name in waiting[0].needs if name not in known))
    progress("done", 1.0)
    return known, [reports[stage.name] for stage in stages if stage.name in reports]


class _Progress:
    """Progress of the stages, shared by their threads."""

    def __init__(self, progress: Progress, stages: Sequence[Stage], waiting: Sequence[Stage]) -> None:
        self._progress = progress
        self._parts = {stage.name: float(stage not in waiting) for stage in stages}
        self._turn = threading.Lock()
        self._error: BaseException | None = None

    def tell(self, name: str, fraction: float) -> None:
        """Record a stage's progress and report the total; raise what ended another stage."""
        with self._turn:
            if self._error is not None:
                raise self._error
            self._parts[name] = fraction
            self._progress(name, sum(self._parts.values()) / len(self._parts))

    def end(self, name: str) -> None:
        """Record that a stage has finished."""
        self._parts[name] = 1.0

    def stop(self, error: BaseException) -> None:
        """Let all stages end at their next report; the first error counts."""
        self._error = self._error or error


def _run_stage(
    stage: Stage, needs: Mapping[str, object], seed: int, board: _Progress
) -> tuple[StageResult, StageReport]:
    """Run one stage and return its values and its report."""
    wall, cpu = time.perf_counter(), time.process_time()
    try:
        board.tell(stage.name, 0.0)
        drawn = {"rng": stage_rng(seed, stage.name)} if stage.draws else {}
        result = stage.run(**needs, tick=partial(board.tell, stage.name), **drawn)
        if set(result.values) != set(stage.gives):
            raise ValueError(f"stage {stage.name} gave {sorted(result.values)}, wanted {stage.gives}")
    except BaseException as error:
        board.stop(error)
        raise
    board.end(stage.name)
    release_free_memory()
    seconds, cpu_seconds = time.perf_counter() - wall, time.process_time() - cpu
    log.info("%s: %.2f s", stage.name, seconds)
    return result, StageReport(stage.name, seconds, cpu_seconds, peak_mib(), result.residuals, result.warnings)
