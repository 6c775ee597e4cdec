"""Score one clone of a known person after every step; the rulers are the project's own (docs/method)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

import cv2
import numpy as np
from body_foreign_pose import rotations_by_surface
from numpy.typing import NDArray

from cloner.evaluate.figures import skins
from cloner.evaluate.measures import rulers
from cloner.evaluate.measures.posing import (
    PosedClone,
    fit_rotations,
    joints_by_truth_name,
    moved_camera,
    pose_clone,
    truth_from_body,
    truth_from_points,
)
from cloner.evaluate.truths.truth import TruthSurface, TruthView
from cloner.frames import MILLIMETRES_PER_METRE, ViewId, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.geometry.measurement.measures import TRUTH_GIRTHS
from cloner.records.bodies import PosedView
from cloner.records.clones import Clone
from cloner.records.measures import MeasureSet
from cloner.records.points import PointSet
from cloner.records.views import Camera
from cloner.render import clone_layers, coverage
from cloner.testing import bare_atlas

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Values = Mapping[str, Any]

STEPS: Final = ("generic", "phenotype", "skeleton", "rough", "fine", "finished")
HELD_OUT: Final = "body_three_quarter"
#: A feature point farther away than this share of the person's height in the photo is wrong (issue 4).
WRONG_SHARE: Final = 0.05
#: The region around the true head and hair that no step of the body answers for, photo heights.
HEAD_MARGIN: Final = 0.012
SEED: Final = 0  # of the surface samples
#: Which coordinates of a point count: ends of the body are rows, wherever along them they were put.
_COUNTED: Final = dict.fromkeys(("head_top", "sole_left", "sole_right"), (0.0, 1.0))
#: Parts of the tables, and the segments they join.
PARTS: Final = {
    "head": ("head",), "torso": ("torso",), "pelvis": ("pelvis",), "upper arms": ("left_upper_arm", "right_upper_arm"),
    "forearms": ("left_forearm", "right_forearm"), "thighs": ("left_thigh", "right_thigh"),
    "calves": ("left_calf", "right_calf"), "feet": ("left_foot", "right_foot"),
}  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class KnownTruth:
    """What is true of a photographed person, as the rulers take it.

    Attributes
    ----------
    stature_m : float
    girths_mm : mapping of str to float
        Of the naked body.
    dressed_girths_mm : mapping of str to float
        The same tapes over the clothes; empty where unknown.
    surface : TruthSurface
        The dressed person in the front photo's pose.
    views : mapping of str to TruthView
        The three body photos and the held-out one.
    head_masks : mapping of str to (H, W) bool
        Where each photo shows head and hair.
    points_px : mapping of str to mapping of str to (2,)
        True pixels of joints and feature points, by photo.
    spine_m : mapping of str to (3,)
        H-Anim joints of spine and skull in the surface's pose; empty where unknown.
    """

    stature_m: float
    girths_mm: Mapping[str, float]
    dressed_girths_mm: Mapping[str, float]
    surface: TruthSurface
    views: Mapping[str, TruthView]
    head_masks: Mapping[str, Mask]
    points_px: Mapping[str, Mapping[str, Array]]
    spine_m: Mapping[str, Array]


def body_clone(
    generic: GenericHuman,
    vertices_m: Array,
    joints_m: Array,
    views: Mapping[ViewId, PosedView],
    stature_m: float,
    sole_m: float,
) -> Clone:
    """Return a step's body as a clone without texture, hair and morphs."""
    features = {name: vertices_m[generic.feature(name)] for name in generic.feature_names}
    empty = (np.zeros(0, np.int32), np.zeros((0, 3), np.float32), np.zeros(1, np.int32))
    return Clone(vertices_m, joints_m, (), *empty, bare_atlas(), (), features, views, stature_m, sole_m)


def score_step(step: Clone, generic: GenericHuman, truth: KnownTruth) -> dict[str, Any]:
    """Return silhouette overlaps and surface errors of one step's body.

    Returns
    -------
    dict
        ``silhouette_iou`` and ``below_head_iou`` by view (the held-out one too), ``surface_mean_mm`` and
        ``surface_p95_mm`` without head, hair and hands, ``part_mm`` by part (mean and p95), ``joints_mm`` and
        ``joints_off_mm`` (to the person's left, up, forward).
    """
    rotations, truth_from_step = placed(step, generic, truth)
    masks = {view: _photo_mask(step, view) for view in truth.views if view != HELD_OUT}
    masks[HELD_OUT] = drawn_mask(step, moved_camera(truth.views[HELD_OUT].camera, truth_from_step), rotations)
    posed = pose_clone(step, generic, rotations).moved(truth_from_step)
    surface = truth.surface
    if not surface.joints_m:
        surface = replace(surface, joints_m=joints_by_truth_name(posed, generic))
    found = skins.body_distances(posed, generic, surface, rng=np.random.default_rng(SEED))
    off = joint_errors_mm(found.aligned, generic, truth)
    return {
        "silhouette_iou": {view: rulers.mask_iou(mask, truth.views[view].mask) for view, mask in masks.items()},
        "below_head_iou": {view: below_head_overlap(mask, truth, view) for view, mask in masks.items()},
        **surface_scores(found, generic),
        "joints_mm": {name: float(np.linalg.norm(away)) for name, away in off.items()},
        "joints_off_mm": {name: away.tolist() for name, away in off.items()},
    }


def placed(step: Clone, generic: GenericHuman, truth: KnownTruth) -> tuple[Array, Array]:
    """Return the (94, 3) rotations and the rigid (4, 4) motion that lay a body on the truth, never scaled.

    Both follow the truth's joints (rulers); a foreign body has none, so there the pose follows its surface, which
    is kinder.
    """
    start = step.views[ViewId.BODY_FRONT]
    held = truth.views[HELD_OUT]
    if truth.surface.joints_m:
        rotations = fit_rotations(step, generic, held.joints_m, held.points_m, start.rotations)
        posed = pose_clone(step, generic, rotations)
        return rotations, truth_from_body(posed, generic, held.joints_m, held.points_m)
    return rotations_by_surface(step, generic, truth.surface, start.rotations)


def _photo_mask(step: Clone, view: str) -> Mask:
    seen = step.views[ViewId(view)]
    return drawn_mask(step, seen.camera, seen.rotations)


def drawn_mask(clone: Clone, camera: Camera, rotations: Array) -> Mask:
    """Return the (H, W) pixels that a clone covers by more than half; the renderer's own samples are enough."""
    return np.asarray(coverage(clone_layers(clone, rotations), camera, supersample=1) > 0.5)


def laid_on(step: Clone, other: Clone, generic: GenericHuman) -> Clone:
    """Return a body with another's poses and with cameras that see its main joints where they see the other's."""
    views = {}
    for view, seen in other.views.items():
        own, goal = (joints_by_truth_name(pose_clone(who, generic, seen.rotations), generic) for who in (step, other))
        views[view] = PosedView(view, moved_camera(seen.camera, truth_from_points(own, goal)), seen.rotations)
    return body_clone(generic, step.vertices_m, step.joints_m, views, step.stature_m, step.sole_m)


def below_head_overlap(mask: Mask, truth: KnownTruth, view: str) -> float:
    """Return the silhouettes' overlap where the photo shows neither head nor hair."""
    width = max(int(HEAD_MARGIN * len(mask)), 1)
    head = cv2.dilate(truth.head_masks[view].astype(np.uint8), np.ones((2 * width + 1,) * 2, np.uint8)) > 0
    rows = np.flatnonzero(truth.head_masks[view].any(axis=1))
    if len(rows):
        head[: rows[0] + int(0.8 * np.ptp(rows))] = True  # above the chin all is head: hair that the clone has, too
    return rulers.mask_iou(mask & ~head, truth.views[view].mask & ~head)


def surface_scores(found: skins.BodyDistances, generic: GenericHuman) -> dict[str, Any]:
    """Return mean and p95 of both directions, each with the same say, over the body and by part, mm."""
    sides = ((found.to_clone_m, found.clone_vertex), (found.to_truth_m, found.own_vertex))
    head = generic.segment_names.index("head")

    def both(rows: tuple[int, ...], inside: bool) -> tuple[float, float] | None:
        spreads = []
        for distances, vertex in sides:
            chosen = np.isin(generic.vertex_segment[vertex], rows) == inside
            if np.count_nonzero(chosen) > 20:
                spreads.append(rulers.summarise(distances[chosen] * MILLIMETRES_PER_METRE))
        if not spreads:
            return None
        return float(np.mean([s.mean for s in spreads])), float(np.mean([s.p95 for s in spreads]))

    whole = both((head,), False) or (np.nan, np.nan)
    parts = {
        name: both(tuple(generic.segment_names.index(segment) for segment in segments), True)
        for name, segments in PARTS.items()
    }
    return {
        "surface_mean_mm": whole[0],
        "surface_p95_mm": whole[1],
        "part_mm": {name: values for name, values in parts.items() if values is not None},
    }


def joint_errors_mm(posed: PosedClone, generic: GenericHuman, truth: KnownTruth) -> dict[str, Array]:
    """Return the (3,) offsets of the main joints from the truth's after the surfaces were aligned, mm."""
    own = joints_by_truth_name(posed, generic) | {name: posed.joints_m[generic.joint(name)] for name in truth.spine_m}
    true = {**truth.surface.joints_m, **truth.spine_m}
    return {name: MILLIMETRES_PER_METRE * (own[name] - at) for name, at in true.items() if name in own}


def score_outlines(values: Values, truth: KnownTruth) -> dict[str, Any]:
    """Return error and overlap of the extracted outlines and, beside them, of the net's mask alone; by view."""
    found: dict[str, Any] = {}
    for view, silhouette in values["silhouettes"].views.items():
        if not view.is_body:
            continue
        true = truth.views[view.value].mask
        row: dict[str, float] = {}
        for name, mask in (("outline", silhouette.mask), ("mask", values["proposals"].views[view].person())):
            spread = rulers.summarise(rulers.outline_distances_px(mask, true))
            row |= {f"{name}_iou": rulers.mask_iou(mask, true), f"{name}_px": spread.mean, f"{name}_p95_px": spread.p95}
        linked = [source == "edges" for _, source, _ in silhouette.sources]
        found[view.value] = {**row, "edges_share": float(np.mean(linked or [False]))}
    return found


def score_points(body_points: PointSet, truth: KnownTruth) -> dict[str, Any]:
    """Return the error of every proposed feature point, % of the person's height in the photo, and the wrong ones."""
    errors: dict[str, dict[str, float]] = {}
    for view, points in body_points.views.items():
        height = float(np.ptp(np.flatnonzero(truth.views[view.value].mask.any(axis=1))))
        true = truth.points_px[view.value]
        errors[view.value] = {
            name: float(100.0 * np.linalg.norm((at - true[name]) * _COUNTED.get(name, (1.0, 1.0))) / height)
            for name, at, sure in zip(points.names, points.points_px, points.confidence, strict=True)
            if name in true and sure > 0.0
        }
    wrong = [f"{view[5:]} {name}" for view, by in errors.items() for name, e in by.items() if e > 100.0 * WRONG_SHARE]
    return {"percent": errors, "wrong": wrong}


def score_measures(measures: MeasureSet, truth: KnownTruth, tightness: str) -> dict[str, Any]:
    """Return shown, told and true girths with their ±, mm, for the tables and for calibrating the ±."""
    found = {name: measures.measures[TRUTH_GIRTHS.get(name, name)] for name in truth.girths_mm}
    return {
        "tightness": tightness,
        "upper_fit": dict(measures.upper_fit),
        "lower_fit": dict(measures.lower_fit),
        "girths": {
            name: {
                "shown": girth.shown_mm,
                "value": girth.value_mm,
                "plus_minus": girth.plus_minus_mm,
                "true": truth.girths_mm[name],
                "true_dressed": truth.dressed_girths_mm.get(name),
            }
            for name, girth in found.items()
        },
    }


def stature_error_mm(clone: Clone, generic: GenericHuman, truth: KnownTruth) -> float:
    """Return how much the finished skin stands taller than the person, mm."""
    top = clone.vertices_m[generic.part("body"), 1].max()
    return mm_from_m(float(top - clone.sole_m - truth.stature_m))
