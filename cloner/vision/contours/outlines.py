"""A person's outline in one photo: edges linked along the contour of a rough mask.

References
----------
W.-S. Lee, J. Gu, N. Magnenat-Thalmann, "Generating Animatable 3D Virtual Humans from
Photographs", Eurographics 2000, section 3.5; method note section 4 and its "Beyond".
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.vision.contours.band import Band, LinkParams, gather_band
from cloner.vision.contours.fixed_points import bend_through, keep_in_cones
from cloner.vision.contours.loops import (
    MaskLoop,
    figure_height,
    fill_polygons,
    loop_from_points,
    mask_loops,
    place_feature_points,
)
from cloner.vision.contours.seen_edges import cache_edges
from cloner.vision.contours.tracing import trace_loop

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Bools = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class OutlineLoop:
    """One closed contour of the outline.

    Attributes
    ----------
    polygon : ndarray, shape (M, 2), float64
        Sub-pixel corners, not repeated at the end, px.
    is_hole : bool
        Whether it bounds a hole (between arm and torso, between legs).
    feature_points : ndarray, shape (K, 2), float64
        The feature points, on the mask's contour, in walking order, px.
    feature_rows : ndarray, shape (K,), intp
        Row of each in the caller's ``feature_points_px``; -1 for points placed here.
    sources : tuple of str
        Per feature segment (from point k to k + 1, the last back to the first) ``'edges'`` or
        ``'mask'``.
    goodness : ndarray, shape (K,), float64
        G^P of the best path of each feature segment; 0 where there was none.
    covered : ndarray, shape (K,), float64
        Share of each feature segment's length that lies on edges, 0..1.
    """

    polygon: Floats
    is_hole: bool
    feature_points: Floats
    feature_rows: NDArray[np.intp]
    sources: tuple[str, ...]
    goodness: Floats
    covered: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Outline:
    """Outline of the person in one photo.

    Attributes
    ----------
    loops : tuple of OutlineLoop
        Outer contours and holes, longest first; empty where the mask shows nobody.
    filled : ndarray, shape (H, W), bool
        Pixels whose centres lie inside.
    height_px : float
        Height of the figure in the mask, px; lengths scale with it.
    """

    loops: tuple[OutlineLoop, ...]
    filled: Bools
    height_px: float


@dataclass(frozen=True, slots=True, eq=False)
class _Given:
    """The caller's points that belong to one contour: rows, positions, and which are fixed."""

    rows: Ints
    points: Floats
    fixed: Bools


def extract_outline(
    rgb: NDArray[np.uint8],
    mask: NDArray[np.float32],
    feature_points_px: Floats | None = None,
    *,
    fixed: Bools | None = None,
    params: LinkParams | None = None,
) -> Outline:
    """Trace a person's outline along image edges, near the contour of a rough mask.

    Parameters
    ----------
    rgb : ndarray, shape (H, W, 3), uint8
        The upright photo.
    mask : ndarray, shape (H, W), float32
        Probability 0..1 that a pixel shows the person; roughly right, edges may be soft.
    feature_points_px : ndarray, shape (N, 2), float64, optional
        Points near the outline, px; each belongs to the contour nearest to it, and each pair of
        consecutive ones along a contour bounds a feature segment.  Placed on the mask's contour
        where a contour has none.
    fixed : ndarray, shape (N,), bool, optional
        Which of them an operator placed: the outline passes through these exactly.  None by
        default.
    params : LinkParams, optional
        Lengths in figure heights, and weights.

    Returns
    -------
    Outline
        Where no path of edges is good enough the mask's contour stands in.

    Notes
    -----
    Departures from the paper: the feature segment L is the mask contour's piece between two
    feature points, not the straight line; magnitudes are weighted by the colours on both sides
    of the edge; what the best path leaves uncovered is searched again as a shorter L.
    """
    settings = params or LinkParams()
    height = figure_height(mask)
    mask = smooth_mask(mask, height, settings)
    loops = mask_loops(mask, height_px=height)
    if not loops:
        return Outline((), np.zeros(mask.shape, dtype=bool), height)
    points = np.zeros((0, 2)) if feature_points_px is None else feature_points_px
    given = _given_to_loops(loops, points, np.zeros(len(points), dtype=bool) if fixed is None else fixed)
    loops = [_bend_through_fixed(loop, own, height) for loop, own in zip(loops, given, strict=True)]
    everywhere = np.concatenate([loop.points for loop in loops])
    seen = cache_edges(rgb, everywhere, margin_px=max(settings.margin * height, 8.0))
    bands = gather_band(seen, mask, loops, height_px=height, params=settings)
    traced = [_trace(*its, height, settings) for its in zip(loops, bands, given, strict=True)]
    filled = fill_polygons([t.polygon for t in traced], [t.is_hole for t in traced], mask.shape)
    return Outline(tuple(traced), filled, height)


def smooth_mask(mask: NDArray[np.float32], height_px: float, params: LinkParams) -> NDArray[np.float32]:
    """Return a mask without the staircase of the net's low resolution."""
    if height_px <= 0:
        return mask
    sigma = max(params.smoothing * height_px, 0.3)
    # Replicated borders keep a cut figure's contour on the picture's border.
    return np.asarray(cv2.GaussianBlur(mask, (0, 0), sigma, borderType=cv2.BORDER_REPLICATE))


def _given_to_loops(loops: list[MaskLoop], points_px: Floats, fixed: Bools) -> list[_Given]:
    """Assign each point to the nearest contour."""
    owner = np.repeat(np.arange(len(loops)), [len(loop.points) for loop in loops])
    tree = cKDTree(np.concatenate([loop.points for loop in loops]))
    whose = owner[tree.query(points_px)[1]] if len(points_px) else np.zeros(0, dtype=np.intp)
    rows = [np.flatnonzero(whose == index) for index in range(len(loops))]
    return [_Given(row, points_px[row], fixed[row]) for row in rows]


def _bend_through_fixed(loop: MaskLoop, given: _Given, height_px: float) -> MaskLoop:
    """Return the contour bent through its fixed points, so that edges are searched near them."""
    if not given.fixed.any():
        return loop
    polygon = bend_through(loop.points, given.points[given.fixed])
    # Not resampled: contour points elsewhere stay what they were, and so does the outline there.
    return loop_from_points(polygon, height_px=height_px, is_hole=loop.is_hole)


def _trace(loop: MaskLoop, band: Band, given: _Given, height_px: float, params: LinkParams) -> OutlineLoop:
    """Return one contour of the outline."""
    at = np.asarray(cKDTree(loop.points).query(given.points)[1], dtype=np.intp)
    band = keep_in_cones(band, at[given.fixed], contour_points=len(loop.points))
    # The contour's own order rules: two points given in the wrong order, or the whole list
    # walked the other way, still bound the same pieces.
    indices, first = np.unique(at, return_index=True)
    rows = given.rows[first]
    if len(indices) < 2:
        placed = place_feature_points(
            loop,
            spacing_px=params.spacing * height_px,
            smooth_px=max(params.corner_scale * height_px, 1.0),
        )
        indices, first = np.unique(np.concatenate([at, placed]), return_index=True)
        rows = np.concatenate([given.rows, np.full(len(placed), -1)])[first]
    trace = trace_loop(loop, band, indices, height_px=height_px, params=params)
    sources = tuple("edges" if c >= params.edges_share else "mask" for c in trace.covered)
    return OutlineLoop(
        bend_through(trace.polygon, given.points[given.fixed]),
        loop.is_hole,
        loop.points[indices],
        rows.astype(np.intp),
        sources,
        trace.goodness,
        trace.covered,
    )
