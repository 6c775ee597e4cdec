"""Girths of a body: convex hulls of plane slices, as a tape measure lies."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from cloner.records.arrays import freeze

Array = NDArray[np.float64]
Triangles = NDArray[np.int32]

UP: Final = np.array([0.0, 1.0, 0.0])
#: Step of the searches for the largest and smallest girth, metres; below what a tape reads (5 mm).
SEARCH_STEP_M: Final = 0.004
#: Where the calf muscle lies between ankle (0) and knee (1).
CALF_SPAN: Final = (0.25, 0.85)


@dataclass(frozen=True, slots=True, eq=False)
class TapeRules:
    """What the measures need to know of a mesh's topology; nothing of the person.

    Attributes
    ----------
    skin, torso, left_leg, right_leg, left_arm, right_arm, left_forearm, right_forearm, head : (T, 3) int32
        Triangles of the parts; the torso is everything without the arms, an arm is the upper arm.
    left_foot, right_foot, skull : (N,) int32
        Vertices of the feet, and of the head behind and above the ears.
    level_vertices : mapping of str to tuple of int
        For neck, chest, underbust, waist (the navel's level) and natural_waist: the vertices whose mean height is
        the level.
    thigh_vertices : tuple of tuple of int
        The same for the left and the right thigh.
    points : mapping of str to int
        Vertices of named places, sides as ``_left`` and ``_right``.
    crotch : int
        Vertex of the crotch.
    arm_joints, forearm_joints, thigh_joints, leg_joints : (2, 2) int
        Joint numbers, left and right: shoulder and elbow, elbow and wrist, hip and knee, knee and ankle.
    finger_joints : (2, 4) int
        Wrist and the middle finger's joints.
    """

    skin: Triangles
    torso: Triangles
    left_leg: Triangles
    right_leg: Triangles
    left_arm: Triangles
    right_arm: Triangles
    left_forearm: Triangles
    right_forearm: Triangles
    head: Triangles
    left_foot: NDArray[np.int32]
    right_foot: NDArray[np.int32]
    skull: NDArray[np.int32]
    level_vertices: dict[str, tuple[int, ...]]
    thigh_vertices: tuple[tuple[int, ...], tuple[int, ...]]
    points: dict[str, int]
    crotch: int
    arm_joints: NDArray[np.int32]
    forearm_joints: NDArray[np.int32]
    thigh_joints: NDArray[np.int32]
    leg_joints: NDArray[np.int32]
    finger_joints: NDArray[np.int32]

    def __post_init__(self) -> None:
        parts = ("skin", "torso", "left_leg", "right_leg", "left_arm", "right_arm", "left_forearm", "right_forearm")
        triangles = {name: (np.int32, (None, 3)) for name in (*parts, "head")}
        rows = {name: (np.int32, (None,)) for name in ("left_foot", "right_foot", "skull")}
        joints = {name: (np.int32, (2, 2)) for name in ("arm_joints", "forearm_joints", "thigh_joints", "leg_joints")}
        freeze(self, **triangles, **rows, **joints, finger_joints=(np.int32, (2, 4)))


def slice_points(vertices_m: Array, triangles: Triangles, point_m: Array, normal: Array) -> Array:
    """Return (N, 3) points where the triangles' edges cross a plane, metres.

    Parameters
    ----------
    vertices_m : (V, 3) model frame
    triangles : (T, 3) int32
    point_m : (3,) a point of the plane
    normal : (3,) the plane's direction, any length
    """
    side = (vertices_m - point_m) @ normal
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    first, second = edges[:, 0], edges[:, 1]
    crossing = (side[first] < 0.0) != (side[second] < 0.0)
    first, second = first[crossing], second[crossing]
    share = side[first] / (side[first] - side[second])
    return np.asarray(vertices_m[first] + share[:, None] * (vertices_m[second] - vertices_m[first]))


def girth_mm(vertices_m: Array, triangles: Triangles, point_m: Array, normal: Array) -> float:
    """Return the perimeter of the convex hull of a plane slice, mm; 0.0 where the plane misses.

    References
    ----------
    ISO 8559-1:2017, section 5.3: the tape bridges hollows, so the hull is its path.
    """
    points = slice_points(vertices_m, triangles, point_m, normal)
    if len(points) < 3:
        return 0.0
    axis = normal / np.linalg.norm(normal)
    across = np.cross(axis, [1.0, 0.0, 0.0] if abs(axis[0]) < 0.9 else [0.0, 0.0, 1.0])
    across /= np.linalg.norm(across)
    flat = np.stack([points @ across, points @ np.cross(axis, across)], axis=1)
    try:
        hull = flat[ConvexHull(flat).vertices]
    except QhullError:  # all points on one line: a plane that only grazes
        return 0.0
    return float(np.linalg.norm(hull - np.roll(hull, 1, axis=0), axis=1).sum() * 1e3)


def girths_mm(vertices_m: Array, joints_m: Array, rules: TapeRules) -> dict[str, float]:
    """Return the girths of a body in rest pose by name, mm.

    Parameters
    ----------
    vertices_m : (V, 3) model frame, metres
    joints_m : (94, 3) model frame, metres
    rules : TapeRules

    Returns
    -------
    dict
        neck, chest, underbust, waist (navel), hip (largest between crotch and
        waist), waist_min (smallest between hip and underbust), thigh, calf
        (largest below the knee), upper_arm (across the arm's middle); limbs
        are the mean of both sides.

    References
    ----------
    ISO 8559-1:2017, 5.3; the levels follow surface points that go with the person.
    """

    def around(triangles: Triangles) -> Callable[[float], float]:
        return lambda height: girth_mm(vertices_m, triangles, np.array([0.0, height, 0.0]), UP)

    torso = around(rules.torso)
    level = {name: float(vertices_m[list(rules.level_vertices[name]), 1].mean()) for name in _FIXED_LEVELS}
    found = {name: torso(height) for name, height in level.items()}
    hip_m = hip_level_m(vertices_m, rules)
    found["hip"] = torso(hip_m)
    found["waist_min"] = min(torso(height) for height in np.arange(hip_m, level["underbust"], SEARCH_STEP_M))
    legs = (around(rules.left_leg), around(rules.right_leg))
    thighs = [
        leg(float(vertices_m[list(rows), 1].mean())) for leg, rows in zip(legs, rules.thigh_vertices, strict=True)
    ]
    found["thigh"] = float(np.mean(thighs))
    found["calf"] = float(
        np.mean([_calf(leg, joints_m[pair]) for leg, pair in zip(legs, rules.leg_joints, strict=True)])
    )
    arms = zip((rules.left_arm, rules.right_arm), rules.arm_joints, strict=True)
    found["upper_arm"] = float(np.mean([_arm(vertices_m, arm, joints_m[pair]) for arm, pair in arms]))
    return {name: found[name] for name in GIRTH_NAMES}


def hip_level_m(vertices_m: Array, rules: TapeRules) -> float:
    """Return the height of the largest girth between crotch and navel, metres."""
    navel_m = float(vertices_m[list(rules.level_vertices["waist"]), 1].mean())
    heights = np.arange(vertices_m[rules.crotch, 1], navel_m, SEARCH_STEP_M)
    if not len(heights):
        return navel_m
    girths = [girth_mm(vertices_m, rules.torso, np.array([0.0, height, 0.0]), UP) for height in heights]
    return float(heights[int(np.argmax(girths))])


_FIXED_LEVELS: Final = ("neck", "chest", "underbust", "waist")
GIRTH_NAMES: Final = ("neck", "chest", "underbust", "waist", "waist_min", "hip", "thigh", "calf", "upper_arm")


def _calf(leg: Callable[[float], float], knee_and_ankle: Array) -> float:
    knee, ankle = knee_and_ankle[:, 1]
    low, high = (ankle + share * (knee - ankle) for share in CALF_SPAN)
    return max(leg(height) for height in np.arange(low, high, SEARCH_STEP_M))


def _arm(vertices_m: Array, triangles: Triangles, shoulder_and_elbow: Array) -> float:
    shoulder, elbow = shoulder_and_elbow
    return girth_mm(vertices_m, triangles, (shoulder + elbow) / 2, elbow - shoulder)


@dataclass(frozen=True, slots=True)
class Girth:
    """One girth and its uncertainty.

    Attributes
    ----------
    value_mm : float
    plus_minus_mm : float
        One standard deviation.
    """

    value_mm: float
    plus_minus_mm: float


#: A tape's level is found to about a finger's breadth, where a girth changes by half of it; taste.
LEVEL_SLIP_MM: Final = 5.0


def widened(girth: Girth, outline_residual_mm: float, stature_share: float = 0.0) -> Girth:
    """Return a girth with the uncertainty that this person's photos add.

    Independent causes are added as squares: what clothes and shape leave open
    (the girth's own), both ends of two widths off by the outline's residual
    (``pi / 2 * sqrt(2 + 2)`` times it), the tape's level, and the scale.

    Parameters
    ----------
    girth : Girth
    outline_residual_mm : float
        Root mean square distance between the clone's and the photos' outlines.
    stature_share : float
        Relative uncertainty of the scale; 0 when the height was measured.
    """
    widths_mm = np.pi * outline_residual_mm
    parts = (girth.plus_minus_mm, widths_mm, LEVEL_SLIP_MM, stature_share * girth.value_mm)
    return Girth(girth.value_mm, float(np.linalg.norm(parts)))
