"""Corrections of a person's mask by pose points: feet, and zones of spread fingers."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]
Points = NDArray[np.float64]
Bools = NDArray[np.bool_]

#: Pose rows (BlazePose) of ankle, heel and toe, and of wrist and knuckles.
FEET: Final = ((27, 29, 31), (28, 30, 32))
HANDS: Final = ((15, 17, 19, 21), (16, 18, 20, 22))
#: The rest of the body: strokes between joints, the trunk and the head as areas.
OTHERS: Final = (
    (11, 13), (12, 14), (13, 15), (14, 16), (23, 25), (24, 26), (25, 27), (26, 28),
    (11, 12, 24, 23), (0, 7, 8, 11, 12), *FEET,
)  # fmt: skip
#: A shoe's half width, and how far around it nothing is known, in lengths from heel to toe. Measured on painted
#: people's side photos: 0.93 of the pixels 0.02 lengths from the triangle show the person, 0.57 at 0.2.
SHOE: Final = 0.14
SHOE_AROUND: Final = 0.3
#: Probability inside the triangle of ankle, heel and toe: measured 0.98 in side photos, 0.91 from the front.
FOOT_CERTAIN: Final = 0.97
#: Fingers end within this distance of the knuckles, in heights from nose to ankles; nearer than the second figure
#: is palm.
FINGER: Final = 0.058
PALM: Final = 0.013


def distance_to(shape: tuple[int, int], areas: list[Points]) -> Floats:
    """Return distances (H, W) px to the nearest of some convex areas (N, 2) or strokes."""
    free = np.ones(shape, np.uint8)
    for area in areas:
        corners = np.rint(np.clip(area, -1e4, 1e4)).astype(np.int32)
        cv2.fillConvexPoly(free, cv2.convexHull(corners), 0)
        cv2.polylines(free, [corners], True, 0, 1)
    if free.all():
        return np.full(shape, float(max(shape)), np.float32)
    return np.asarray(cv2.distanceTransform(free, cv2.DIST_L2, 5), np.float32)


def add_feet(probability: Floats, pose_px: Points) -> tuple[Floats, Bools]:
    """Raise a person's probability around the feet of the pose.

    Mask nets lose shoes seen from the side, all of a shoe as often as its sole.

    Parameters
    ----------
    probability : (H, W) float32, 0..1
    pose_px : (33, 2) float64
        Pose points in px of ``probability``.

    Returns
    -------
    raised : (H, W) float32
    around : (H, W) bool
        Where the mask says nothing sure about the background, for a foot is near. Feet far from all of the mask's
        person are left out.
    """
    raised, around = probability, np.zeros(probability.shape, dtype=bool)
    gap = cv2.distanceTransform((probability < 0.5).astype(np.uint8), cv2.DIST_L2, 5)
    for rows in FEET:
        ankle, heel, toe = pose_px[list(rows)]
        length = float(np.linalg.norm(toe - heel))
        column, row = np.rint(np.clip(ankle, 0, np.array(gap.shape)[::-1] - 1)).astype(int)
        if length < 4.0 or gap[row, column] > length:
            continue
        away = distance_to((raised.shape[0], raised.shape[1]), [np.stack([ankle, heel, toe])]) / length
        raised = np.maximum(raised, FOOT_CERTAIN * np.clip(1.0 - (away - 0.02) / SHOE, 0.0, 1.0))
        around |= away < SHOE_AROUND
    return np.asarray(raised, np.float32), around


def finger_zone(shape: tuple[int, int], pose_px: Points) -> Floats:
    """Return (H, W) float32: 1 where fingers may be, fading to 0 elsewhere.

    Parameters
    ----------
    shape : tuple of int
    pose_px : (33, 2) float64
        Pose points in px of that shape.
    """
    height = float(np.linalg.norm(pose_px[0] - pose_px[27:29].mean(axis=0)))
    hands = distance_to(shape, [pose_px[list(rows)] for rows in HANDS])
    others = distance_to(shape, [pose_px[list(rows)] for rows in OTHERS])
    zone = (hands < others) & (hands > PALM * height) & (hands < FINGER * height)
    return np.asarray(cv2.GaussianBlur(zone.astype(np.float32), (0, 0), 0.005 * max(height, 1.0)), np.float32)
