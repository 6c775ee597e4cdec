"""Edge segments in the vicinity band of a mask's contours.

References
----------
Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method note section 4, step 2.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d, maximum_filter1d
from scipy.spatial import cKDTree

from cloner.calibration.loader import calibrated
from cloner.vision.contours.edges import EdgeMap, refine_subpixel, sample
from cloner.vision.contours.linking import FEWEST_POINTS, split_curves, walk_curves
from cloner.vision.contours.loops import MaskLoop
from cloner.vision.contours.seen_edges import CachedEdges
from cloner.vision.contours.sides import colour_model, colour_side_evidence

#: What each number is and where it comes from: ``cloner/calibration/vision.toml``.
_CALIBRATED: Final = calibrated("vision.band")

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Bools = NDArray[np.bool_]
Image = NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class LinkParams:
    """Options of the edge linking; lengths in figure heights.

    Attributes
    ----------
    smoothing : float
        Sigma of the blur that takes the net's staircase off the mask before its contour is
        taken.  Measurement: twice as much rounds fingers off.
    least_band, band : float
        Half width of the vicinity band where the mask is sure of its contour, and at most.
        Measured on 66 photos: 92 % of a refined mask's contour lies within 0.12 % of the height,
        and paths of edges farther than 0.3 % from a sure contour lead away more often than back.
    margin : float
        How far from the contours the photo's edges are found, at most: the colours beside a band count too.
    doubt : float
        Half width of the band in widths of the mask's own transition from outside to inside.
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
    end_along : float
        The same for the first and the last segment of a path, which only one neighbour holds:
        a path's tail must not run off along a crossing line.
    least_evidence : float
        Least mean evidence of both sides' colours (0..1) for a segment to be a candidate.
    fade : float
        Arc over which the contour between two paths returns to the mask's.
    strength_cap : float
        Normalised magnitude beyond which more contrast says nothing more: an edge far above the
        noise is certainly there, and a poster's is stronger than the outline's.
    least_goodness : float
        G^P a path needs; measured on flat walls, whose paths stay below it.
    edges_share : float
        Share of a feature segment on edges for its source to be called ``'edges'``.
    """

    smoothing: float = _CALIBRATED.number("smoothing", "figure")
    least_band: float = _CALIBRATED.number("least_band", "figure")
    band: float = _CALIBRATED.number("band", "figure")
    margin: float = _CALIBRATED.number("margin", "figure")
    doubt: float = _CALIBRATED.number("doubt", "factor")
    segment: float = _CALIBRATED.number("segment", "figure")
    bridge: float = _CALIBRATED.number("bridge", "figure")
    spacing: float = _CALIBRATED.number("spacing", "figure")
    corner_scale: float = _CALIBRATED.number("corner_scale", "figure")
    along: float = _CALIBRATED.number("along", "cosine")
    end_along: float = _CALIBRATED.number("end_along", "cosine")
    least_evidence: float = _CALIBRATED.number("least_evidence", "score")
    fade: float = _CALIBRATED.number("fade", "figure")
    strength_cap: float = _CALIBRATED.number("strength_cap", "factor")
    least_goodness: float = _CALIBRATED.number("least_goodness", "factor")
    edges_share: float = _CALIBRATED.number("edges_share", "share")


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


def gather_band(
    seen: CachedEdges,
    mask: Image,
    loops: list[MaskLoop],
    *,
    height_px: float,
    params: LinkParams,
) -> list[Band]:
    """Find the edge segments in the vicinity of each contour.

    Parameters
    ----------
    seen : SeenEdges
        The edges of the part of the photo that holds the contours.
    mask : ndarray, shape (H, W), float32
        Person probability 0..1.
    loops : list of MaskLoop
    height_px : float
        Figure height, px.
    params : LinkParams

    Returns
    -------
    list of Band
        One per contour; each edge point belongs to the contour nearest to it.
    """
    reach = max(params.band * height_px, 2.0)
    reaches = np.concatenate([band_reach(mask, loop, height_px=height_px, params=params) for loop in loops])
    everywhere = np.concatenate([loop.points for loop in loops])
    edge_map, offset, window, smooth = seen.edge_map, seen.top_left, seen.window, seen.smooth
    near = _vicinity(everywhere - offset, edge_map.edges.shape, reaches)
    curves = walk_curves(edge_map.edges & near)
    pixels, first = split_curves([curve.astype(np.float64) for curve in curves], longest_px=params.segment * height_px)
    if len(pixels) == 0:
        return [_empty_band() for _ in loops]
    local = refine_subpixel(edge_map, pixels)
    strength = _edge_magnitudes(edge_map, pixels)
    owner = np.repeat(np.arange(len(loops)), [len(loop.points) for loop in loops])
    starts = np.concatenate([[0], np.cumsum([len(loop.points) for loop in loops])])
    distances, hits = cKDTree(everywhere).query(local + offset)
    whose = owner[hits[first[:-1] + np.diff(first) // 2]]
    bands = []
    for index, loop in enumerate(loops):
        mine = np.flatnonzero(whose == index)
        take, bounds = _runs(first, mine)
        nearest = hits[take] - starts[index]
        strange = (nearest < 0) | (nearest >= len(loop.points))
        # A run between two contours may have stray points nearer to the other one.
        if strange.any():
            distances[take[strange]], nearest[strange] = cKDTree(loop.points).query(local[take[strange]] + offset)
        inward = _inward_gradients(edge_map, pixels[take], loop.inward[nearest])
        model = colour_model(smooth, mask[window], _shifted(loop, offset), band_px=reach)
        evidence = colour_side_evidence(smooth, model, local[take], inward, nearest)
        clear = np.add.reduceat(evidence, bounds[:-1]) if len(mine) else np.zeros(0)
        clear = clear >= params.least_evidence * np.diff(bounds)
        strengths = np.maximum(np.minimum(strength[take], params.strength_cap) * evidence, 1.0)
        raw = Band(local[take] + offset, nearest, distances[take], strengths, bounds[:-1], np.diff(bounds), np.zeros(0))
        bands.append(_along_contour(raw, clear, loop, params))
    return bands


def band_reach(mask: Image, loop: MaskLoop, *, height_px: float, params: LinkParams) -> Floats:
    """Return half widths (N,) px of the vicinity band along a contour: wide where the mask's edge is soft.

    A mask that jumps from nothing to certainty knows where its contour is; one that creeps does not, and there the
    edges decide over a wider band.
    """
    across = [sample(mask, loop.points + side * loop.inward) for side in (1.0, -1.0)]
    slope = np.abs(across[0] - across[1]) / 2.0
    least, most = (max(share * height_px, 2.0) for share in (params.least_band, params.band))
    reach = np.clip(params.doubt / np.maximum(slope, 1e-6), least, most)
    # The contour of a doubtful spot begins where its neighbours' certainty ends.
    reach = maximum_filter1d(reach, 2 * round(most) + 1, mode="wrap")
    return np.asarray(gaussian_filter1d(reach, most, mode="wrap"), dtype=np.float64)


def _vicinity(points_px: Floats, shape: tuple[int, ...], reaches_px: Floats) -> Bools:
    """Return the pixels within reach of the nearest of the points, each with its own reach."""
    far = np.full(shape, 255, np.uint8)
    at = np.rint(points_px).astype(np.intp)
    rows, columns = np.clip(at[:, 1], 0, shape[0] - 1), np.clip(at[:, 0], 0, shape[1] - 1)
    far[rows, columns] = 0
    distance, labels = cv2.distanceTransformWithLabels(far, cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL)
    reach_of = np.zeros(int(labels.max()) + 1)
    np.maximum.at(reach_of, labels[rows, columns], reaches_px)
    near = distance <= reach_of[labels]
    # Canny answers to the picture's own border; a cut figure is closed by the mask there.
    near[[0, -1]] = False
    near[:, [0, -1]] = False
    return np.asarray(near)


def _edge_magnitudes(edge_map: EdgeMap, pixels_px: Floats) -> Floats:
    """Return the magnitude at edge pixels in units of the hysteresis's lower threshold."""
    columns, rows = pixels_px[:, 0].astype(np.intp), pixels_px[:, 1].astype(np.intp)
    return np.asarray(edge_map.magnitude[rows, columns] / edge_map.low, dtype=np.float64)


def _inward_gradients(edge_map: EdgeMap, pixels_px: Floats, inward: Floats) -> Floats:
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


def _shifted(loop: MaskLoop, offset: Floats) -> MaskLoop:
    """Return a contour in the frame of a window that starts at ``offset``."""
    return MaskLoop(loop.points - offset, loop.tangents, loop.inward, loop.is_hole)


def _along_contour(raw: Band, clear: Bools, loop: MaskLoop, params: LinkParams) -> Band:
    """Orient segments along the contour; drop those that cross it, are short or not ``clear``."""
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
