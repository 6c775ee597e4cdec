"""Measures of a body under construction, and their derivatives by the body's modes."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from cloner.generic.load import load_generic
from cloner.geometry.measurement.lengths import lengths_mm
from cloner.geometry.measurement.measures import UP, Plane, TapeRules, girth_planes, mean_girth_mm
from cloner.geometry.meshes.triangles import triangle_sides
from cloner.records.arrays import Array

Modes = NDArray[np.floating]

#: Step of the numerical slopes, standard deviations.
STEP = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class Reading:
    """A body's measures.

    Attributes
    ----------
    mm : mapping of str to float
    planes : mapping of str to tuple of Plane
    """

    mm: Mapping[str, float]
    planes: Mapping[str, tuple[Plane, ...]]


def tapes(
    vertices_m: Array, joints_m: Array, rules: TapeRules, keys: Collection[str], *, seat: bool
) -> dict[str, tuple[Plane, ...]]:
    """Return the tape planes of each girth; with ``seat`` the hip's plane is over the buttocks, wherever it is widest.

    The product's ruler takes the widest between crotch and navel, which is the belly where the waist exceeds the hips.
    """
    if not seat or "hip_girth" not in keys:
        return girth_planes(vertices_m, joints_m, rules, keys)
    found = girth_planes(vertices_m, joints_m, rules, [key for key in keys if key != "hip_girth"])
    generic = load_generic()
    rows = [generic.feature(f"buttock_{side}") for side in ("left", "right")]
    level = np.array([0.0, float(vertices_m[rows, 1].mean()), 0.0])
    return found | {"hip_girth": (Plane(level, UP, rules.torso, ("torso", "pelvis", "left_thigh", "right_thigh")),)}


def read(
    vertices_m: Array,
    joints_m: Array,
    rules: TapeRules,
    keys: Collection[str],
    floor_m: float = 0.0,
    *,
    seat: bool = False,
) -> Reading:
    """Return girths and lengths of a body, as :func:`cloner.geometry.measurement.measuring.measures_mm` gives them.

    Parameters
    ----------
    vertices_m, joints_m : (V, 3) and (94, 3)
    rules : TapeRules
    keys : collection of str
        Those that are wanted; of `cloner.bodies.telling`.
    floor_m : float
        Height of the naked soles.
    seat : bool
        As for :func:`tapes`.
    """
    planes = tapes(vertices_m, joints_m, rules, keys, seat=seat)
    mm = {key: mean_girth_mm(vertices_m, own) for key, own in planes.items()}
    if not set(keys) <= set(mm):
        waist_m = float(vertices_m[list(rules.level_vertices["natural_waist"]), 1].mean())
        levels = {"bust": 0.0, "waist": waist_m, "hip": 0.0}
        mm |= lengths_mm(vertices_m, joints_m, rules, levels, floor_m)
    return Reading({key: mm[key] for key in keys}, planes)


def girth_slopes(vertices_m: Array, modes_m: Modes, planes: Iterable[Plane], level_modes_m: Array) -> Array:
    """Return the derivatives (C,) of a girth, mm, by each mode, with fixed hull corners: exact for small steps.

    Parameters
    ----------
    vertices_m : (V, 3)
    modes_m : (C, V, 3)
    planes : iterable of Plane
        Both sides' for limbs.
    level_modes_m : (C,)
        How far the plane goes up with each mode, metres.
    """
    found = [_hull_slopes(vertices_m, modes_m, plane, level_modes_m) for plane in planes]
    return np.asarray(np.mean(found, axis=0))


def _hull_slopes(vertices_m: Array, modes_m: Modes, plane: Plane, level_modes_m: Array) -> Array:
    axis = plane.normal / np.linalg.norm(plane.normal)
    side = (vertices_m - plane.point_m) @ axis
    triangles = plane.triangles
    edges = triangle_sides(triangles)
    edges = edges[(side[edges[:, 0]] < 0.0) != (side[edges[:, 1]] < 0.0)]
    across = np.cross(axis, [1.0, 0.0, 0.0] if abs(axis[0]) < 0.9 else [0.0, 0.0, 1.0])
    across /= np.linalg.norm(across)
    frame = np.stack([across, np.cross(axis, across)], axis=1)
    if len(edges) < 3:
        return np.zeros(len(modes_m))
    try:
        hull = ConvexHull(_crossings(vertices_m[edges][None], plane.point_m, axis, np.zeros(1))[0] @ frame).vertices
    except QhullError:
        return np.zeros(len(modes_m))
    corners = vertices_m[edges[hull]]
    moved = corners[None] + STEP * np.asarray(modes_m[:, edges[hull]], dtype=np.float64)
    both = np.concatenate([corners[None], moved])
    rise = np.concatenate([[0.0], STEP * level_modes_m * axis[1]])
    flat = _crossings(both, plane.point_m, axis, rise) @ frame
    around = np.linalg.norm(flat - np.roll(flat, 1, axis=1), axis=2).sum(axis=1) * 1e3
    return np.asarray((around[1:] - around[0]) / STEP)


def _crossings(ends_m: Array, point_m: Array, axis: Array, rise_m: Array) -> Array:
    """Return the intersections (B, E, 3) of edges (B, E, 2, 3) with planes shifted by ``rise_m`` (B,)
    along the axis.
    """
    side = (ends_m - point_m) @ axis - rise_m[:, None, None]
    gap = side[..., 0] - side[..., 1]
    share = side[..., 0] / np.where(np.abs(gap) < 1e-9, 1e-9, gap)
    return np.asarray(ends_m[..., 0, :] + share[..., None] * (ends_m[..., 1, :] - ends_m[..., 0, :]))


def level_slopes(modes_m: Modes, rules: TapeRules, key: str) -> Array:
    """Return the derivatives (C,) of a girth's level by each mode, metres; 0 where the level is searched for."""
    names = {
        "neck_girth": "neck", "bust_girth": "chest", "underbust_girth": "underbust", "navel_girth": "waist",
        "waist_girth": "natural_waist",
    }  # fmt: skip
    rows: list[int] = []
    if key in names:
        rows = list(rules.level_vertices[names[key]])
    elif key == "thigh_girth":
        rows = [row for side in rules.thigh_vertices for row in side]
    elif key == "knee_girth":
        rows = [rules.points["kneecap_left"], rules.points["kneecap_right"]]
    if not rows:
        return np.zeros(len(modes_m))
    return np.asarray(modes_m[:, rows, 1].mean(axis=1), dtype=np.float64)


def length_slopes(vertices_m: Array, modes_m: Modes, rules: TapeRules, key: str) -> Array:
    """Return the derivatives (C,) of a length, mm, by each mode, along straight lines between its points."""
    still = _straight_mm(vertices_m[None], rules, key)[0]
    rows = _rows(rules, key)
    moved = vertices_m[None, rows] + np.asarray(modes_m[:, rows], dtype=np.float64)
    return np.asarray(_straight_of(moved, key) - still)


def _rows(rules: TapeRules, key: str) -> list[int]:
    point = rules.points
    names = {
        "back_neck_height": ("nape",), "inside_leg_height": ("crotch",),
        "knee_height": ("kneecap_left", "kneecap_right"),
        "shoulder_width": ("acromion_left", "nape", "acromion_right"),
        "arm_length": ("acromion_left", "elbow_left", "wrist_left"),
    }  # fmt: skip
    if key == "waist_height":
        return list(rules.level_vertices["natural_waist"])
    return [point[name] for name in names[key]]


def _straight_mm(vertices_m: Array, rules: TapeRules, key: str) -> Array:
    return _straight_of(vertices_m[:, _rows(rules, key)], key)


def _straight_of(points_m: Array, key: str) -> Array:
    if key.endswith("_height"):
        return np.asarray(1e3 * points_m[..., 1].mean(axis=1))
    return np.asarray(1e3 * np.linalg.norm(np.diff(points_m, axis=1), axis=2).sum(axis=1))
