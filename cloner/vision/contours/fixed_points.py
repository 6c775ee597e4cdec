"""A closed contour bent locally through points that an operator placed."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.vision.contours.band import Band

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

#: A bend reaches this many times its height to either side.  Taste: a raised cosine then slopes by
#: at most 32 degrees, steep enough to leave good outline near a bad spot alone, without a kink.
REACH_PER_HEIGHT = 2.5
#: Least reach of a bend, px: a move of one pixel spread over less would be a tooth.
LEAST_REACH_PX = 4.0
#: Slope of the cone which edges near a fixed point must keep to, and its width at the point, px.
CONE_SLOPE = 0.35
CONE_WIDTH_PX = 1.0


def bend_through(polygon_px: Floats, fixed_px: Floats) -> Floats:
    """Return a closed polygon that passes through all fixed points.

    The vertex nearest to each point moves on to it; its neighbours follow by a raised cosine of
    the arc, which ends at the next fixed point at the latest.  Two neighbours moved alike thus
    move what lies between them alike, for two raised cosines a reach apart add up to one.

    Parameters
    ----------
    polygon_px : ndarray, shape (M, 2), float64
        Corners about 1 px apart, the last not repeating the first, px.
    fixed_px : ndarray, shape (F, 2), float64
        Points the polygon must pass through, px.  Of two at the same vertex the later one rules.

    Returns
    -------
    ndarray, shape (M, 2), float64
    """
    if len(fixed_px) == 0 or len(polygon_px) < 3:
        return polygon_px.copy()
    at, rows = _last_rows(np.asarray(cKDTree(polygon_px).query(fixed_px)[1], dtype=np.intp))
    moves = fixed_px[rows] - polygon_px[at]
    sides = np.linalg.norm(np.roll(polygon_px, -1, axis=0) - polygon_px, axis=1)
    arc = np.concatenate([[0.0], np.cumsum(sides)])
    whole, arc = float(arc[-1]), arc[:-1]
    here = arc[at]
    # A lone point meets itself after a whole round.
    ahead = np.append(here[1:], here[0] + whole) - here
    behind = np.roll(ahead, 1)
    wanted = np.maximum(REACH_PER_HEIGHT * np.linalg.norm(moves, axis=1), LEAST_REACH_PX)
    bent = polygon_px.copy()
    for k, move in enumerate(moves):
        offset = (arc - here[k] + whole / 2) % whole - whole / 2
        reach = np.where(offset >= 0, min(wanted[k], ahead[k]), min(wanted[k], behind[k]))
        share = np.minimum(np.abs(offset) / np.maximum(reach, 1e-9), 1.0)
        bent += 0.5 * (1.0 + np.cos(np.pi * share))[:, None] * move
    return bent


def keep_in_cones(band: Band, fixed: Ints, *, contour_points: int) -> Band:
    """Return a band without the segments that no outline through the fixed points could follow.

    Parameters
    ----------
    band : Band
        Segments in the vicinity of a contour which passes through the fixed points.
    fixed : ndarray, shape (F,), intp
        Contour index of each fixed point.
    contour_points : int
        Number of points of the contour, about 1 px apart.

    Returns
    -------
    Band
        A segment stays if all its points lie within ``CONE_WIDTH_PX`` of the contour plus
        ``CONE_SLOPE`` times their arc from the nearest fixed point.
    """
    if len(fixed) == 0 or len(band.first) == 0:
        return band
    gap = np.abs(band.nearest[:, None] - fixed[None])
    arc = np.minimum(gap, contour_points - gap).min(axis=1)
    beyond = band.distances > CONE_WIDTH_PX + CONE_SLOPE * arc
    strays = np.concatenate([[0], np.cumsum(beyond)])
    keep = strays[band.first + band.count] == strays[band.first]
    return Band(
        band.points,
        band.nearest,
        band.distances,
        band.strengths,
        band.first[keep],
        band.count[keep],
        band.along[keep],
    )


def _last_rows(at: Ints) -> tuple[Ints, Ints]:
    """Return the distinct values, increasing, and the last row with each."""
    values, rows = np.unique(at[::-1], return_index=True)
    return values, (len(at) - 1 - rows).astype(np.intp)
