"""What drags buy: a scripted operator takes the points worst first, as Tab does, and drags what is off its place.

The truth is the operator's eye and nothing else: a point that lies near enough (``SEEN_FACE``, ``SEEN_BODY``,
``SEEN_JOINT``) is left, for Tab costs no drag; any other one is put on its true place. Face features and joints have
known places; a point on the outline belongs on the true outline, at the place nearest to it; head top and soles are
left as they are.

After 0, 3, 6, 9 and 12 drags, and with all true features, the person is fitted again (no hair, no textures) and
measured against the truth. Printed, a line a set: face landmarks and face surface in 3-D (mm), body surface (mm), mean
error of the face photos' points (% of the eyes' distance), and the share of the way from the proposals to the true
features that 12 drags went. Bar: true-feature accuracy (nine tenths of that way, or within 0.1 mm) after 12 drags.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cloner import pipeline
from cloner.evaluate import rulers, skins
from cloner.evaluate.baselines import generic_clone
from cloner.evaluate.posing import LANDMARKS, landmarks, pose_clone, rotations_towards, truth_from_body
from cloner.evaluate.truth import SETS, Truth, TruthView, read_truth
from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import load_generic
from cloner.project.corrections import move_point, no_corrections
from cloner.project.folder import load_photos, read_person
from cloner.records.photos import PhotoSet
from cloner.records.points import Corrections, ViewPoints
from cloner.refitting import still_true
from cloner.stages.points import ENDS, corrected, figure_height_px
from cloner_gui.canvas.picking import worst_first
from cloner_gui.services import points_by_view

SAMPLES = Path(__file__).resolve().parents[1] / "samples"
DRAGS = (0, 3, 6, 9, 12)
#: Off its place by less than this a point is left: share of the eyes' distance, and of the figure's height; nobody sees
#: a joint inside a limb to less than 2 cm.
SEEN_FACE, SEEN_BODY, SEEN_JOINT = 0.02, 0.0025, 0.012
LAST_STAGE = "obeyed"
#: Metrics of a person, all in mm, and of the points.
METRICS = ("landmarks", "face", "body", "points")
#: Share of the way to the true features, and rest of it in mm, that count as there.
ENOUGH, NEAR_MM = 0.9, 0.1


def true_place(truth: TruthView, name: str, placed_px: NDArray[np.float64]) -> NDArray[np.float64] | None:
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


def seen_px(truth: TruthView, points: ViewPoints, name: str) -> float:
    """Return how far off a point must lie for the operator to see it, px."""
    if points.view.is_face:
        return SEEN_FACE * eyes_px(truth)
    return (SEEN_JOINT if name.startswith(("l_", "r_")) else SEEN_BODY) * figure_height_px(points)


def eyes_px(truth: TruthView) -> float:
    """Return the true distance of the pupils at their depth, px."""
    left, right = truth.points_m["pupil_L"], truth.points_m["pupil_R"]
    return float(np.linalg.norm(left - right)) / truth.camera.metres_per_pixel((left + right) / 2)


def drags(proposed: dict[ViewId, ViewPoints], photos: PhotoSet, truth: Truth) -> Iterator[Corrections]:
    """Yield the corrections after each of the operator's drags, none first; every point is seen as it lies by then."""
    corrections = no_corrections()
    yield corrections
    for view, name in worst_first(proposed):
        known = truth.views[view.value]
        points = corrected(proposed[view], corrections.points.get(view, {}), photos.photos[view])
        placed = points.points_px[points.names.index(name)]
        place = true_place(known, name, placed)
        if place is not None and np.linalg.norm(place - placed) > seen_px(known, proposed[view], name):
            corrections = move_point(corrections, view, name, float(place[0]), float(place[1]), "")
            yield corrections


def fitted(known: dict[str, Any], corrections: Corrections) -> dict[str, Any]:
    """Return all values up to the obeyed person, what still holds taken over."""
    names = [stage.name for stage in pipeline.STAGES]
    kept = still_true(known, known["photos"], known["person"], corrections) if "obeyed" in known else {}
    values = {**kept, "photos": known["photos"], "person": known["person"], "corrections": corrections}
    return pipeline.run(values, stages=pipeline.STAGES[: names.index(LAST_STAGE) + 1])[0]


def figures(values: dict[str, Any], truth: Truth) -> dict[str, float]:
    """Return the metrics of one fit."""
    generic, person = load_generic(), values["obeyed"]
    clone = replace(
        generic_clone(generic, person.stature_m),
        vertices_m=person.vertices_m,
        joints_m=person.joints_m,
        features_m=person.features_m,
        views=person.views,
        sole_m=person.sole_m,
    )
    surface, start = truth.surface, person.views[ViewId.BODY_FRONT].rotations
    rotations = rotations_towards(clone, generic, surface.joints_m, surface.marks_m, start)
    posed = pose_clone(clone, generic, rotations)
    posed = posed.moved(truth_from_body(posed, generic, surface.joints_m, surface.marks_m))
    found, marks = landmarks(posed.features_m), landmarks(surface.marks_m)
    names = [name for name in LANDMARKS if name in found and name in marks]
    away = rulers.landmark_distances(np.array([found[n] for n in names]), np.array([marks[n] for n in names]))
    rng = np.random.default_rng(0)
    return {
        "landmarks": mm_from_m(float(away.mean())),
        "face": skins.face_surface_mm(posed, generic, surface, rng=rng).rigid.mean,
        "body": skins.body_surface_mm(posed, generic, surface, rng=rng).mean,
        "points": point_error(values, truth),
    }


def point_error(values: dict[str, Any], truth: Truth) -> float:
    """Return the mean error of the face photos' points, % of the eyes' distance."""
    errors = []
    for view, points in values["face_points"].views.items():
        known = truth.views[view.value]
        if view.is_face:
            unit = eyes_px(known)
            rows = zip(points.names, points.points_px, strict=True)
            errors += [100.0 * np.linalg.norm(at - known.marks_px[n]) / unit for n, at in rows if n in known.marks_px]
    return float(np.mean(errors))


def worked(visitor: str, set_name: str) -> dict[str, Any]:
    """Return what the operator's drags do to one set."""
    folder = SAMPLES / visitor / set_name
    first = fitted({"photos": load_photos(folder), "person": read_person(folder)}, no_corrections())
    truth = read_truth(SAMPLES / visitor, set_name)
    proposed = points_by_view(first, first["photos"])
    states = list(drags(proposed, first["photos"], truth))
    rows, values = {}, first
    for count in (*DRAGS, len(states) - 1):
        values = fitted(values, states[min(count, len(states) - 1)]) if count else first
        rows[count] = figures(values, truth)
    return {"visitor": visitor, "set": set_name, "wanted": len(states) - 1, "rows": rows}


def way_gone(rows: dict[int, dict[str, float]], metric: str) -> float:
    """Return the share of the way from no drag to all true features that 12 drags went."""
    none, some, every = (rows[count][metric] for count in (0, DRAGS[-1], max(rows)))
    return (none - some) / (none - every) if none - every > 1e-9 else 1.0


def told(work: dict[str, Any]) -> str:
    """Return the lines of one set."""
    rows, last = work["rows"], max(work["rows"])
    lines = [f"{work['visitor']} {work['set']}: {work['wanted']} points off their places"]
    for metric in METRICS:
        cells = "  ".join(f"{rows[count][metric]:5.2f}" for count in DRAGS)
        near = rows[DRAGS[-1]][metric] - rows[last][metric] <= NEAR_MM
        share = way_gone(rows, metric)
        mark = "there" if near or share >= ENOUGH else f"{100 * share:.0f} %"
        lines.append(f"  {metric:10}{cells}   all true {rows[last][metric]:5.2f}   {mark}")
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sets", nargs="*", help="VISITOR/SET, all samples by default")
    parser.add_argument("--json", action="store_true")
    chosen = parser.parse_args()
    wanted = chosen.sets or [f"{visitor}/{name}" for visitor in ("anna", "boris") for name in SETS]
    print("drags" + "".join(f"{count:>7}" for count in DRAGS)) if not chosen.json else None
    for one in wanted:
        work = worked(*one.split("/"))
        print(json.dumps(work) if chosen.json else told(work), flush=True)


if __name__ == "__main__":
    main()
