"""All figures of one clone against its truth, before they become rows."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.evaluate.figures import likeness, skins
from cloner.evaluate.figures.leaks import background_texels
from cloner.evaluate.figures.regions import region_agreement
from cloner.evaluate.figures.seams import seam_ratios
from cloner.evaluate.measures import rulers
from cloner.evaluate.measures.posing import LANDMARKS, PosedClone, landmarks, pose_like_truth
from cloner.evaluate.measuring import CloneRun
from cloner.evaluate.truths.truth import THREE_QUARTER, Truth, TruthView
from cloner.frames import BODY_VIEWS, FACE_VIEWS, ViewId, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.generic.tape import body_girths, load_tape_rules
from cloner.geometry.measurement.measures import TRUTH_GIRTHS, girths_mm
from cloner.geometry.measurement.measuring import measures_mm
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.measures import MeasureSet
from cloner.records.points import PointSet

Keep = Callable[[str, NDArray[np.uint8]], None]


@dataclass(frozen=True, slots=True)
class Score:
    """One figure of one subject.

    Attributes
    ----------
    metric, view, unit : str
        View is "" for figures of the whole clone.
    value : float or None
        None where nothing could be measured.
    """

    metric: str
    view: str
    unit: str
    value: float | None


def score_run(run: CloneRun, truth: Truth) -> Iterator[Score]:
    """Yield the figures that only a clone has: outlines, proposals and effort."""
    for name, outline in run.outlines.items():
        true = truth.views[name].mask
        yield Score("outline_iou", name, "", rulers.mask_iou(outline, true))
        spread = rulers.summarise(rulers.outline_distances_px(outline, true))
        yield Score("outline_mean_px", name, "px", spread.mean)
        yield Score("outline_p95_px", name, "px", spread.p95)
    for view in FACE_VIEWS:
        if view in run.face_points.views:
            yield Score(
                "proposal_mean_percent_iod", view, "%", _proposal_error(run.face_points, truth.views[view], view)
            )
    yield Score("seconds", "", "s", run.seconds)
    yield Score("cpu_seconds", "", "s", run.cpu_seconds)
    yield Score("floor_seconds", "", "s", run.floor_seconds)
    yield Score("peak_mib", "", "MiB", run.peak_mib)


def held_out_scores(
    subject: Clone, generic: GenericHuman, views: Mapping[str, TruthView], rotations: Array, keep: Keep
) -> Iterator[Score]:
    """Yield how like a clone is in views that no photo showed; ``keep`` gets each one's name and picture."""
    for name, view in views.items():
        found, picture = likeness.held_out_likeness(subject, rotations, generic, view)
        keep(name, picture)
        if not name.startswith("body"):
            del found["silhouette_iou"]  # the shoulders of a face photo are in no known pose
        for metric, figure in found.items():
            yield Score(metric, name, "dE00" if metric == "delta_e" else "", figure)


def score_subject(
    subject: Clone,
    clone: Clone,
    generic: GenericHuman,
    truth: Truth,
    *,
    rng: np.random.Generator,
    keep: Keep = lambda view, picture: None,
    measures: MeasureSet | None = None,
) -> Iterator[Score]:
    """Yield the figures that a clone and both baselines have.

    Parameters
    ----------
    subject : Clone
        The clone, the generic human, or another visitor's clone.
    clone : Clone
        The visitor's own clone, whose cameras and poses are used for all three.
    generic : GenericHuman
    truth : Truth
    rng : numpy Generator
    keep : callable
        Gets the name and the picture of every held-out view.
    measures : MeasureSet, optional
        What the subject's own photos said of its body; else its girths come from its skin alone.
    """
    front = clone.views.get(ViewId.BODY_FRONT)
    rotations = np.zeros((len(clone.joints_m), 3)) if front is None else front.rotations
    for view in BODY_VIEWS:
        if view in clone.views:
            value = likeness.seen_as_photo(subject, clone, generic, view, truth.views[view].mask)
            yield Score("silhouette_iou", view, "", value)
    held_out = {name: truth.views[name] for name in THREE_QUARTER if name in truth.views}
    yield from held_out_scores(subject, generic, held_out, rotations, keep)
    posed, truth_rotations, truth_from_clone = pose_like_truth(
        subject, generic, truth.surface.joints_m, truth.surface.marks_m, rotations
    )
    yield from _surface_scores(posed, generic, truth, rng)
    photographed = bool(subject.views)  # the generic human has its stature and its one colour by construction
    if photographed:
        yield Score("stature_error_mm", "", "mm", abs(mm_from_m(_stature_m(subject, generic) - truth.stature_m)))
    yield from girth_scores(subject, measures, truth)
    # a seam is a matter of one texture alone, not of likeness: nobody else's seams are a baseline
    if photographed and subject is clone:
        photos = {view: truth.views[view].photo for view in clone.views if view in truth.views}
        for where, ratio in seam_ratios(clone, generic, photos).items():
            yield Score(f"seam_{where}_ratio", "", "", ratio)
        yield from leak_scores(clone, generic, truth)
    agreement = region_agreement(subject, generic, posed, truth_rotations, truth_from_clone, truth.surface, rng=rng)
    yield Score("region_agreement", "", "", agreement)


def girth_scores(subject: Clone, measures: MeasureSet | None, truth: Truth) -> Iterator[Score]:
    """Yield how far a subject's girths are from the true ones."""
    for name, value in _girths_mm(subject, measures).items():
        if name in truth.girths_mm:
            yield Score(f"girth_{name}_error_mm", "", "mm", abs(value - truth.girths_mm[name]))


def leak_scores(clone: Clone, generic: GenericHuman, truth: Truth) -> Iterator[Score]:
    """Yield how many texels show the room, of every photo."""
    for framing in (BODY_VIEWS, FACE_VIEWS):
        photographed = [view for view in framing if view in clone.views and view in truth.views]
        if not photographed:
            continue
        counts = background_texels(clone, generic, {view: truth.views[view] for view in photographed})
        for view, count in counts.items():
            yield Score("background_texels", view, "texels", float(count))


def _girths_mm(subject: Clone, measures: MeasureSet | None) -> dict[str, float]:
    """Return the girths a subject claims: under its clothes where body photos showed it, else the bare mesh's."""
    if measures is not None:
        return {name: measures.measures[key].value_mm for name, key in TRUTH_GIRTHS.items()}
    if not any(view.is_body for view in subject.views):
        return girths_mm(subject.vertices_m, subject.joints_m, load_tape_rules())
    shown = measures_mm(subject.vertices_m, subject.joints_m, load_tape_rules(), subject.sole_m)
    return {name: girth.value_mm for name, girth in body_girths(shown, subject.stature_m).items()}


def _surface_scores(
    posed: PosedClone, generic: GenericHuman, truth: Truth, rng: np.random.Generator
) -> Iterator[Score]:
    body = skins.body_surface_mm(posed, generic, truth.surface, rng=rng)
    yield Score("body_surface_mean_mm", "", "mm", body.mean)
    yield Score("body_surface_p95_mm", "", "mm", body.p95)
    face = skins.face_surface_mm(posed, generic, truth.surface, rng=rng)
    yield Score("face_surface_similarity_mm", "", "mm", face.similarity.mean)
    yield Score("face_surface_rigid_mm", "", "mm", face.rigid.mean)
    yield from landmark_scores(posed, truth)


def landmark_scores(posed: PosedClone, truth: Truth) -> Iterator[Score]:
    """Yield how far the face's named points are from the true ones, rigidly aligned."""
    found, marks = landmarks(posed.features_m), landmarks(truth.surface.marks_m)
    names = [name for name in LANDMARKS if name in found and name in marks]
    away = rulers.landmark_distances(np.array([found[n] for n in names]), np.array([marks[n] for n in names]))
    yield Score("face_landmarks_mean_mm", "", "mm", mm_from_m(float(away.mean())))
    yield Score("face_landmarks_worst_mm", "", "mm", mm_from_m(float(away.max())))


def _stature_m(subject: Clone, generic: GenericHuman) -> float:
    """Return the height of the finished skin above its bare soles, without hair."""
    top = subject.vertices_m[generic.part("body"), 1].max()
    return float(top - subject.sole_m)


def _proposal_error(points: PointSet, truth: TruthView, view: ViewId) -> float | None:
    """Return the mean distance of proposed points from the truth, % of the inter-ocular distance."""
    found: Mapping[str, Array] = dict(zip(points.views[view].names, points.views[view].points_px, strict=True))
    names = [name for name in found if name in truth.marks_px]
    if not names:
        return None
    away = [np.linalg.norm(found[name] - truth.marks_px[name]) for name in names]
    left, right = truth.points_m["pupil_L"], truth.points_m["pupil_R"]
    # in profile the projected distance vanishes: the true one at that depth serves both views
    iod_px = float(np.linalg.norm(left - right)) / truth.camera.metres_per_pixel((left + right) / 2)
    return float(100.0 * np.mean(away) / iod_px)
