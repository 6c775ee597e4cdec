"""Constraints of corrected outline points on the skin: which part of the outline, from which side, how far.

A point claims the outline nearest to it that its named part makes: levels along the body are a matter of opinion, the
outline is not.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.editing.places import LEAST_FREE, distance_from, free_skin, generic_metric, outline_skin
from cloner.editing.targets import PointConstraint
from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skin_bends import EdgePoint
from cloner.geometry.articulation.skinning import blend_transforms, joint_transforms
from cloner.geometry.outlines.contour_search import ContourPoint, nearest_contour_point, occluding_contour
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.points import ANCHOR
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/editing.toml``.
_CALIBRATED: Final = calibrated("editing.outline_constraints")

Bools = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Params:
    """Range of a point's bend.

    Its numbers: ``cloner/calibration/editing.toml``, ``[claims.*]``.

    Attributes
    ----------
    turns, rounds : int
        Steps of the solution, and how often other skin that has become the outline is taken in.
    """

    territory_mm: float = _CALIBRATED.number("territory_mm", "mm")
    least_reach_mm: float = _CALIBRATED.number("least_reach_mm", "mm")
    most_reach_mm: float = _CALIBRATED.number("most_reach_mm", "mm")
    reach_per_mm: float = _CALIBRATED.number("reach_by_move", "factor")
    gentle: float = _CALIBRATED.number("gentle", "factor")
    across: float = _CALIBRATED.number("across", "share")
    depth: float = _CALIBRATED.number("depth", "factor")
    dimple: float = _CALIBRATED.number("dimple", "factor")
    usual_radius_mm: float = _CALIBRATED.number("usual_radius_mm", "mm")
    most_mm: float = _CALIBRATED.number("most_mm", "mm")
    inner_mm: float = _CALIBRATED.number("inner_mm", "mm")
    gap_mm: float = _CALIBRATED.number("gap_mm", "mm")
    least_area: float = _CALIBRATED.number("least_area", "share")
    least_area_mm2: float = _CALIBRATED.number("least_area_mm2", "mm2")
    damping: tuple[float, ...] = _CALIBRATED.numbers("damping", "factor")
    turns: int = 10
    rounds: int = 6
    near_px: float = _CALIBRATED.number("near_px", "px")


@dataclass(frozen=True, slots=True, eq=False)
class PosedPhoto:
    """One photo: camera, eye, skin transforms (V, 3, 4), and the unbent body posed and projected."""

    camera: Camera
    eye_m: Array
    blended: Array
    posed_m: Array
    pixels: Array
    mm_per_px: float


@dataclass(frozen=True, slots=True, eq=False)
class OutlineConstraint:
    """A corrected point, the nearest place of the unbent outline, the outline's normal (2,), its distance, and edges
    (N, 2).
    """

    target: PointConstraint
    place: EdgePoint
    outward: Array
    inward: bool
    gap_px: float
    gap_mm: float
    edges: NDArray[np.int64]


def posed_photo(vertices_m: Array, joints_m: Array, posed: PosedView) -> PosedPhoto:
    """Return the body in one photo."""
    generic = load_generic()
    transforms = joint_transforms(joints_m, generic.joint_parents, posed.rotations)
    blended = blend_transforms(transforms, generic.skin_joints, generic.skin_weights.astype(np.float64))
    posed_m = np.einsum("vab,vb->va", blended[:, :, :3], vertices_m) + blended[:, :, 3]
    camera = posed.camera
    eye = camera.position_m
    if camera.pixels_per_m is not None:  # it sees along parallel rays
        eye = eye - 1e4 * camera.camera_from_model[2, :3]
    mm_per_px = mm_from_m(camera.metres_per_pixel(posed_m.mean(axis=0)))
    return PosedPhoto(camera, eye, blended, posed_m, camera.project(posed_m), mm_per_px)


def candidate_skin(target: PointConstraint, params: Params) -> Bools:
    """Return the skin (V,) that may make the outline at a corrected point."""
    if target.name.startswith(ANCHOR):  # it has no place on the generic skin: all that may move
        return np.asarray(free_skin() > LEAST_FREE)
    return outline_skin(target.name, m_from_mm(params.territory_mm), target.view is ViewId.BODY_SIDE)


def nearest_contour_points(
    targets: list[PointConstraint], scenes: Mapping[ViewId, PosedPhoto], params: Params
) -> list[ContourPoint | None]:
    """Return for every corrected point the nearest point of the unbent body's outline."""
    metric = generic_metric()
    found: dict[int, ContourPoint | None] = {}
    for view, seen in scenes.items():
        rim = occluding_contour(metric, seen.posed_m, seen.pixels, seen.eye_m)
        for k, target in enumerate(targets):
            if target.view is view:
                skin, penalty = candidate_skin(target, params), params.inner_mm / seen.mm_per_px
                found[k] = nearest_contour_point(rim, metric, target.target_px, skin, penalty)
    return [found[k] for k in range(len(targets))]


def make_constraint(
    target: PointConstraint, found: ContourPoint, seen: PosedPhoto, params: Params
) -> OutlineConstraint:
    """Return a corrected point with the outline's side and normal there, and the skin that may make the outline."""
    away = target.target_px - found.pixel
    gap_px = float(np.linalg.norm(away))
    inward = float(away @ found.outward) < 0.0
    outward = found.outward
    if gap_px > 2.0:  # the way to the nearest point is perpendicular to the outline; an edge's own normal is coarser
        outward = (-away if inward else away) / gap_px
    metric, skin = generic_metric(), candidate_skin(target, params)
    if target.name.startswith(ANCHOR):
        skin = skin & (distance_from(found.place) < m_from_mm(params.territory_mm))
    edges = metric.edges[skin[metric.edges].all(axis=1)]
    # What lies farther out already is another part, beyond a gap: the other thigh, seen from the crotch.
    beyond = ((seen.pixels[edges] - found.pixel) @ outward).max(axis=1)
    edges = edges[beyond < params.gap_mm / seen.mm_per_px]
    return OutlineConstraint(target, found.place, outward, inward, gap_px, gap_px * seen.mm_per_px, edges)
