"""Lengths of a body: heights, breadths and distances over the skin, as a tape lies."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from cloner.geometry.measurement.measures import UP, TapeRules, slice_points
from cloner.records.arrays import Array

BACK: Final = np.array([0.0, 0.0, -1.0])
#: From shoulder to nape the tape lies on the back; straight up from the line between them it would climb the neck.
BEHIND_SHOULDERS: Final = np.array([0.0, 0.3, -1.0])
#: Half the width of the strip in which the chest's depth is looked for, metres.
MIDDLE_M: Final = 0.015
#: The ears end below this height above their tops, metres.
ABOVE_EARS_M: Final = 0.012
FINGER: Final = ("wrist", "middle1", "middle2", "middle3")


def tape_path_mm(
    vertices_m: Array, triangles: NDArray[np.int32], ends_m: Array, outward: Array, *, beyond: bool = False
) -> float:
    """Return the length of a tape laid over the skin from one point to another, mm; it bridges hollows.

    The skin is cut by the plane through both points and the outward direction; the tape is the convex
    hull of what lies outward of the straight line.

    Parameters
    ----------
    vertices_m : (V, 3) model frame
    triangles : (T, 3) int32
    ends_m : (2, 3) both ends of the tape
    outward : (3,) direction from the straight line to the skin
    beyond : bool
        Whether the tape may reach beyond its ends on its way, as round the seat.
    """
    start, end = ends_m
    span = float(np.linalg.norm(end - start))
    along = (end - start) / max(span, 1e-9)
    away = outward - (outward @ along) * along
    away = away / max(float(np.linalg.norm(away)), 1e-9)
    points = slice_points(vertices_m, triangles, start, np.cross(along, away))
    flat = np.stack([(points - start) @ along, (points - start) @ away], axis=1)
    flat = flat[flat[:, 1] > 0.0]
    if not beyond:
        flat = flat[(flat[:, 0] > 0.0) & (flat[:, 0] < span)]
    flat = np.vstack([flat, [[0.0, 0.0], [span, 0.0]]])
    try:
        hull = flat[ConvexHull(flat).vertices]
    except (QhullError, ValueError):  # nothing lies outward: the tape is straight
        return 1e3 * span
    return 1e3 * (float(np.linalg.norm(hull - np.roll(hull, 1, axis=0), axis=1).sum()) - span)


def lengths_mm(
    vertices_m: Array, joints_m: Array, rules: TapeRules, levels_m: Mapping[str, float], floor_m: float = 0.0
) -> dict[str, float]:
    """Return the lengths of a body in rest pose by key of the measures' table, mm; sides are averaged.

    Parameters
    ----------
    vertices_m : (V, 3) model frame, metres
    joints_m : (94, 3)
    rules : TapeRules
    levels_m : mapping of str to float
        Heights of bust, waist and hip as the girths have them.
    floor_m : float
        Height of the naked soles.

    References
    ----------
    ISO 8559-1:2017, 5.1 to 5.7, in the wording of the project's reference table. Arms hang apart in the rest pose, so
    lengths over the shoulder are those of a person with arms a little raised.
    """
    point = {name: vertices_m[row] for name, row in rules.points.items()}

    def both(name: str) -> tuple[Array, Array]:
        return point[f"{name}_left"], point[f"{name}_right"]

    def height(*names: str) -> float:
        return 1e3 * (float(np.mean([point[name][1] for name in names])) - floor_m)

    acromia, nape = both("acromion"), point["nape"]
    return {
        "back_neck_height": height("nape"),
        "shoulder_height": height("acromion_left", "acromion_right"),
        "waist_height": 1e3 * (levels_m["waist"] - floor_m),
        "hip_height": 1e3 * (levels_m["hip"] - floor_m),
        "inside_leg_height": height("crotch"),
        "knee_height": height("kneecap_left", "kneecap_right"),
        "shoulder_width": sum(
            tape_path_mm(vertices_m, rules.skin, np.array([tip, nape]), BEHIND_SHOULDERS) for tip in acromia
        ),
        "biacromial_breadth": 1e3 * float(np.linalg.norm(acromia[0] - acromia[1])),
        "chest_depth": _chest_depth(vertices_m, rules, levels_m["bust"]),
        "arm_length": float(np.mean([_arm_length(vertices_m, rules, point, side) for side in ("left", "right")])),
        "back_waist_length": tape_path_mm(vertices_m, rules.torso, np.array([nape, point["waist_back"]]), BACK),
        "total_crotch_length": tape_path_mm(
            vertices_m, rules.skin, np.array([point["waist_front"], point["waist_back"]]), -UP, beyond=True
        ),
        **_head(vertices_m, rules, point),
        "hand_length": float(np.mean([_hand(joints_m, rules, point, side) for side in ("left", "right")])),
        "foot_length": float(np.mean([_foot(vertices_m, rules, point, side) for side in ("left", "right")])),
    }


def _chest_depth(vertices_m: Array, rules: TapeRules, level_m: float) -> float:
    ring = slice_points(vertices_m, rules.torso, np.array([0.0, level_m, 0.0]), UP)
    middle = ring[np.abs(ring[:, 0]) < MIDDLE_M]
    return 1e3 * float(np.ptp(middle[:, 2])) if len(middle) else 0.0


def _arm_length(vertices_m: Array, rules: TapeRules, point: Mapping[str, Array], side: str) -> float:
    """Return shoulder over elbow to wrist; the arm's outside is where it bends away from."""
    tip, elbow, wrist = (point[f"{name}_{side}"] for name in ("acromion", "elbow", "wrist"))
    outward = 2.0 * elbow - tip - wrist
    pieces = (np.array([tip, elbow]), np.array([elbow, wrist]))
    return sum(tape_path_mm(vertices_m, rules.skin, ends, outward) for ends in pieces)


def _head(vertices_m: Array, rules: TapeRules, point: Mapping[str, Array]) -> dict[str, float]:
    skull = vertices_m[rules.skull]
    rear = float(skull[:, 2].min())
    above = skull[skull[:, 1] > max(point["ear_left"][1], point["ear_right"][1]) + ABOVE_EARS_M]
    breadth = 1e3 * float(np.ptp(above[:, 0])) if len(above) else 0.0
    return {
        "head_length": 1e3 * float(point["glabella"][2] - rear),
        "head_breadth": breadth,
        "face_length": 1e3 * float(np.linalg.norm(point["nasion"] - point["chin"])),
    }


def _hand(joints_m: Array, rules: TapeRules, point: Mapping[str, Array], side: str) -> float:
    """Return the hand stretched out: the finger's joints one after another."""
    chain = np.vstack([joints_m[rules.finger_joints[0 if side == "left" else 1]], point[f"fingertip_{side}"]])
    return 1e3 * float(np.linalg.norm(np.diff(chain, axis=0), axis=1).sum())


def _foot(vertices_m: Array, rules: TapeRules, point: Mapping[str, Array], side: str) -> float:
    along = point[f"toe_{side}"] - point[f"heel_{side}"]
    along = along * [1.0, 0.0, 1.0]
    foot = vertices_m[rules.left_foot if side == "left" else rules.right_foot]
    return 1e3 * float(np.ptp(foot @ (along / max(float(np.linalg.norm(along)), 1e-9))))
