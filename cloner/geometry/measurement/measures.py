"""Girths of a body: convex hulls of plane slices, as a tape measure lies."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from cloner.geometry.meshes.triangles import triangle_sides
from cloner.records.arrays import Array, freeze

Triangles = NDArray[np.int32]

UP: Final = np.array([0.0, 1.0, 0.0])
#: Step of the searches for the largest and smallest girth, metres; below what a tape reads (5 mm).
SEARCH_STEP_M: Final = 0.004
#: The search goes in larger steps first: girths change slowly with the height.
SEARCH_STRIDE: Final = 4
#: Where the calf muscle lies between ankle (0) and knee (1).
CALF_SPAN: Final = (0.25, 0.85)


@dataclass(frozen=True, slots=True, eq=False)
class TapeRules:
    """The topology of a mesh that measures need; nothing about the person.

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

    def limbs(self, side: str) -> tuple[Triangles, Triangles, Triangles]:
        """Return the triangles of one side's leg, upper arm and forearm."""
        left = side == "left"
        leg, arm = (self.left_leg, self.left_arm) if left else (self.right_leg, self.right_arm)
        return leg, arm, self.left_forearm if left else self.right_forearm


def slice_points(vertices_m: Array, triangles: Triangles, point_m: Array, normal: Array) -> Array:
    """Return (N, 3) points where the triangles' edges cross a plane, metres.

    Parameters
    ----------
    vertices_m : (V, 3) model frame
    triangles : (T, 3) int32
    point_m : (3,) a point of the plane
    normal : (3,) the plane's direction, any length
    """
    return slice_values(vertices_m, vertices_m, triangles, point_m, normal)


def slice_values(values: Array, vertices_m: Array, triangles: Triangles, point_m: Array, normal: Array) -> Array:
    """Return (N, D) values (V, D) of the vertices where the triangles' edges cross a plane, as in `slice_points`."""
    side = (vertices_m - point_m) @ normal
    edges = triangle_sides(triangles)
    first, second = edges[:, 0], edges[:, 1]
    crossing = (side[first] < 0.0) != (side[second] < 0.0)
    first, second = first[crossing], second[crossing]
    share = side[first] / (side[first] - side[second])
    return np.asarray(values[first] + share[:, None] * (values[second] - values[first]))


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


@dataclass(frozen=True, slots=True, eq=False)
class Plane:
    """The plane of a tape around one part.

    Attributes
    ----------
    point_m, normal : (3,) float64
        Model frame.
    triangles : (T, 3) int32
        Of the part.
    segments : tuple of str
        The skin segments it goes round.
    """

    point_m: Array
    normal: Array
    triangles: Triangles
    segments: tuple[str, ...]

    def girth_mm(self, vertices_m: Array) -> float:
        """Return the girth in the plane, mm."""
        return girth_mm(vertices_m, self.triangles, self.point_m, self.normal)


#: Names of girths that the sample visitors' truth has, with their keys in the measures' table.
TRUTH_GIRTHS: Final = {
    "neck": "neck_girth",
    "chest": "bust_girth",
    "underbust": "underbust_girth",
    "waist": "navel_girth",
    "waist_min": "narrowest_waist_girth",
    "hip": "hip_girth",
    "thigh": "thigh_girth",
    "calf": "calf_girth",
    "upper_arm": "upper_arm_girth",
}
_TRUNK: Final = ("torso", "pelvis", "left_thigh", "right_thigh")


def girths_mm(vertices_m: Array, joints_m: Array, rules: TapeRules) -> dict[str, float]:
    """Return the girths of a body in rest pose by the names of `TRUTH_GIRTHS`, mm; sides are averaged.

    Parameters
    ----------
    vertices_m : (V, 3) model frame, metres
    joints_m : (94, 3) model frame, metres
    rules : TapeRules
    """
    planes = girth_planes(vertices_m, joints_m, rules)
    return {name: mean_girth_mm(vertices_m, planes[key]) for name, key in TRUTH_GIRTHS.items()}


def mean_girth_mm(vertices_m: Array, planes: Sequence[Plane]) -> float:
    """Return the mean girth of some planes, mm: both sides of a limb."""
    return float(np.mean([plane.girth_mm(vertices_m) for plane in planes]))


def girth_planes(
    vertices_m: Array, joints_m: Array, rules: TapeRules, keys: Collection[str] | None = None
) -> dict[str, tuple[Plane, ...]]:
    """Return the tape's planes on a body in rest pose by key of the measures' table; limbs have two.

    Parameters
    ----------
    vertices_m : (V, 3) model frame, metres
    joints_m : (94, 3) model frame, metres
    rules : TapeRules
    keys : collection of str, optional
        The girths that are wanted, all by default: hip, narrowest waist and calf have to be searched for.

    References
    ----------
    ISO 8559-1:2017, 5.3, in the wording of the project's reference table; the levels follow surface points that go
    with the person. The hip is the largest girth between crotch and navel, the narrowest waist the smallest from
    there to the underbust, the calf the largest below the knee.
    """

    def level(height_m: float, *segments: str) -> tuple[Plane, ...]:
        return (Plane(np.array([0.0, height_m, 0.0]), UP, rules.torso, segments or _TRUNK),)

    at = {name: float(vertices_m[list(rows), 1].mean()) for name, rows in rules.level_vertices.items()}
    found = {
        "head_girth": (_head_plane(vertices_m, rules),),
        "neck_girth": level(at["neck"], "head", "torso"),
        "bust_girth": level(at["chest"]),
        "underbust_girth": level(at["underbust"]),
        "waist_girth": level(at["natural_waist"]),
        "navel_girth": level(at["waist"]),
        **_limb_planes(vertices_m, joints_m, rules, with_calf=keys is None or "calf_girth" in keys),
    }
    if keys is None or {"hip_girth", "narrowest_waist_girth"} & set(keys):
        hip_m = _extreme(vertices_m, rules.torso, (float(vertices_m[rules.crotch, 1]), at["waist"]), np.argmax)
        found["hip_girth"] = level(hip_m)
        if keys is None or "narrowest_waist_girth" in keys:
            narrow_m = _extreme(vertices_m, rules.torso, (hip_m, at["underbust"]), np.argmin)
            found["narrowest_waist_girth"] = level(narrow_m)
    return {key: planes for key, planes in found.items() if keys is None or key in keys}


def _extreme(
    vertices_m: Array, triangles: Triangles, span_m: tuple[float, float], choose: Callable[[Array], np.intp]
) -> float:
    """Return the height of the largest or smallest girth between two heights; the upper one where there is none."""
    heights = np.arange(*span_m, SEARCH_STEP_M)
    if not len(heights):
        return span_m[1]
    corners = vertices_m[triangles, 1]
    near = triangles[(corners.max(axis=1) >= span_m[0]) & (corners.min(axis=1) <= span_m[1])]  # saves four fifths

    def best(rows: NDArray[np.intp]) -> int:
        levels = [np.array([0.0, heights[row], 0.0]) for row in rows]
        return int(rows[int(choose(np.array([girth_mm(vertices_m, near, level, UP) for level in levels])))])

    coarse = best(np.arange(0, len(heights), SEARCH_STRIDE))
    around = np.arange(max(coarse - SEARCH_STRIDE + 1, 0), min(coarse + SEARCH_STRIDE, len(heights)))
    return float(heights[best(around)])


def _head_plane(vertices_m: Array, rules: TapeRules) -> Plane:
    brow, skull = vertices_m[rules.points["glabella"]], vertices_m[rules.skull]
    rear = skull[np.argmin(skull[:, 2])]
    return Plane(brow, np.cross([1.0, 0.0, 0.0], rear - brow), rules.head, ("head",))


def _limb_planes(
    vertices_m: Array, joints_m: Array, rules: TapeRules, *, with_calf: bool
) -> dict[str, tuple[Plane, ...]]:
    """Return the planes of legs and arms: horizontal at thigh, knee and calf, else at right angles to the limb."""
    found: dict[str, list[Plane]] = {}
    for row, side in enumerate(("left", "right")):
        leg, arm, fore = rules.limbs(side)
        pairs = (rules.leg_joints, rules.arm_joints, rules.forearm_joints)
        shin, upper, lower = (joints_m[pair[row]] for pair in pairs)
        low_m, high_m = (float(shin[1, 1] + share * (shin[0, 1] - shin[1, 1])) for share in CALF_SPAN)
        heights = {
            "thigh_girth": float(vertices_m[list(rules.thigh_vertices[row]), 1].mean()),
            "knee_girth": float(vertices_m[rules.points[f"kneecap_{side}"], 1]),
        }
        if with_calf:
            heights["calf_girth"] = _extreme(vertices_m, leg, (low_m, high_m), np.argmax)
        bones = vertices_m[[rules.points[f"ankle_{where}_{side}"] for where in ("outer", "inner")]].mean(axis=0)
        wrist = vertices_m[rules.points[f"wrist_{side}"]]
        parts = {name: f"{side}_{name}" for name in ("thigh", "calf", "foot", "upper_arm", "forearm", "hand")}
        for key, height in heights.items():
            middle = shin[0] * [1.0, 0.0, 1.0] + [0.0, height, 0.0]
            found.setdefault(key, []).append(Plane(middle, UP, leg, (parts["thigh"], parts["calf"])))
        for key, point, pair, triangles, segments in (
            ("ankle_girth", bones, shin, leg, (parts["calf"], parts["foot"])),
            ("upper_arm_girth", upper.mean(axis=0), upper, arm, (parts["upper_arm"], parts["forearm"])),
            ("wrist_girth", wrist, lower, fore, (parts["forearm"], parts["hand"])),
        ):
            found.setdefault(key, []).append(Plane(point, pair[1] - pair[0], triangles, segments))
    return {key: tuple(planes) for key, planes in found.items()}


@dataclass(frozen=True, slots=True)
class Measure:
    """One girth and its uncertainty.

    Attributes
    ----------
    value_mm : float
    plus_minus_mm : float
        Nine in ten of such errors lie within it.
    """

    value_mm: float
    plus_minus_mm: float
