"""Profiles of random heads as a side camera sees them, and their joint model with named points.

Silhouettes of turned heads are no midlines: at 10 degrees the brow of the far side or a cheek comes forward. So every
head is projected through a camera of its own, drawn filled, and its outline walked from the forehead to the throat.
"""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from painted_people_bodies import waves

from cloner.generic.load import GenericHuman
from cloner.geometry.outlines.silhouette import vertex_normals

Array = NDArray[np.float64]

#: Points on the outline, from the forehead down, between which the curve's samples are spread evenly.
KNOTS: Final = ("nasion", "nose_tip", "subnasale", "stomion", "chin_front", "chin_bottom")
#: Samples from one knot to the next, the stretches before the first and behind the last included.
SAMPLES: Final = (22, 18, 24, 12, 16, 16, 12)
#: How far the curve reaches over the glabella and behind the chin's lowest point, metres.
OVER_M: Final = 0.025
BEHIND_M: Final = 0.018
#: Named points of a side photo; those with a side stand on the side that the camera sees.
NAMES: Final = (
    "glabella", "nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front", "chin_bottom",
    "eye_outer", "eye_upper", "eye_lower", "pupil", "ala", "mouth_corner", "ear_top", "ear_lobe", "ear_back",
    "ear_outer",
)  # fmt: skip
#: Inter-ocular distance that all heads are scaled to, metres.
IOD_M: Final = 0.063
TURN_DEG: Final = 10.0
DISTANCE_M: Final = (0.6, 2.0)
_PX_PER_M: Final = 4000.0
#: Bumps that no face of the family has, and the variety of faces as a factor on the population's.
BUMPS_M: Final = 0.0008
SPREAD: Final = 1.0


def random_face(generic: GenericHuman, rng: np.random.Generator) -> Array:
    """Return the vertices of a random head at 1.70 m with small bumps, metres."""
    vertices, _ = generic.shape(0.9 * rng.normal(size=generic.shape_basis.shape[0]), 1.70)
    vertices[generic.head_vertices] += np.tensordot(
        SPREAD * rng.normal(size=len(generic.face_basis)), generic.face_basis, axes=1
    )
    normals = vertex_normals(vertices, generic.triangles()[0])
    rough = BUMPS_M * generic.head_blend * waves(vertices, (0.03, 0.09), 40, rng)
    return np.asarray(vertices + rough[:, None] * normals)


def seen_from_side(vertices_m: Array, target_m: Array, rng: np.random.Generator) -> Array:
    """Return (V, 2) forward and up, metres at the target's depth, as a camera to the person's left sees them."""
    yaw, pitch = np.radians(rng.uniform(-TURN_DEG, TURN_DEG, 2))
    away = float(np.exp(rng.uniform(*np.log(DISTANCE_M))))
    out = np.array([np.cos(yaw) * np.cos(pitch), np.sin(pitch), np.sin(yaw) * np.cos(pitch)])
    right = np.cross(-out, [0.0, 1.0, 0.0])
    right /= np.linalg.norm(right)  # the person looks along +z, which lies to this camera's left
    up = np.cross(right, -out)
    centred = vertices_m - target_m
    depth = away - centred @ out
    return np.asarray(centred @ np.stack([-right, up], axis=1) * (away / depth)[:, None])


def outline(flat_m: Array, triangles: NDArray[np.integer]) -> Array:
    """Return the longest outline (N, 2) of filled triangles in the plane, metres."""
    low = flat_m[triangles].min(axis=(0, 1)) - 0.005
    pixels = np.round((flat_m - low) * _PX_PER_M).astype(np.int32)
    size = pixels[triangles].max(axis=(0, 1)) + 8
    mask = np.zeros((int(size[1]), int(size[0])), np.uint8)
    for corners in pixels[triangles]:
        cv2.fillConvexPoly(mask, corners, 1)
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    longest = max(contours, key=len)[:, 0].astype(np.float64)
    return longest / _PX_PER_M + low


def profile_of(flat_m: Array, triangles: NDArray[np.integer], row: dict[str, int]) -> Array | None:
    """Return the (120, 2) outline from over the glabella to behind the chin, spread evenly between the knots."""
    ring = outline(flat_m, triangles)
    ring = ring[np.lexsort((ring[:, 0], ring[:, 1]))[-1] - np.arange(len(ring))]  # start at the top, either way round
    tip = flat_m[row["nose_tip"]]
    at_tip = int(np.linalg.norm(ring - tip, axis=1).argmin())
    if at_tip > len(ring) // 2:
        ring, at_tip = ring[::-1], len(ring) - 1 - at_tip
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(ring, axis=0), axis=1))])
    start = int(np.flatnonzero(ring[:at_tip, 1] > flat_m[row["glabella"], 1] + OVER_M)[-1])
    knots = [start]
    for name in KNOTS:
        apart = np.linalg.norm(ring - flat_m[row[name]], axis=1)
        apart[: knots[-1] + 1] = np.inf
        apart[along > along[at_tip] + 0.16] = np.inf
        knots.append(int(apart.argmin()))
    knots.append(int(np.searchsorted(along, along[knots[-1]] + BEHIND_M)))
    if min(np.diff(knots)) < 3 or knots[-1] >= len(ring):
        return None
    marks = [
        np.linspace(along[a], along[b], count, endpoint=False)
        for a, b, count in zip(knots[:-1], knots[1:], SAMPLES, strict=True)
    ]
    even = np.concatenate(marks)
    return np.column_stack([np.interp(even, along, ring[:, k]) for k in range(2)])


def profile_shapes(generic: GenericHuman, rng: np.random.Generator, count: int) -> tuple[Array, Array]:
    """Return curves (N, M, 2) and named points (N, K, 2) of random heads, forward and up, metres.

    Heads are scaled to one inter-ocular distance, so that a laid profile tells it.
    """
    triangles, _ = generic.triangles()
    mean = generic.vertices_m
    head = mean[triangles, 1].min(axis=1) > mean[generic.feature("neck_front_base"), 1] + 0.01
    front = (np.abs(mean[triangles, 0]) < 0.065).all(axis=1)
    body = (generic.vertex_part[triangles] == generic.part_names.index("body")).all(axis=1)
    chosen = triangles[head & front & body]
    row = {n: generic.feature(n if n in generic.feature_names else f"{n}_L") for n in NAMES}
    curves, named = [], []
    while len(curves) < count:
        vertices = random_face(generic, rng)
        target = vertices[generic.feature("nasion")] - [0.0, 0.02, 0.06]
        flat = seen_from_side(vertices, target, rng)
        curve = profile_of(flat, chosen, row)
        if curve is not None:
            left, right = (vertices[generic.feature(f"pupil_{side}")] for side in "LR")
            unit = IOD_M / float(np.linalg.norm(left - right))
            curves.append(unit * curve)
            named.append(unit * flat[list(row.values())])
    return np.stack(curves), np.stack(named)


def joint_model(curves: Array, named: Array, modes: int) -> tuple[Array, Array, Array]:
    """Return mean (J, 2), modes (B, J, 2) and the residual spreads (J,) of curves and points together.

    Shapes are laid on each other by similarities of their curves; a mode times a standard normal number is a shape.
    """
    joint = np.concatenate([curves, named], axis=1)
    count = curves.shape[1]
    sizes = np.linalg.norm(joint[:, :count] - joint[:, :count].mean(axis=1, keepdims=True), axis=(1, 2))
    mean = joint[0] - joint[0, :count].mean(axis=0)
    for _ in range(4):
        mean = mean * (sizes.mean() / np.linalg.norm(mean[:count] - mean[:count].mean(axis=0)))
        fitted = np.stack([_laid(shape, mean, count) for shape in joint])
        mean = fitted.mean(axis=0)
    flat = (fitted - mean).reshape(len(fitted), -1)
    _, size, basis = np.linalg.svd(flat, full_matrices=False)
    kept = (size[:modes, None] / np.sqrt(len(flat))) * basis[:modes]
    rest = flat - (flat @ basis[:modes].T) @ basis[:modes]
    spread = np.sqrt((rest.reshape(fitted.shape) ** 2).mean(axis=(0, 2)))
    return mean, kept.reshape(modes, *mean.shape), spread


def _laid(shape: Array, mean: Array, count: int) -> Array:
    """Return a shape turned, scaled and moved so that its curve lies on the mean's."""
    source, target = shape[:count] @ [1, 1j], mean[:count] @ [1, 1j]
    away = source - source.mean()
    factor = (np.conj(away) @ (target - target.mean())) / (np.conj(away) @ away)
    moved = (shape @ [1, 1j] - source.mean()) * factor + target.mean()
    return np.column_stack([moved.real, moved.imag])
