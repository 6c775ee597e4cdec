"""What drags buy: ``python benchmarks/operator_effort.py [--heads 8] [--first 400] [--resume FOLDER] [--page]``.

A scripted operator takes the points in the window's order (Tab) and drags what is off its place. The truth is the
operator's eye and nothing else: a point that lies near enough (``SEEN_FACE``, ``SEEN_BODY``, ``SEEN_JOINT``) is left,
for Tab costs no drag; any other one is put on its true place. Face features and joints have known places; a point on
the outline belongs on the true outline, at the place nearest to it; head top and soles are left as they are.

The six sample sets, and random painted heads (two face photos, seeds that nothing was calibrated on): after 0, 6, 12,
20 drags and with all true features the head is fitted again and measured against the truth with the rulers of
docs/method. Every case is one JSON in the folder, so a kill loses nothing; ``--page`` turns what is there into
``docs/operator_effort.md``. Body points are dragged in their turn, but the body is not measured: outline points lie on
the outline already, and joints dragged to their true centres make the body's surface worse (6.5 -> 7.1 mm).
"""

from __future__ import annotations

import argparse
import functools
import json
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from head import write_json
from head_people import known_head
from head_scores import Ruler, ruler, score
from head_steps import BEFORE, finished, fit_head
from numpy.typing import NDArray
from operator_page import write_page

from cloner.detectors.body.body_points import ENDS
from cloner.errors import ClonerError
from cloner.evaluate.measures import rulers
from cloner.evaluate.truths.truth import SETS, TruthView, read_truth
from cloner.frames import FACE_VIEWS, ViewId
from cloner.generic.load import load_generic
from cloner.interactive.refitting import moved_points
from cloner.project.corrections import move_point, no_corrections
from cloner.records.points import Corrections, ViewPoints
from cloner.stages.points import apply_corrections, figure_height_px
from cloner.testing import folder_values, run_stages
from cloner_gui.canvas.photos.picking import worst_first
from cloner_gui.event.services import points_by_view

SAMPLES = Path(__file__).resolve().parents[1] / "samples"
DEFAULT_FOLDER = Path("/tmp/cloner_operator_effort")
DRAGS: Final = (0, 6, 12, 20)
#: Off its place by less than this a point is left: share of the eyes' distance, and of the figure's height; nobody sees
#: a joint inside a limb to less than 2 cm.
SEEN_FACE, SEEN_BODY, SEEN_JOINT = 0.02, 0.0025, 0.012

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Case:
    """Somebody's values before the head's fit, and what is true.

    Attributes
    ----------
    name : str
    values : dict
        All values of the stages before the head, as proposed.
    ruler : Ruler
    iod_px : mapping of ViewId to float
        True eye distance in each face photo, px.
    place : callable
        Takes a view, a point's name and where it lies, (2,) px; gives its true place, or None where it is left.
    """

    name: str
    values: dict[str, Any]
    ruler: Ruler
    iod_px: Mapping[ViewId, float]
    place: Callable[[ViewId, str, Array], Array | None]


def sample(visitor: str, set_name: str) -> Case:
    """Return one set of a sample visitor."""
    folder, truth = SAMPLES / visitor / set_name, read_truth(SAMPLES / visitor, set_name)
    values, _ = run_stages(folder_values(folder), BEFORE)
    eyes = {view: eyes_px(truth.views[view.value]) for view in FACE_VIEWS}
    return Case(f"{visitor} {set_name}", values, ruler(truth.surface), eyes,
                lambda view, name, placed: true_place(truth.views[view.value], name, placed))  # fmt: skip


def random_head(seed: int) -> Case:
    """Return one random painted head, every second one bent out of the generic's family."""
    known = known_head(seed, bent=bool(seed % 2))
    marks = known.truth.marks_m
    left, right = marks["pupil_L"], marks["pupil_R"]
    away = float(np.linalg.norm(left - right))
    eyes = {view: away / camera.metres_per_pixel((left + right) / 2) for view, camera in known.views.items()}

    def place(view: ViewId, name: str, placed: Array) -> Array | None:
        return known.views[view].project(marks[name][None])[0] if name in marks else None

    return Case(f"head {seed}", fit_head(known)[0], ruler(known.truth), eyes, place)


def true_place(truth: TruthView, name: str, placed_px: Array) -> Array | None:
    """Return where an operator would put a point, (2,) px; None where they would leave it."""
    if name in truth.marks_px:
        return truth.marks_px[name]
    joint = f"{name[2:]}_{name[0].upper()}" if name.startswith(("l_", "r_")) else ""
    if joint in truth.joints_m:
        return np.asarray(truth.camera.project(truth.joints_m[joint][None])[0])
    if name in ENDS or joint or name not in load_generic().feature_names:
        return None
    rows, columns = np.nonzero(rulers.boundary(truth.mask))
    border = np.column_stack([columns, rows]).astype(np.float64)
    return np.asarray(border[np.argmin(np.linalg.norm(border - placed_px, axis=1))])


def eyes_px(truth: TruthView) -> float:
    """Return the true distance of the pupils at their depth, px."""
    left, right = truth.points_m["pupil_L"], truth.points_m["pupil_R"]
    return float(np.linalg.norm(left - right)) / truth.camera.metres_per_pixel((left + right) / 2)


def seen_px(case: Case, points: ViewPoints, name: str) -> float:
    """Return how far off a point must lie for the operator to see it, px."""
    if points.view.is_face:
        return SEEN_FACE * case.iod_px[points.view]
    return (SEEN_JOINT if name.startswith(("l_", "r_")) else SEEN_BODY) * figure_height_px(points)


def drags(case: Case) -> Iterator[tuple[Corrections, str]]:
    """Yield the corrections after each of the operator's drags, and what was dragged; none first.

    Every point is seen as it lies by then, taught by those before it.
    """
    photos, corrections = case.values["photos"], no_corrections()
    proposed = points_by_view(case.values, photos)
    yield corrections, ""
    for view, name in worst_first(proposed):
        points = apply_corrections(proposed[view], corrections.points.get(view, {}), photos.photos[view])
        placed = points.points_px[points.names.index(name)]
        place = case.place(view, name, placed)
        if place is not None and np.linalg.norm(place - placed) > seen_px(case, proposed[view], name):
            corrections = move_point(corrections, view, name, float(place[0]), float(place[1]), "")
            yield corrections, f"{view} {name}"


def figures(case: Case, corrections: Corrections) -> dict[str, float]:
    """Return the metrics of the head after some drags, mm, and of the face photos' points, % of the eyes' distance."""
    _, face = moved_points(case.values, corrections)
    vertices, *_ = finished({**case.values, "face_points": face})
    found = score(vertices, case.ruler, load_generic())
    errors = [
        100.0 * float(np.linalg.norm(place - at)) / case.iod_px[view]
        for view, points in face.views.items()
        if view.is_face
        for name, at in zip(points.names, points.points_px, strict=True)
        if (place := case.place(view, name, at)) is not None
    ]
    return {
        "landmarks": found["landmarks_mean_mm"],
        "landmarks, size free": found["landmarks_free_mm"],
        "surface, similarity": found["similarity_mm"],
        "surface, rigid": found["rigid_mm"],
        "points": float(np.mean(errors)),
    }


def worked(case: Case) -> dict[str, Any]:
    """Return what the operator's drags do to one case."""
    states = list(drags(case))
    last = len(states) - 1
    rows = {str(count): figures(case, states[count][0]) for count in DRAGS if count < last}
    rows["all"] = figures(case, states[last][0])
    return {"name": case.name, "wanted": last, "dragged": [what for _, what in states[1:]], "rows": rows}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sets", nargs="*", help="VISITOR/SET, all samples by default")
    parser.add_argument("--heads", type=int, default=0, help="random heads to try")
    parser.add_argument("--first", type=int, default=400, metavar="SEED")
    parser.add_argument("--resume", type=Path, default=DEFAULT_FOLDER, metavar="FOLDER", help="where the results lie")
    parser.add_argument("--page", action="store_true", help="write docs/operator_effort.md")
    chosen = parser.parse_args()
    wanted = chosen.sets or [f"{visitor}/{name}" for visitor in ("anna", "boris") for name in SETS]
    todo: dict[str, Callable[[], Case]] = {
        one.replace("/", " "): functools.partial(sample, *one.split("/")) for one in wanted
    }
    seeds = range(chosen.first, chosen.first + chosen.heads)
    todo |= {f"head {seed}": functools.partial(random_head, seed) for seed in seeds}
    for name, make in todo.items():
        path = chosen.resume / f"{name.replace(' ', '_')}.json"
        if path.exists():
            continue
        try:
            row = worked(make())
        except ClonerError as error:  # a refused photo is no reason to stop
            row = {"name": name, "error": f"{error.message} ({error.where})"}
        write_json(path, row)
        sys.stdout.write(f"{name}: {json.dumps(row.get('rows', row))}\n")
        sys.stdout.flush()
    if chosen.page:
        sys.stdout.write(f"{write_page(chosen.resume)}\n")


if __name__ == "__main__":
    main()
