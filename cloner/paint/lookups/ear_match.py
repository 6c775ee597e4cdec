"""Alignment of the ear in a side photo by the hairline around it.

The head's shape is fitted to face and outlines; an ear a centimetre off is no
error of theirs, but painted there it shows twice. Above and behind, an ear
borders on hair: that border of the labels is laid on the ear's own.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.easing import smoothstep
from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.geometry.cameras.visibility import DEPTH_SCALE, Visibility
from cloner.geometry.meshes.graphs import surface_graph
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample

FARTHEST_MM, STEP_MM = 32.0, 2.0  # an ear farther off is a wrong head
RING_MM = 5.0  # hair is looked for this far outside the ear's border, skin this far inside
FORWARD = 0.2  # of the ear's size: what lies farther towards the face borders on no hair
LEAST_CONTRAST = 0.45  # share of hair outside less that inside; a covered or a bald man's ear has none
LEAST_GAIN = 0.08  # better than where the head has it by so much
SHIFT_PENALTY = 0.35  # for the farthest shift
SIZES = (1.0, 0.9, 0.8, 0.7)  # of the head's ear: outlines do not tell an ear's size
#: What an ear twice too large costs, and points compared at most (taste).
SIZE_PENALTY = 0.2
FADE_M = 0.04  # the shift dies away over this distance along the skin
MOST_POINTS = 300


@dataclass(frozen=True, slots=True, eq=False)
class _Rings:
    """Photo pixels just outside and inside an ear's upper and rear border, (N, 2) and (M, 2), and its middle (2,)."""

    outside_px: Array
    inside_px: Array
    middle_px: Array


def shift_ear(
    generic: GenericHuman,
    posed_m: Array,
    triangles: NDArray[np.int32],
    visibility: Visibility,
    hair: NDArray[np.bool_],
    view: ViewId,
    lookup_px: Array,
) -> Array:
    """Return the lookups (V, 2) of a side photo with the near ear aligned to the one in the photo.

    Parameters
    ----------
    posed_m : (V, 3) vertices as in the photo
    triangles : (T, 3) of the skin
    visibility : Visibility
    hair : (H, W) bool, label
    view : ViewId
        Others than the face's side are left alone: body photos show ears too small.
    lookup_px : (V, 2)
    """
    if view is not ViewId.FACE_SIDE or not hair.any():
        return lookup_px
    names = ("ear_left", "ear_right")
    own = generic.region(max(names, key=lambda name: float(visibility.cosine[generic.region(name)].mean())))
    pixel_mm = mm_from_m(visibility.metres_per_pixel * DEPTH_SCALE)
    nose_px = lookup_px[generic.feature("nose_tip")]
    rings = _ear_rings(lookup_px, triangles[own[triangles].all(axis=1)], nose_px, RING_MM / pixel_mm)
    if rings is None:
        return lookup_px
    fit = _best_fit(rings, cv2.blur(hair.astype(np.float32), (3, 3)), pixel_mm)
    if fit is None:
        return lookup_px
    size, shift = fit
    graph = surface_graph(posed_m, triangles)
    share = smoothstep(1.0 - graph.distance_from(own, FADE_M) / FADE_M)
    moved = rings.middle_px + size * (lookup_px - rings.middle_px) + shift
    return np.asarray(lookup_px + share[:, None] * (moved - lookup_px))


def _ear_rings(lookup_px: Array, triangles: NDArray[np.int32], nose_px: Array, width_px: float) -> _Rings | None:
    """Return pixels on both sides of the ear's upper and rear border, None when it is too small."""
    points = lookup_px[np.unique(triangles)]
    air = int(width_px) + 3
    low = np.floor(points.min(axis=0)).astype(int) - air
    size = np.ceil(points.max(axis=0)).astype(int) + air - low
    picture = np.zeros((size[1], size[0]), np.uint8)
    for corners in np.rint(16.0 * (lookup_px - low)).astype(np.int32)[triangles]:
        cv2.fillConvexPoly(picture, corners, 255, shift=4)
    reach = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * int(np.ceil(width_px)) + 1,) * 2)
    rings = [cv2.dilate(picture, reach) > picture, picture > cv2.erode(picture, reach)]
    middle = points.mean(axis=0)
    extent = float(np.ptp(points, axis=0).max())
    forward = np.sign(nose_px[0] - middle[0])
    found = []
    for ring in rings:
        row, column = np.nonzero(ring)
        place = np.column_stack([column, row]) + low
        ahead = forward * (place[:, 0] - middle[0]) / extent
        below = (place[:, 1] - middle[1]) / extent
        chosen = place[(ahead < FORWARD) & (below < FORWARD)].astype(float)
        found.append(chosen[:: max(len(chosen) // MOST_POINTS, 1)])
    return _Rings(found[0], found[1], middle) if min(len(each) for each in found) > 20 else None


def _best_fit(rings: _Rings, hair: NDArray[np.float32], pixel_mm: float) -> tuple[float, Array] | None:
    """Return size and shift (2,), px, at which hair begins at the ear's border; None when none is convincing."""
    steps = np.arange(-FARTHEST_MM, FARTHEST_MM + STEP_MM / 2.0, STEP_MM)
    shifts = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    shifts = shifts[np.linalg.norm(shifts, axis=1) <= FARTHEST_MM]
    cost = SHIFT_PENALTY * (np.linalg.norm(shifts, axis=1) / FARTHEST_MM) ** 2
    here = _contrast(rings, hair, 1.0, np.zeros((1, 2)))[0]
    best: tuple[float, float, float, Array] = (here + LEAST_GAIN, here, 1.0, np.zeros(2))
    for size in SIZES:
        contrast = _contrast(rings, hair, size, shifts / pixel_mm)
        score = contrast - cost - SIZE_PENALTY * abs(size - 1.0)
        place = int(score.argmax())
        if score[place] > best[0]:
            best = (float(score[place]), float(contrast[place]), size, shifts[place] / pixel_mm)
    return (best[2], best[3]) if best[3].any() and best[1] > LEAST_CONTRAST else None


def _contrast(rings: _Rings, hair: NDArray[np.float32], size: float, shifts_px: Array) -> Array:
    """Return how much more hair (S,) lies outside the ear's border than inside it."""
    found = []
    for ring in (rings.outside_px, rings.inside_px):
        place = rings.middle_px + size * (ring - rings.middle_px)
        where = (place[None] + shifts_px[:, None]).reshape(-1, 2)
        found.append(sample(hair, where).reshape(len(shifts_px), len(ring)).mean(axis=1))
    return np.asarray(found[0] - found[1], np.float64)
