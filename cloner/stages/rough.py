"""Stage: rough skin (paper §3.4): parts follow their joints, then end slices follow the photos.

Each part's matrix is updated by the rotation, scale and translation of its joint
and child joint; parts stick together through the connection database, which here
is the smooth overlay of segment weights. Then the left-, right-, front- and
back-most points of each part's top and bottom slice set the width and depth,
piecewise affine around the slice and affine between the two slices.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.body.clothes import clothed_body
from cloner.body.outlined import (
    GRID_SEGMENTS,
    OutlinedPhoto,
    mean_outline_distance_mm,
    outlined_photos,
    paper_body_views,
    posed_silhouette,
    slice_pairs,
)
from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.outlines.settling import without_folds
from cloner.geometry.outlines.slices import aspect_shift, fine_shift
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, BodySet, Phenotype, Skeleton, SkeletonSet
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.rough")


@dataclass(frozen=True, slots=True)
class Params:
    """Positions of a part's end slices and their search range.

    Its numbers: ``cloner/calibration/stages.toml``, ``[rough.*]``.
    """

    end_levels: tuple[float, float] = _CALIBRATED.pair("end_levels", "share")
    reach_mm: float = _CALIBRATED.number("reach_mm", "mm")


def follow_joints(vertices_m: Array, old_m: Array, new_m: Array) -> Array:
    """Return the vertices after every part followed its joint and child joint.

    Parameters
    ----------
    vertices_m : (V, 3)
    old_m, new_m : (94, 3) joints before and after
    """
    generic = load_generic()
    weights = generic.segment_weights.astype(np.float64)
    moved = np.zeros_like(vertices_m)
    for row, name in enumerate(generic.segment_names):
        first, second = generic.slice_axis_joints[row]
        if first < 0 or second < 0:
            first = second = _root_joint(name)
        moved += weights[:, row : row + 1] * _similarity_between(
            vertices_m, old_m[[first, second]], new_m[[first, second]]
        )
    return np.asarray(moved / np.maximum(weights.sum(axis=1, keepdims=True), 1e-9))


def _root_joint(segment: str) -> int:
    """Return the joint that moves a free segment (head, hand, foot)."""
    generic = load_generic()
    side = segment[0]
    names = {"head": "skullbase", f"{side}_hand": f"{side}_wrist", f"{side}_foot": f"{side}_ankle"}
    return generic.joint(names.get(segment if segment == "head" else f"{side}_{segment.split('_')[1]}", "HumanoidRoot"))


def _similarity_between(points_m: Array, old: Array, new: Array) -> Array:
    """Return points moved by the similarity that maps one joint pair to another."""
    before, after = old[1] - old[0], new[1] - new[0]
    length = float(np.linalg.norm(before))
    if length < 1e-6:
        return np.asarray(points_m + (new[0] - old[0]))
    axis = np.cross(before, after) / (length * max(float(np.linalg.norm(after)), 1e-9))
    turn = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    matrix = np.eye(3) + turn + 0.5 * turn @ turn
    along = before / length
    stretch = float(np.linalg.norm(after)) / length - 1.0
    local = points_m - old[0]
    local = local + stretch * np.clip(local @ along, 0.0, length)[:, None] * along
    return np.asarray(new[0] + local @ matrix.T)


def shape_slices(
    mesh: BodyMesh, photos: tuple[OutlinedPhoto, ...], levels: Array, reach_mm: float, smooth: float
) -> BodyMesh:
    """Return the body after its slices were moved by T_i,m of every photo.

    The occluding points of front and back photos set the width, those of the side
    photo the depth; arms have front and back silhouettes only (paper §3.6). What no
    photo shows perpendicular to a seen width keeps the section's shape.
    """
    generic = load_generic()
    sides = {photo.view is ViewId.BODY_SIDE for photo in photos}
    vertices = mesh.vertices_m.copy()
    for photo in photos:
        seen = posed_silhouette(BodyMesh(vertices, mesh.joints_m), photo)
        shift = np.zeros_like(vertices)
        for name in GRID_SEGMENTS:
            if photo.view is ViewId.BODY_SIDE and name.endswith("arm"):
                continue
            weight = generic.share(name)
            near = np.flatnonzero(weight > 0)
            pairs = slice_pairs(seen, photo, name, levels, reach_mm)
            s = np.clip(generic.slice_s[near].astype(np.float64), 0.0, 1.0)
            theta = generic.slice_theta[near].astype(np.float64)
            moved = fine_shift(pairs, s, theta, smooth=smooth)
            if name.endswith("arm") or len(sides) == 1:
                moved += aspect_shift(pairs, vertices, vertices[near], s, smooth=smooth)
            shift[near] += weight[near, None] * moved
        vertices += shift
    return BodyMesh(without_folds(mesh.vertices_m, vertices, body_triangles()), mesh.joints_m)


def run(
    *,
    proposals: Proposals,
    skeletons: SkeletonSet,
    silhouettes: SilhouetteSet,
    phenotype: Phenotype,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the front+side and back+side bodies with parts in place, and their mean."""
    params = Params()
    vertices, joints = clothed_body(phenotype)
    photos = outlined_photos(phenotype, silhouettes, proposals)
    bodies = []
    chosen: tuple[tuple[ViewId, Skeleton], ...] = (
        (ViewId.BODY_FRONT, skeletons.front_side),
        (ViewId.BODY_BACK, skeletons.back_side),
    )
    for number, (main, skeleton) in enumerate(chosen):
        followed = BodyMesh(follow_joints(vertices, joints, skeleton.joints_m), skeleton.joints_m)
        bodies.append(
            shape_slices(followed, paper_body_views(photos, main), np.array(params.end_levels), params.reach_mm, 0.0)
        )
        tick((number + 1) / 2)
    mean = BodyMesh((bodies[0].vertices_m + bodies[1].vertices_m) / 2, skeletons.consensus.joints_m)
    residuals = tuple(
        Residual("outline gap", mean_outline_distance_mm(mean, photo), "mm", view.value)
        for view, photo in photos.items()
    )
    return StageResult({"rough_bodies": BodySet(bodies[0], bodies[1], mean)}, residuals)
