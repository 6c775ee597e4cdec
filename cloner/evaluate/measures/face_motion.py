"""Quality of facial motion: lids on eyeballs, lips, teeth, ears and skull, per target, millimetres."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.frames import mm_from_m
from cloner.generic.face_grids import Grid, eye_grid, eyeball, lip_gaps_m, mouth_grid
from cloner.generic.load import load_generic
from cloner.generic.morphs import target_offsets
from cloner.generic.surfaces import load_triangles
from cloner.geometry.meshes.surface import overlaps_triangles
from cloner.records.arrays import Array
from cloner.records.clones import Clone

SIDES = ("left", "right")
#: Weights at which a target is looked at: glTF plays it on straight ways, half way is where lids dip.
WEIGHTS = (0.25, 0.5, 0.75, 1.0)
#: Points looked at on every quad of a lid, along each of its sides.
SAMPLES = 4
#: Skin in front of the mouth is what lies this near to its middle, metres.
AROUND_M = 0.07


@dataclass(frozen=True, slots=True)
class FaceFigures:
    """What one shape of a face looks like, mm.

    Attributes
    ----------
    lid_gap_left, lid_gap_right : float
        Widest distance between the margins of an eye's upper and lower lid.
    eye_through : float
        How far an eyeball stands out of the lids' skin at worst; zero or less is none.
    lip_gap : float
        Widest upright distance between the lips.
    teeth_through : float
        How far teeth stand out of the skin around the mouth; zero is none.
    tongue_through : float
        How deep the tongue pokes out of a lip's skin; zero is none.
    teeth_shown : float
        Height of the upper teeth that shows in the middle, from the front.
    ears, skull : float
        Largest displacement of ears and scalp.
    """

    lid_gap_left: float
    lid_gap_right: float
    eye_through: float
    lip_gap: float
    teeth_through: float
    tongue_through: float
    teeth_shown: float
    ears: float
    skull: float


def face_figures(rest_m: Array, shape_m: Array) -> FaceFigures:
    """Return the figures of a shape (V, 3) of the face that lies like ``rest_m`` (V, 3) at rest."""
    generic = load_generic()
    moved = np.linalg.norm(shape_m - rest_m, axis=1)
    ears = generic.region("ear_left") | generic.region("ear_right")
    grid = mouth_grid()
    values = (
        *(lid_gap_m(eye_grid(side), shape_m) for side in SIDES),
        max(eyeball_protrusion_m(side, rest_m, shape_m) for side in SIDES),
        float(lip_gaps_m(grid, shape_m[grid.rings]).max()),
        teeth_protrusion_m(shape_m),
        tongue_protrusion_m(shape_m),
        visible_teeth_m(shape_m),
        float(moved[ears].max()),
        float(moved[generic.region("scalp")].max()),
    )
    return FaceFigures(*(mm_from_m(value) for value in values))


def target_figures(clone: Clone) -> dict[str, FaceFigures]:
    """Return the figures of every target at full weight; what goes through is the worst on the way there."""
    out = {}
    for name, offsets in target_offsets(clone):
        step = offsets[:-1].astype(np.float64)
        out[name] = worst_along_path(clone.vertices_m, step)
    return out


def mixture_figures(clone: Clone, weights: Mapping[str, float]) -> FaceFigures:
    """Return the figures of several targets together."""
    shape = clone.vertices_m.copy()
    for name, offsets in target_offsets(clone):
        if name in weights:
            shape += weights[name] * offsets[:-1]
    return face_figures(clone.vertices_m, shape)


def worst_along_path(rest_m: Array, step_m: Array) -> FaceFigures:
    """Return the figures at the end of a straight path, with the worst intersections along it."""
    every = [face_figures(rest_m, rest_m + weight * step_m) for weight in WEIGHTS]
    through = {
        name: max(getattr(one, name) for one in every) for name in ("eye_through", "teeth_through", "tongue_through")
    }
    return replace(every[-1], **through)


def lid_gap_m(grid: Grid, shape_m: Array) -> float:
    """Return the widest distance between the two lids' margins, metres."""
    margin = shape_m[grid.ring(0)]
    lines = []
    for lid in (grid.upper, grid.lower):
        own = lid.copy()
        own[grid.corners] = True
        lines.append(_in_order(grid, own))
    upper, lower = (margin[line] for line in lines)
    return max(float(_to_line(upper, lower).max()), float(_to_line(lower, upper).max()))


def _in_order(grid: Grid, own: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Return columns of one lid from corner to corner, around the ring."""
    first, last = sorted(grid.corners.tolist())
    inside = np.arange(first, last + 1)
    around = np.concatenate([np.arange(last, len(own)), np.arange(0, first + 1)])
    return inside if own[inside].all() else around


def _to_line(points: Array, line: Array) -> Array:
    """Return (N,) distances of points from a polyline (M, 3)."""
    start, way = line[:-1], np.diff(line, axis=0)
    share = np.einsum("nmc,mc->nm", points[:, None] - start, way) / np.maximum((way**2).sum(axis=1), 1e-18)
    nearest = start + np.clip(share, 0.0, 1.0)[..., None] * way
    return np.asarray(np.linalg.norm(points[:, None] - nearest, axis=2).min(axis=1))


def eyeball_protrusion_m(side: str, rest_m: Array, shape_m: Array) -> float:
    """Return how far an eyeball protrudes from its lids' skin, negative where skin covers it everywhere."""
    grid, ball = eye_grid(side), eyeball(rest_m, side)
    poles = shape_m[load_generic().part(f"eye_{side}")[[0, -1]]]
    gaze = (poles[0] - poles[1]) / np.linalg.norm(poles[0] - poles[1])
    rings = shape_m[grid.rings[grid.margin :]]
    share = np.linspace(0.0, 1.0, SAMPLES)
    beside = np.roll(rings, -1, axis=1)
    along = rings[:, :, None] + share[:, None] * (beside - rings)[:, :, None]
    skin = along[:-1, :, None] + share[:, None, None] * (along[1:] - along[:-1])[:, :, None]
    return float(-ball.outside(skin.reshape(-1, 3), gaze).min())


@functools.cache
def _front_skin() -> NDArray[np.int32]:
    """Return the (T, 3) triangles of the skin around the mouth, without what lies inside it."""
    generic, grid = load_generic(), mouth_grid()
    near = np.linalg.norm(generic.vertices_m - generic.vertices_m[generic.feature("stomion")], axis=1) < AROUND_M
    near &= generic.skin & ~generic.region("mouth_interior")
    near[grid.rings[: grid.margin]] = False
    near[grid.rings[grid.margin :]] = True
    triangles = load_triangles()
    return np.asarray(triangles[near[triangles].all(axis=1)])


def teeth_protrusion_m(shape_m: Array) -> float:
    """Return how far teeth protrude from the skin around the mouth, seen from the front; 0 where none do."""
    generic = load_generic()
    teeth = shape_m[np.concatenate([generic.part("teeth_upper"), generic.part("teeth_lower")])]
    corners = shape_m[_front_skin()]
    covers, u, v = overlaps_triangles(teeth[:, :2], corners[..., :2])
    depth = corners[:, 0, 2] + u * (corners[:, 1, 2] - corners[:, 0, 2]) + v * (corners[:, 2, 2] - corners[:, 0, 2])
    front = np.where(covers, depth, -np.inf).max(axis=1)
    covered = covers.any(axis=1)
    return float(np.maximum(teeth[covered, 2] - front[covered], 0.0).max(initial=0.0))


@functools.cache
def _lip_skin(upper: bool) -> NDArray[np.int32]:
    """Return the (T, 3) triangles of one lip, from behind its inner edge to its outer border."""
    grid, triangles = mouth_grid(), load_triangles()
    columns = (grid.upper if upper else grid.lower).copy()
    columns[grid.corners] = True
    own = np.zeros(int(triangles.max()) + 1, dtype=bool)
    own[grid.rings[:, columns]] = True
    return np.asarray(triangles[own[triangles].all(axis=1)])


def tongue_protrusion_m(shape_m: Array) -> float:
    """Return how far the tongue protrudes through a lip's skin.

    What lies hidden in a lip's flesh counts only where the tongue leaves it through the outer skin.
    """
    generic = load_generic()
    quads = generic.quads[generic.quad_part == generic.part_names.index("tongue")]
    edges = quads[:, [0, 1, 1, 2, 2, 3, 3, 0]].reshape(-1, 2)
    ends = np.vstack([edges, edges[:, ::-1]])
    worst = 0.0
    for upper in (False, True):
        corners = shape_m[_lip_skin(upper)]
        depth = np.zeros(len(shape_m))
        rows = generic.part("tongue")
        depth[rows] = _depth_in(corners, shape_m[rows], upper)
        before = np.zeros(len(shape_m), dtype=bool)
        skin_m = np.nan_to_num(_where_meets(corners, shape_m[rows], (0, 1, 2)), nan=-np.inf).max(axis=1)
        before[rows] = np.isfinite(skin_m) & (shape_m[rows, 2] > skin_m)
        out = depth[ends[:, 0]] * before[ends[:, 1]]
        worst = max(worst, float(out.max()))
    return worst


def _depth_in(corners: Array, points: Array, upper: bool) -> Array:
    """Return (N,) how deep points lie in a lip: an upright line away from the slit meets its skin once."""
    towards = -1.0 if upper else 1.0
    height = towards * (_where_meets(corners, points, (0, 2, 1)) - points[:, None, 1])
    above = np.where(height > 0.0, height, np.inf)
    inside = (np.isfinite(above).sum(axis=1) % 2) == 1
    away = np.linalg.norm(points[:, None] - corners.reshape(-1, 3)[None], axis=2).min(axis=1)
    return np.where(inside, np.minimum(above.min(axis=1), away), 0.0)


def _where_meets(corners: Array, points: Array, axes: tuple[int, int, int]) -> Array:
    """Return (N, T) where a line through each point along the last axis meets each triangle, metres; NaN where not."""
    i, j, k = axes
    a, one, two = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = one[:, i] * two[:, j] - one[:, j] * two[:, i]
    area = np.where(np.abs(area) < 1e-14, 1e-14, area)
    way = points[:, None] - a
    u = (way[..., i] * two[:, j] - way[..., j] * two[:, i]) / area
    v = (one[:, i] * way[..., j] - one[:, j] * way[..., i]) / area
    covers = (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0)
    return np.asarray(np.where(covers, a[:, k] + u * one[:, k] + v * two[:, k], np.nan))


def visible_teeth_m(shape_m: Array) -> float:
    """Return the height of the upper teeth that is visible between the lips in the middle."""
    generic, grid = load_generic(), mouth_grid()
    teeth = shape_m[generic.part("teeth_upper")]
    touching = shape_m[grid.rings[grid.margin - 1 : grid.margin + 2]]
    middle = np.abs(touching[1, :, 0] - teeth[:, 0].mean()) < 0.004
    upper = float(touching[:, middle & grid.upper, 1].min())
    lower = float(touching[:, middle & grid.lower, 1].max())
    edge = float(teeth[np.abs(teeth[:, 0] - teeth[:, 0].mean()) < 0.006, 1].min())
    return max(upper - max(edge, lower), 0.0)
