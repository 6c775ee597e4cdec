"""Edge segments in the vicinity band of a mask's contours.

References
----------
Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method note section 4, step 2.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.vision.edges import EdgeMap, refine_subpixel
from cloner.vision.linking import FEWEST_POINTS, split_curves, walk_curves
from cloner.vision.loops import MaskLoop
from cloner.vision.parting import DOUBT, EdgePoints, edge_features, outline_odds
from cloner.vision.seen_edges import SeenEdges

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Bools = NDArray[np.bool_]

#: Log odds beyond which an edge is certain: more says nothing more.
MOST_ODDS = 1.5
#: Strength of an edge that surely is not the outline's, beside odds: better than no edge.
LEAST_STRENGTH = 0.3


@dataclass(frozen=True, slots=True)
class LinkParams:
    """Options of the edge linking; lengths in figure heights.

    Attributes
    ----------
    smoothing : float
        Sigma of the blur that takes the net's staircase off the mask before its contour is
        taken.  Measurement: twice as much rounds fingers off.
    band : float
        Half width of the vicinity band: the mask's contour may be wrong by a fiftieth of the height.
    margin : float
        How far from the contours the photo is looked at: the room's colours are learned beyond the band.
    segment : float
        Longest edge segment.
    bridge : float
        Longest gap a link may jump.
    spacing : float
        Longest feature segment placed on the mask's contour where no points are given.
    corner_scale : float
        Scale at which the mask's corners are found.
    along : float
        Least cosine between an edge segment and L; steeper ones cross the outline.
    least_odds : float
        Least log odds of parting the person from the room for a segment to be a candidate.
    fade : float
        Arc over which the contour between two paths returns to the mask's.
    least_goodness : float
        G^P a path needs; measured on flat walls, whose paths stay below it.
    doubt : float
        How little L is known, in the denominator of G^P.  Tuned on ten people of the kit: .003, .007 and .014 leave
        .835, .839 and .820 of the mask contour's error.
    edges_share : float
        Share of a feature segment on edges for its source to be called ``'edges'``.
    """

    smoothing: float = 0.0008
    band: float = 0.025
    margin: float = 0.090
    segment: float = 0.008
    bridge: float = 0.025
    spacing: float = 0.15
    corner_scale: float = 0.004
    along: float = 0.4
    least_odds: float = -4.0
    fade: float = 0.02
    least_goodness: float = 1.0
    doubt: float = 0.014
    edges_share: float = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Band:
    """Edge segments near one contour, each directed along it.

    Attributes
    ----------
    points : ndarray, shape (P, 2), float64
        Sub-pixel edge points, px.
    nearest : ndarray, shape (P,), intp
        Index of the contour point nearest to each.
    distances : ndarray, shape (P,), float64
        Distance from it, px.
    strengths : ndarray, shape (P,), float64
        Normalised magnitude, at least 1.
    first, count : ndarray, shape (S,), intp
        Points of each segment.
    along : ndarray, shape (S,), float64
        Cosine of each segment's angle to the contour.
    """

    points: Floats
    nearest: Ints
    distances: Floats
    strengths: Floats
    first: Ints
    count: Ints
    along: Floats


def gather_band(seen: SeenEdges, loops: list[MaskLoop], *, height_px: float, params: LinkParams) -> list[Band]:
    """Find the edge segments in the vicinity of each contour.

    Parameters
    ----------
    seen : SeenEdges
        The edges of the part of the photo that holds the contours.
    loops : list of MaskLoop
    height_px : float
        Figure height, px.
    params : LinkParams

    Returns
    -------
    list of Band
        One per contour; each edge point belongs to the contour nearest to it.
    """
    found = find_segments(seen, loops, height_px=height_px, params=params)
    first, count = found.first, np.diff(found.first)
    if len(count) == 0:
        return [_empty_band() for _ in loops]
    odds = outline_odds(found.features)
    strengths = LEAST_STRENGTH + np.exp(np.minimum(odds, MOST_ODDS))
    owner = np.repeat(np.arange(len(loops)), [len(loop.points) for loop in loops])
    starts = np.concatenate([[0], np.cumsum([len(loop.points) for loop in loops])])
    whose = owner[found.nearest[first[:-1] + count // 2]]
    bands = []
    for index, loop in enumerate(loops):
        mine = np.flatnonzero(whose == index)
        take, bounds = _runs(first, mine)
        nearest, away = found.nearest[take] - starts[index], found.distances[take]
        strange = (nearest < 0) | (nearest >= len(loop.points))
        # A run between two contours may have stray points nearer to the other one.
        if strange.any():
            away[strange], nearest[strange] = cKDTree(loop.points).query(found.points[take[strange]])
        each = np.repeat(strengths[mine], np.diff(bounds))
        raw = Band(found.points[take], nearest, away, each, bounds[:-1], np.diff(bounds), np.zeros(0))
        bands.append(_directed(raw, odds[mine] >= params.least_odds, loop, params))
    return bands


@dataclass(frozen=True, slots=True, eq=False)
class Segments:
    """Short straight runs of edge points near contours.

    Attributes
    ----------
    points : ndarray, shape (P, 2), float64
        Sub-pixel edge points, px.
    inward : ndarray, shape (P, 2), float64
        Unit vectors across the edge, towards the person.
    nearest : ndarray, shape (P,), intp
        The nearest of all contours' points, counted through.
    distances : ndarray, shape (P,), float64
        Distance from it, px.
    first : ndarray, shape (S + 1,), intp
        Run k is ``points[first[k] : first[k + 1]]``.
    features : ndarray, shape (S, 7), float64
        Mean features of each run, as ``parting.WEIGHTS`` weighs them.
    """

    points: Floats
    inward: Floats
    nearest: Ints
    distances: Floats
    first: Ints
    features: Floats


def find_segments(seen: SeenEdges, loops: list[MaskLoop], *, height_px: float, params: LinkParams) -> Segments:
    """Find the edge segments in the vicinity of contours, and what tells whether they part person and room."""
    everywhere = np.concatenate([loop.points for loop in loops])
    towards = np.concatenate([loop.inward for loop in loops])
    edge_map, offset = seen.edge_map, seen.top_left
    near = _vicinity(everywhere - offset, edge_map.edges.shape, max(params.band * height_px, 2.0))
    curves = walk_curves(edge_map.edges & near)
    pixels, first = split_curves([curve.astype(np.float64) for curve in curves], longest_px=params.segment * height_px)
    local = refine_subpixel(edge_map, pixels)
    distances, nearest = cKDTree(everywhere).query(local + offset)
    inward = _across(edge_map, pixels, towards[nearest])
    magnitude = edge_map.magnitude / np.float32(edge_map.low)
    columns, rows = pixels[:, 0].astype(np.intp), pixels[:, 1].astype(np.intp)
    edges = EdgePoints(local, inward, magnitude[rows, columns].astype(np.float64))
    features = edge_features(
        seen.likeness, magnitude, edges, everywhere[nearest] - offset, towards[nearest], DOUBT * height_px
    )
    means = np.add.reduceat(features, first[:-1]) / np.diff(first)[:, None] if len(pixels) else features
    return Segments(local + offset, inward, nearest.astype(np.intp), distances, first, means)


def _vicinity(points_px: Floats, shape: tuple[int, ...], reach_px: float) -> Bools:
    """Return the pixels within reach of the nearest of the points."""
    far = np.full(shape, 255, np.uint8)
    at = np.rint(points_px).astype(np.intp)
    rows, columns = np.clip(at[:, 1], 0, shape[0] - 1), np.clip(at[:, 0], 0, shape[1] - 1)
    far[rows, columns] = 0
    near = cv2.distanceTransform(far, cv2.DIST_L2, 5) <= reach_px
    # Canny answers to the picture's own border; a cut figure is closed by the mask there.
    near[[0, -1]] = False
    near[:, [0, -1]] = False
    return np.asarray(near)


def _across(edge_map: EdgeMap, pixels_px: Floats, inward: Floats) -> Floats:
    """Return the unit gradient at edge pixels, signed to point towards the person."""
    columns, rows = pixels_px[:, 0].astype(np.intp), pixels_px[:, 1].astype(np.intp)
    slope = edge_map.gradient[rows, columns].astype(np.float64)
    slope /= np.maximum(np.linalg.norm(slope, axis=1, keepdims=True), 1e-9)
    sign = np.where((slope * inward).sum(axis=1) < 0, -1.0, 1.0)
    return np.asarray(slope * sign[:, None])


def _runs(first: Ints, chosen: Ints) -> tuple[Ints, Ints]:
    """Return the point indices of chosen runs, and the bounds of the runs among them."""
    count = first[chosen + 1] - first[chosen]
    bounds = np.concatenate([[0], np.cumsum(count)]).astype(np.intp)
    take = np.arange(bounds[-1]) - np.repeat(bounds[:-1], count) + np.repeat(first[chosen], count)
    return take.astype(np.intp), bounds


def _directed(raw: Band, clear: Bools, loop: MaskLoop, params: LinkParams) -> Band:
    """Turn segments along the contour; drop those that cross it, are short or not ``clear``."""
    first, count = raw.first, raw.count
    last = first + count - 1
    chord = raw.points[last] - raw.points[first]
    length = np.maximum(np.linalg.norm(chord, axis=1), 1e-9)
    middle = raw.nearest[first + count // 2]
    cosine = (chord * loop.tangents[middle]).sum(axis=1) / length
    order = np.arange(len(raw.points))
    for k in np.flatnonzero(cosine < 0):
        piece = slice(first[k], last[k] + 1)
        order[piece] = order[piece][::-1]
    keep = clear & (count >= FEWEST_POINTS) & (np.abs(cosine) >= params.along)
    return Band(
        raw.points[order],
        raw.nearest[order],
        raw.distances[order],
        raw.strengths[order],
        first[keep],
        count[keep],
        np.abs(cosine)[keep],
    )


def _empty_band() -> Band:
    """Return a band without any edge."""
    none, indices = np.zeros(0), np.zeros(0, dtype=np.intp)
    return Band(np.zeros((0, 2)), indices, none, none, indices, indices, none)
