"""The polygon that the best paths of consecutive feature segments make along a contour.

References
----------
Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method note section 4, steps 5 and 6, and its
"Beyond".
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from cloner.vision.contours.band import Band, LinkParams
from cloner.vision.contours.loops import MaskLoop
from cloner.vision.contours.paths import Candidates, best_path

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

#: Sigma of the last smoothing along the polygon, vertices about 1 px apart.
VERTEX_SMOOTHING = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Trace:
    """Polygon of one contour and, per feature segment, how it was found.

    Attributes
    ----------
    polygon : ndarray, shape (M, 2), float64
        Sub-pixel corners, px.
    goodness : ndarray, shape (K,), float64
        G^P of the best path of each feature segment; 0 where there was none.
    covered : ndarray, shape (K,), float64
        Share of the feature segment's length on edges, 0..1.
    """

    polygon: Floats
    goodness: Floats
    covered: Floats


@dataclass(frozen=True, slots=True, eq=False)
class _Piece:
    """A stretch of the contour: from point ``start``, ``length`` points on (cyclic)."""

    start: int
    length: int


def trace_loop(loop: MaskLoop, band: Band, indices: Ints, *, height_px: float, params: LinkParams) -> Trace:
    """Trace one contour, feature segment by feature segment.

    Parameters
    ----------
    loop : MaskLoop
    band : Band
        Edge segments in its vicinity.
    indices : ndarray, shape (K,), intp
        Feature points as increasing indices into ``loop.points``.
    height_px : float
        Figure height, px.
    params : LinkParams

    Returns
    -------
    Trace
    """
    size = len(loop.points)
    following = np.append(indices[1:], indices[0] + size)
    where, points = [np.zeros(0, dtype=np.intp)], [np.zeros((0, 2))]
    goodness = np.zeros(len(indices))
    covered = np.zeros(len(indices))
    for k, (start, stop) in enumerate(zip(indices, following, strict=True)):
        piece = _Piece(int(start), max(int(stop - start), 1))
        found, goodness[k] = _search(loop, band, piece, height_px=height_px, params=params)
        for at, chosen in found:
            where.append((at + start) % size)
            points.append(band.points[chosen])
            covered[k] += (at[-1] - at[0] + 1) / piece.length
    polygon = weave(
        loop.points,
        np.concatenate(where),
        np.concatenate(points),
        fade_px=max(params.fade * height_px, 1.0),
    )
    # Where two runs meet the grid's staircase steps back by a pixel; fingertips lose 0.06 px.
    polygon = gaussian_filter1d(polygon, VERTEX_SMOOTHING, axis=0, mode="wrap")
    return Trace(polygon, goodness, np.minimum(covered, 1.0))


def _search(
    loop: MaskLoop, band: Band, piece: _Piece, *, height_px: float, params: LinkParams
) -> tuple[list[tuple[Ints, Ints]], float]:
    """Find the paths along one piece: the best one, then those beside it.

    Returns per path the positions along the piece (increasing) and the band's point indices,
    in order along the piece, and the best goodness.
    """
    near, members = _candidates(loop, band, piece)
    path = best_path(near, longest_bridge_px=params.bridge * height_px)
    if path is None:
        return [], 0.0
    if path.goodness < params.least_goodness:
        return [], path.goodness
    chain = _trimmed(members[path.members], band.along, params.end_along)
    if len(chain) == 0:
        return [], path.goodness
    at, chosen = _positions(loop, band, piece, chain)
    if len(at) < 2:
        return [], path.goodness
    found = [(at, chosen)]
    least = params.bridge * height_px
    before = _Piece(piece.start, int(at[0]))
    after = _Piece(piece.start + int(at[-1]), piece.length - int(at[-1]))
    # What the best path leaves uncovered is a feature segment of its own.
    for rest, is_before in ((before, True), (after, False)):
        if rest.length < least or rest.length >= piece.length:
            continue
        more, _ = _search(loop, band, rest, height_px=height_px, params=params)
        shift = rest.start - piece.start
        shifted = [(a + shift, c) for a, c in more]
        found = shifted + found if is_before else found + shifted
    return found, path.goodness


def _trimmed(chain: Ints, along: Floats, least: float) -> Ints:
    """Drop the first and last segments of a chain while they turn away from the contour."""
    good = np.flatnonzero(along[chain] >= least)
    return chain[good[0] : good[-1] + 1] if len(good) else chain[:0]


def _candidates(loop: MaskLoop, band: Band, piece: _Piece) -> tuple[Candidates, Ints]:
    """Return the band's segments whose middle lies along a piece, and which ones they are."""
    size = len(loop.points)
    middle = band.nearest[band.first + band.count // 2]
    members = np.flatnonzero((middle - piece.start) % size < piece.length)
    first, count = band.first[members], band.count[members]
    last = first + count - 1
    sums = np.concatenate([[0.0], np.cumsum(band.strengths)])
    far = np.concatenate([[0.0], np.cumsum(band.distances)])
    totals = sums[first + count] - sums[first]
    tail = loop.points[[piece.start % size, (piece.start + piece.length) % size]]
    return (
        Candidates(
            starts=band.points[first],
            ends=band.points[last],
            magnitudes=totals / np.maximum(count, 1),
            totals=totals,
            start_distances=band.distances[first],
            end_distances=band.distances[last],
            mean_distances=(far[first + count] - far[first]) / np.maximum(count, 1),
            counts=count.astype(np.float64),
            tail=tail,
        ),
        members,
    )


def _positions(loop: MaskLoop, band: Band, piece: _Piece, chain: Ints) -> tuple[Ints, Ints]:
    """Return a chain's points that advance along a piece, and their positions on it."""
    chosen = np.concatenate([np.arange(band.first[k], band.first[k] + band.count[k]) for k in chain])
    size = len(loop.points)
    at = (band.nearest[chosen] - piece.start) % size
    # Points a little before the piece's start wrap round to almost the whole contour.
    inside = at < piece.length
    at, chosen = at[inside], chosen[inside]
    # Where the contour bends away several points share one nearest position, and where it bends
    # towards them they may step back by one: both are kept, true retreats are not.
    advancing = at >= np.maximum.accumulate(at) - 2 if len(at) else inside
    at, chosen = at[advancing], chosen[advancing]
    return np.maximum.accumulate(at).astype(np.intp), chosen.astype(np.intp)


def weave(loop_px: Floats, where: Ints, points_px: Floats, *, fade_px: float) -> Floats:
    """Join edge points into a closed polygon, following the mask's contour between them.

    Parameters
    ----------
    loop_px : ndarray, shape (N, 2), float64
        The mask's contour, px.
    where : ndarray, shape (P,), intp
        Contour position of each edge point, increasing but for one wrap.
    points_px : ndarray, shape (P, 2), float64
        Edge points in order, px.
    fade_px : float
        Arc along the contour over which a displacement dies out, px.

    Returns
    -------
    ndarray, shape (M, 2), float64
        The edge points, and between them the contour's points, displaced by the mean of the
        edges' displacements at both ends of the gap in proportion to the distance from each,
        fading to none ``fade_px`` away from either end.
    """
    if len(where) == 0:
        return loop_px.copy()
    size = len(loop_px)
    shift = points_px - loop_px[where]
    parts = []
    ahead = np.append(where[1:], where[0])
    gaps = (ahead - where) % size
    for k in np.flatnonzero(gaps > 1):
        t = np.arange(1, gaps[k]) / gaps[k]
        following = shift[(k + 1) % len(shift)]
        between = loop_px[(where[k] + np.arange(1, gaps[k])) % size]
        gap = float(gaps[k])
        left = (1 - t) * np.exp(-((t * gap / fade_px) ** 2))
        right = t * np.exp(-(((1 - t) * gap / fade_px) ** 2))
        parts.append((k, between + left[:, None] * shift[k] + right[:, None] * following))
    if len(where) == 1:
        return np.vstack([points_px, parts[0][1]]) if parts else loop_px.copy()
    pieces, done = [], 0
    for k, between in parts:
        pieces.extend([points_px[done : k + 1], between])
        done = int(k) + 1
    pieces.append(points_px[done:])
    return np.concatenate(pieces)
