"""Distances between a clone's surface and the truth's: the whole body, and the face."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.evaluate.measures.posing import PosedClone, landmarks, truth_from_points
from cloner.evaluate.measures.rulers import (
    DistanceSummary,
    Surface,
    align_by_nearest,
    inverse_transform,
    summarise,
    transform_points,
)
from cloner.evaluate.measures.surfaces import PointSurface, TriangleSurface, sample_surface, visible_from_outside
from cloner.evaluate.truths.truth import TruthSurface
from cloner.frames import MILLIMETRES_PER_METRE
from cloner.generic.load import GenericHuman
from cloner.records.arrays import Array

Mask = NDArray[np.bool_]

_SAMPLES: Final = 8_000  # measured: the mean moves by 0.03 mm between seeds
_VOTERS: Final = 3_000  # points that steer the alignment of a whole body
_DISCS: Final = 100_000  # of the clone, for its alignment
_DISC_M: Final = 0.006  # measured: the truth against its own samples (3.6 mm apart on average) reads 0.02 mm
_FACE_RADIUS_M: Final = 0.095  # rulers: within 95 mm of the nose tip
#: Marks in front of which a face ends.
EARS: Final = tuple(f"{name}_{side}" for name in ("ear_outer", "ear_lobe") for side in "LR")
_HAND_M: Final = 0.25  # longest hand, wrist to fingertip, with room
_HAIR_NEAR_M: Final = 0.025  # taste: skin this near hair was never seen by a camera


@dataclass(frozen=True, slots=True)
class FaceErrors:
    """Face surface error with scale free and fixed, mm."""

    similarity: DistanceSummary
    rigid: DistanceSummary


@dataclass(frozen=True, slots=True, eq=False)
class BodyDistances:
    """Distances between a clone and the truth it was laid on; truth frame, metres.

    Attributes
    ----------
    aligned : Posed
        The clone after the rigid alignment.
    to_clone_m : (N,) float64
        From the truth's points to the clone.
    clone_vertex : (N,) int64
        A vertex of the clone's triangle nearest to each.
    to_truth_m : (M,) float64
        From points spread over the clone to the truth.
    own_vertex : (M,) int64
        A vertex of the triangle each of those lies on.
    """

    aligned: PosedClone
    to_clone_m: Array
    clone_vertex: NDArray[np.int64]
    to_truth_m: Array
    own_vertex: NDArray[np.int64]


def body_surface_mm(
    posed: PosedClone, generic: GenericHuman, truth: TruthSurface, *, rng: np.random.Generator
) -> DistanceSummary:
    """Return the symmetric nearest-surface distance of a clone posed as the truth, mm; see :func:`body_distances`."""
    found = body_distances(posed, generic, truth, rng=rng)
    return _symmetric_spread_mm(found.to_clone_m, found.to_truth_m)


def body_distances(
    posed: PosedClone, generic: GenericHuman, truth: TruthSurface, *, rng: np.random.Generator
) -> BodyDistances:
    """Return the nearest-surface distances of a clone posed as the truth, both ways.

    Parameters
    ----------
    posed : Posed
        Already in the truth's pose and near its frame; aligned rigidly here.
    generic : GenericHuman
    truth : TruthSurface
    rng : numpy Generator
        Draws the clone's sample points.

    Notes
    -----
    Hands and what hair covers are left out as queries but not as targets, so
    nothing is measured against a hole.
    """
    hair = truth.kind == "hair"
    firm = ~hair & (truth.kind != "organ")
    seen = np.zeros(len(firm), dtype=bool)
    seen[firm] = visible_from_outside(truth.points_m[firm], truth.normals[firm], truth.points_m[~hair])
    asked = (
        seen & ~_in_hands(truth.points_m, truth.joints_m) & ~_near(truth.points_m, truth.points_m[hair], _HAIR_NEAR_M)
    )
    points = truth.points_m[asked]
    points = points[rng.choice(len(points), size=min(_SAMPLES, len(points)), replace=False)]
    skin = skin_triangles(generic)
    surface = TriangleSurface(posed.vertices_m, skin)
    # discs steer as well as triangles and are found ten times as fast; what is told is measured on triangles
    discs = PointSurface(*sample_surface(posed.vertices_m, skin, _DISCS, rng=rng)[:2], radius=_DISC_M)
    truth_from_clone = align_by_nearest(points[:_VOTERS], discs, scale=False, keep=1.0, turns=15)
    moved = posed.moved(truth_from_clone)
    _, to_clone, nearest = surface.closest(transform_points(inverse_transform(truth_from_clone), points))
    hidden = generic.region("scalp") | generic.region("hand_left") | generic.region("hand_right")
    shown = skin[~hidden[skin].any(axis=1)]
    samples, _, which = sample_surface(moved.vertices_m, shown, _SAMPLES, rng=rng)
    bare = ~_near(samples, truth.points_m[hair], _HAIR_NEAR_M)
    _, to_truth, _ = PointSurface(truth.points_m[seen], truth.normals[seen], radius=_DISC_M).closest(samples[bare])
    own = shown[which[bare], 0].astype(np.int64)
    return BodyDistances(moved, to_clone, skin[nearest, 0].astype(np.int64), to_truth, own)


def face_surface_mm(
    posed: PosedClone, generic: GenericHuman, truth: TruthSurface, *, rng: np.random.Generator
) -> FaceErrors:
    """Return the face surface errors (rulers), mm.

    Parameters
    ----------
    posed : Posed
        Any rigid place; the first alignment is by feature points.
    """
    bare = truth.kind == "bare"
    firm = bare | (truth.kind == "organ")
    marks = truth.marks_m
    asked = bare & in_face(truth.points_m, marks)
    seen = visible_from_outside(truth.points_m[asked], truth.normals[asked], truth.points_m[firm])
    points, normals = truth.points_m[asked][seen], truth.normals[asked][seen]
    target: Surface = PointSurface(points, normals, radius=_DISC_M)
    if len(truth.bare_m):
        target = TriangleSurface(truth.bare_m, truth.bare_triangles)
    placed = posed.moved(truth_from_points(landmarks(posed.features_m), landmarks(marks)))
    skin = skin_triangles(generic)
    head = skin[_within(placed.vertices_m, marks["nose_tip"], 2.0 * _FACE_RADIUS_M)[skin].all(axis=1)]
    surface = TriangleSurface(placed.vertices_m, head)
    samples, directions, _ = sample_surface(placed.vertices_m, head, _SAMPLES, rng=rng)
    near = _within(samples, marks["nose_tip"], 1.2 * _FACE_RADIUS_M)
    near[near] = visible_from_outside(
        samples[near], directions[near], np.vstack([samples, _dense_organs(placed, generic)])
    )
    samples = samples[near]
    errors = {}
    for scale in (True, False):
        transform = align_by_nearest(points, surface, scale=scale)
        _, to_clone, _ = surface.closest(transform_points(inverse_transform(transform), points))
        to_clone = to_clone * np.cbrt(np.linalg.det(transform[:3, :3]))
        moved = transform_points(transform, samples)
        _, to_truth, _ = target.closest(moved[in_face(moved, marks)])
        errors[scale] = _symmetric_spread_mm(to_clone, to_truth)
    return FaceErrors(errors[True], errors[False])


def skin_triangles(generic: GenericHuman) -> NDArray[np.int32]:
    """Return the (T, 3) triangles of the outer skin: no eyes, teeth or mouth interior."""
    triangles, _ = generic.triangles()
    body = generic.skin
    kept = body & ~generic.region("mouth_interior")
    return np.asarray(triangles[kept[triangles].all(axis=1)], dtype=np.int32)


def _dense_organs(posed: PosedClone, generic: GenericHuman) -> Array:
    """Return the vertices of eyes and teeth, which hide the sockets behind them."""
    return np.asarray(posed.vertices_m[~generic.skin])


def _symmetric_spread_mm(first: Array, second: Array) -> DistanceSummary:
    """Return the spread of two directions in mm, each with the same say."""
    one, two = summarise(first * MILLIMETRES_PER_METRE), summarise(second * MILLIMETRES_PER_METRE)
    return DistanceSummary((one.mean + two.mean) / 2, (one.median + two.median) / 2, (one.p95 + two.p95) / 2)


def _within(points: Array, centre: Array, radius_m: float) -> Mask:
    return np.asarray(np.linalg.norm(points - centre, axis=1) < radius_m)


def in_face(points: Array, marks: Mapping[str, Array], ears: Sequence[str] = EARS) -> Mask:
    """Return which points lie near the nose, above the chin and in front of the named marks of the ears (rulers)."""
    back = max(float(marks[name][2]) for name in ears)
    return np.asarray(
        _within(points, marks["nose_tip"], _FACE_RADIUS_M)
        & (points[:, 1] > marks["chin_bottom"][1])
        & (points[:, 2] > back)
    )


def _in_hands(points: Array, joints: Mapping[str, Array]) -> Mask:
    inside = np.zeros(len(points), dtype=bool)
    for side in "LR":
        wrist, elbow = joints[f"wrist_{side}"], joints[f"elbow_{side}"]
        beyond = (points - wrist) @ ((wrist - elbow) / np.linalg.norm(wrist - elbow))
        inside |= (beyond > 0.0) & _within(points, wrist, _HAND_M)
    return inside


def _near(points: Array, others: Array, radius_m: float) -> Mask:
    if not len(others):
        return np.zeros(len(points), dtype=bool)
    distance, _ = cKDTree(others).query(points)
    return np.asarray(distance < radius_m)
