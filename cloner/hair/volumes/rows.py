"""Distances to where hair ends in each row of a photo: the hair's plan at that height."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.caching import cached_per_object
from cloner.frames import ViewId, mm_from_m
from cloner.hair.volumes.cap import FACE_PHOTO
from cloner.hair.volumes.pictures import FAR_MM
from cloner.hair.volumes.views import SIDES, HairView
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample
from cloner.vision.segmentation.pieces import box_around

ROUND_MM = 70.0  # half a head's width: thick hair between the sides that show it is as round as a head
LONGER = 1.25  # anatomy: heads are so much longer than wide, and so is hair of which no side photo tells


@cached_per_object
def across_px(hair: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return the distances (H, W, 2) to both ends of the hair in each row, px; zero outside.

    How far the pixel is from the nearer end of the hair in its row, and half of how far all hair of the row reaches: a
    face in front of it does not make it thinner.
    """
    across = np.zeros((*hair.shape, 2), np.float32)
    if hair.any():
        box = box_around(hair)
        bare = np.pad(~hair[box], ((0, 0), (1, 1)), constant_values=True)
        place = np.arange(bare.shape[1], dtype=np.int32)
        before = np.maximum.accumulate(np.where(bare, place, 0), axis=1)
        after = np.minimum.accumulate(np.where(bare, place, place[-1])[:, ::-1], axis=1)[:, ::-1]
        half = 0.5 * (bare.shape[1] - bare.argmin(axis=1) - bare[:, ::-1].argmin(axis=1))
        nearer = np.minimum(place - before, after - place) - 0.5
        across[box] = np.where(bare[..., None], 0.0, np.dstack([nearer, np.broadcast_to(half[:, None], bare.shape)]))[
            :, 1:-1
        ]
    return across


def rounded_mm(front: NDArray[np.float32], side: NDArray[np.float32], most_mm: float) -> NDArray[np.float32]:
    """Return the depth (N,) of points in a plan with round corners, mm.

    Hair is as round as it is thick: a head by half its width, a curtain down a back by half its own thickness.

    Parameters
    ----------
    front, side : (N, 2)
        What front and back photos, and what side photos tell (:func:`across_px`, mm); FAR_MM where none does.
    most_mm : float
        Largest radius of a corner.
    """
    radius = np.minimum(np.minimum(front[:, 1], side[:, 1]), np.float32(most_mm))
    away = sum(np.maximum(radius - across[:, 0], 0.0) ** 2 for across in (front, side))
    return np.asarray(radius - np.sqrt(away), np.float32)


def agreed_mm(
    views: list[HairView], points_m: Array, deep_m: tuple[float, float]
) -> tuple[NDArray[np.float32], NDArray[np.int64]]:
    """Return the depth (N,) of points in the hair on which photos of all sides agree, mm, and the number of sides.

    As `hull_mm`, but two photos of one side are heard together, the body's more, as its camera is known better: one may
    show the head displaced, one may have lost dark hair before a dark wall. Level by level the sides' cones meet in a
    round edge: a box is no hair. Upwards and downwards all photos see the same end: there nothing is rounded.
    Where front and back photos judge alone, neither tells how deep hair is: it is as round as a head.

    Parameters
    ----------
    views : list of HairView
    points_m : (N, 3)
    deep_m : (float, float)
        Where hair usually begins and ends from back to front (z), m.
    """
    sides, least = np.zeros(len(points_m), np.int64), np.full(len(points_m), np.float32(FAR_MM))
    aside_judged = np.zeros(len(points_m), np.bool_)
    plan = {aside: np.full((len(points_m), 2), np.float32(FAR_MM)) for aside in (False, True)}
    for names in SIDES:
        inside, across = np.full(len(points_m), np.float32(FAR_MM)), np.full_like(plan[True], FAR_MM)
        for mirrored in (False, True):
            (total, weight), wide = np.zeros((2, len(points_m)), np.float32), np.zeros_like(across)
            for view in views:
                if view.posed.view in names and (view.flip_m is not None) == mirrored:
                    posed, pixel = view.seen_at(points_m)
                    depth, before = view.evidence(points_m, (posed, pixel))
                    heard = before * np.float32(FACE_PHOTO if view.posed.view.is_face else 1.0)
                    total += heard * np.clip(depth, -ROUND_MM, ROUND_MM)
                    rows_mm = sample(across_px(view.hair), pixel) * np.float32(view.pixel_mm(posed))
                    wide += heard[:, None] * np.minimum(rows_mm, ROUND_MM)
                    weight += heard
            known, mean = weight > 0.0, np.maximum(weight, 1e-6)
            inside = np.where(known, np.minimum(inside, total / mean), inside)
            across = np.where(known[:, None], np.minimum(across, wide / mean[:, None]), across)
        judged = inside < FAR_MM
        sides, least = sides + judged, np.minimum(least, inside)
        aside = ViewId.BODY_SIDE in names  # front and back tell the same ends: as two they would round twice
        aside_judged |= judged & aside
        plan[aside] = np.where(judged[:, None], np.minimum(plan[aside], across), plan[aside])
    usual = (sides > 1) & ~aside_judged
    half = np.minimum(mm_from_m(deep_m[1] - deep_m[0]) / 2.0, LONGER * plan[False][usual, 1])
    inside = half - mm_from_m(1.0) * np.abs(points_m[usual, 2] - (deep_m[0] + deep_m[1]) / 2.0)
    plan[True][usual] = np.column_stack([inside, half])
    least[usual] = np.minimum(least[usual], inside)
    return np.where(
        sides > 0, np.minimum(least, rounded_mm(plan[False], plan[True], ROUND_MM)), np.float32(-FAR_MM)
    ), sides
