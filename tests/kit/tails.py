"""A toy clone with hair of known shape hanging behind its head, or with a skirt."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.records.clones import Clone
from cloner.records.heads import Shell
from kit.clones import HAIR

#: The tail's course behind the head, metres: from the scalp back, then straight down.
BACK_M, DOWN_M, RADIUS_M = 0.07, 0.24, 0.02
_AROUND, _STEP_M = 12, 0.005


def with_tail(clone: Clone, *, breadth: float = 1.0) -> Clone:
    """Return the clone whose hair is a tail alone, so many times as broad from side to side as deep."""
    generic = load_generic()
    scalp = clone.vertices_m[generic.region("scalp")]
    start = scalp[scalp[:, 2].argmin()]
    corner = start - (0.0, 0.0, BACK_M)
    back = np.linspace(start, corner, round(BACK_M / _STEP_M))[:-1]
    course = np.vstack([back, np.linspace(corner, corner - (0.0, DOWN_M, 0.0), round(DOWN_M / _STEP_M))])
    angle = np.linspace(0.0, 2.0 * np.pi, _AROUND, endpoint=False)
    way = np.gradient(course, axis=0)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    aside = np.array([1.0, 0.0, 0.0])
    other = np.cross(way, aside)
    rings = course[:, None] + RADIUS_M * (
        breadth * np.cos(angle)[None, :, None] * aside + np.sin(angle)[None, :, None] * other[:, None]
    )
    points = rings.reshape(-1, 3)
    rgba = np.tile(np.array([*HAIR, 255], np.uint8), (8, 8, 1))
    skull = np.tile(np.array([generic.joint("skullbase"), 0, 0, 0], np.int32), (len(points), 1))
    weights = np.tile([1.0, 0.0, 0.0, 0.0], (len(points), 1))
    tube = Shell(points, _tube(len(course)), np.full((len(points), 2), 0.5), skull, weights, rgba)
    return replace(clone, shells=(tube,))


def with_skirt(clone: Clone, *, length_m: float = 0.45, around: int = 48) -> Clone:
    """Return the clone in a cone of cloth, so long below the hip joints, carried by trunk and legs."""
    generic = load_generic()
    left, right, waist = (clone.joints_m[generic.joint(name)] for name in ("l_hip", "r_hip", "vl3"))
    middle = 0.5 * (left + right)
    heights = np.linspace(waist[1], middle[1] - length_m, round((waist[1] - middle[1] + length_m) / _STEP_M))
    angle = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)
    radii = np.linspace(0.19, 0.30, len(heights))
    points = np.stack([middle[0] + radii[:, None] * np.sin(angle), np.repeat(heights[:, None], around, axis=1),
                       middle[2] + radii[:, None] * np.cos(angle)], axis=-1).reshape(-1, 3)  # fmt: skip
    legs = np.clip((middle[1] + 0.05 - points[:, 1]) / 0.15, 0.0, 0.9)
    aside = np.clip(0.5 + (points[:, 0] - middle[0]) / (left[0] - right[0]), 0.0, 1.0)
    weights = np.column_stack([1.0 - legs, legs * aside, legs * (1.0 - aside), np.zeros(len(points))])
    joints = [generic.joint(name) for name in ("sacroiliac", "l_hip", "r_hip", "sacroiliac")]
    rgba = np.tile(np.array([40, 60, 120, 255], np.uint8), (8, 8, 1))
    carried = np.tile(np.array(joints, np.int32), (len(points), 1))
    uv, triangles = np.full((len(points), 2), 0.5), _tube(len(heights), around)
    return replace(clone, shells=(*clone.shells, Shell(points, triangles, uv, carried, weights, rgba, "cloth")))


def _tube(rows: int, around: int = _AROUND) -> NDArray[np.int32]:
    """Return the triangles of rings one after another."""
    row, column = (x.ravel() for x in np.meshgrid(np.arange(rows - 1), np.arange(around), indexing="ij"))
    here, after = row * around + column, row * around + (column + 1) % around
    quads = np.column_stack([here, after, after + around, here + around])
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.int32)
