"""Does an edge part the person from the room?  Log odds from the colours on its two sides, the edge and the mask.

Colours are learned deep inside the mask and well outside it, so that a mask that is wrong by a fiftieth of the figure
teaches nothing wrong.  The weights are a logistic regression on the edges of people of the kit.

References
----------
Method note section 4, "Beyond"; D. Martin, C. Fowlkes, J. Malik, "Learning to detect natural image boundaries using
local brightness, color, and texture cues", PAMI 2004 (edges told from clutter by logistic regression on both sides).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.colours import LIMIT, colour_ratio, make_palette
from cloner.vision.edges import sample

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Image = NDArray[np.float32]

#: Height of the figure at which colours are counted, px.  Measured: 1,400 parts edges no better and costs four times.
WORK_HEIGHT_PX: Final = 700.0
#: Share of a thin limb's half thickness from which on it teaches the person's colours.
DEEP_SHARE: Final = 0.6
#: The room's colours are learned up to so many half widths of the band away.
FAR_REACHES: Final = 3.5
#: Sigma of the windows in which colours are counted, half widths of the band.
WINDOW_REACHES: Final = 1.5
#: Share of the colours of person or room below which a colour is as good as unseen there.
UNSEEN: Final = 0.003
#: Where an edge point's own two sides are read, px: past the blur of the edge itself.
SIDE_STEP_PX: Final = 3.0
#: Where colours are read between an edge and the mask's contour, shares of the way.
BETWEEN: Final = (0.15, 0.35, 0.6, 0.85)
#: An edge this near to the contour has nothing between, px.
NOTHING_BETWEEN_PX: Final = 4.0
#: Distance from the contour at which the mask begins to speak against an edge, figure heights.
DOUBT: Final = 0.001
#: Log odds of: a constant; log ratio of the edge's contrast to that beside it (shadows are soft); likeness of the outer
#: side to the person; the lesser of the inner side's likeness and the outer one's opposite; likeness of what lies
#: between edge and contour (positive where these colours want the contour at the edge); log(1 + distance from the
#: contour / ``DOUBT``); cosine of the edge's angle to the contour.  Taught by ``generic_models/build/train_edges.py``.
BETWEEN_COLUMN: Final = 4
WEIGHTS: Final = (-2.9, 2.22, -0.78, 1.25, 0.51, -0.94, 1.56)


@dataclass(frozen=True, slots=True, eq=False)
class EdgePoints:
    """Points on a photo's edges.

    Attributes
    ----------
    points_px : ndarray, shape (P, 2), float64
    inward : ndarray, shape (P, 2), float64
        Unit vectors across the edge, towards the person.
    contrast : ndarray, shape (P,), float64
        Magnitude in units of the hysteresis's lower threshold.
    """

    points_px: Floats
    inward: Floats
    contrast: Floats


def likeness_map(
    rgb: NDArray[np.uint8], mask: Image, room: Image | None, *, height_px: float, reach_px: float
) -> Image:
    """Return per pixel how much likelier its colour is on the person than in the room, near the mask's rim.

    Parameters
    ----------
    rgb : ndarray, shape (H, W, 3), uint8
    mask : ndarray, shape (H, W), float32
        Person probability 0..1.
    room : ndarray, shape (H, W), float32, or None
        Log odds by comparison with other photos, of ``still_room``.
    height_px : float
        Figure height, px.
    reach_px : float
        The mask's contour may be wrong by this much, px.

    Returns
    -------
    ndarray, shape (H, W), float32
        Log ratio; 0 where colours tell nothing and outside the vicinity.
    """
    share = min(1.0, WORK_HEIGHT_PX / max(height_px, 1.0))
    size = (max(round(rgb.shape[1] * share), 1), max(round(rgb.shape[0] * share), 1))
    small = cv2.resize(rgb, size, interpolation=cv2.INTER_AREA)
    inside = (cv2.resize(mask, size, interpolation=cv2.INTER_AREA) > 0.5).astype(np.uint8)
    reach = reach_px * share
    depth, away = (cv2.distanceTransform(each, cv2.DIST_L2, 3) for each in (inside, 1 - inside))
    side = 2 * int(np.ceil(reach)) + 1
    thickness = cv2.dilate(depth, np.ones((side, side), np.uint8))
    person = depth > np.minimum(DEEP_SHARE * thickness, reach)
    wall = (away > reach) & (away < FAR_REACHES * reach)
    wanted = (depth <= 1.3 * reach) & (away <= 1.3 * reach)
    palette = make_palette(np.asarray(cv2.cvtColor(small, cv2.COLOR_RGB2Lab), np.uint8), wanted | person | wall)
    ratio = np.zeros(inside.shape, np.float32)
    window = max(WINDOW_REACHES * reach, 4.0)
    _, ratio[wanted] = colour_ratio(palette, person, wall, wanted, window_px=window, unseen=UNSEEN)
    ratio = cv2.GaussianBlur(ratio, (0, 0), 0.8)  # px: camera noise
    whole = cv2.resize(ratio, (rgb.shape[1], rgb.shape[0]), interpolation=cv2.INTER_LINEAR)
    return np.asarray(whole if room is None else np.clip(whole + room, -LIMIT, LIMIT), np.float32)


def edge_features(
    likeness: Image, magnitude: Image, edges: EdgePoints, contour_px: Floats, towards: Floats, doubt_px: float
) -> Floats:
    """Return the (P, 7) features of edge points that ``WEIGHTS`` weigh.

    Parameters
    ----------
    likeness : ndarray, shape (H, W), float32
        Of ``likeness_map``.
    magnitude : ndarray, shape (H, W), float32
        Length of the photo's gradient in units of the hysteresis's lower threshold.
    edges : EdgePoints
    contour_px, towards : ndarray, shape (P, 2), float64
        The nearest point of the mask's contour, and the unit vector there towards the person.
    doubt_px : float
        ``DOUBT`` in px.
    """
    points, inward = edges.points_px, edges.inward
    inner, outer = (sample(likeness, points + sign * SIDE_STEP_PX * inward) for sign in (1.0, -1.0))
    beside = sum(sample(magnitude, points + sign * SIDE_STEP_PX * inward) for sign in (1.0, -1.0))
    back = contour_px - points
    distance = np.linalg.norm(back, axis=1)
    between = np.mean([sample(likeness, points + share * back) for share in BETWEEN], axis=0)
    outside = np.sign((back * towards).sum(axis=1))
    return np.column_stack(
        [
            np.ones(len(points)),
            np.log(edges.contrast + 1.0) - np.log(beside / 2.0 + 1.0),
            outer,
            np.minimum(inner, -outer),
            between * outside * np.minimum(distance / NOTHING_BETWEEN_PX, 1.0),
            np.log1p(distance / doubt_px),
            np.abs((inward * towards).sum(axis=1)),
        ]
    )


def outline_odds(features: Floats) -> Floats:
    """Return log odds (S,) that edges are the outline's, from the mean features (S, 7) of each.

    Notes
    -----
    Colours between edge and contour that speak against the edge count once more than the regression says: most edges
    that taught it lie at the contour and have nothing between.
    """
    return np.asarray(features @ np.array(WEIGHTS) + np.minimum(features[:, BETWEEN_COLUMN], 0.0))
