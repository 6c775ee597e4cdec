"""Relinking of one stretch of an outline through points that an operator placed, fast enough for interaction.

References
----------
Lee, Gu and Magnenat-Thalmann 2000, section 3.5, on the part of the contour that a moved point concerns.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.vision.contours.band import LinkParams, gather_band
from cloner.vision.contours.fixed_points import REACH_PER_HEIGHT, bend_through, keep_in_cones
from cloner.vision.contours.loops import MaskLoop, figure_height, loop_from_points, mask_loops
from cloner.vision.contours.outlines import smooth_mask
from cloner.vision.contours.seen_edges import CachedEdges, cache_edges
from cloner.vision.contours.tracing import trace_loop

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

#: How far beyond a point's bend the outline is linked again, to either side, figure heights: a hand's breadth.
BEYOND = 0.05
#: How far beside the mask's contour edges are kept ready, figure heights; a farther drag only bends.
READY = 0.10
#: Vertices at a stretch's ends that its smoothing, which goes round, has spoilt.
_SPOILT = 8
#: A stretch that would replace more than so many times its own length of the outline has lost its way.
_LONGEST = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class LinkableOutline:
    """A photo prepared for relinking stretches of its outline.

    Attributes
    ----------
    mask : (H, W) float32, smoothed
    loops : tuple of MaskLoop
        The mask's contours.
    seen : SeenEdges
    height_px : float
    """

    mask: NDArray[np.float32]
    loops: tuple[MaskLoop, ...]
    seen: CachedEdges
    height_px: float


def prepare_linking(rgb: NDArray[np.uint8], mask: NDArray[np.float32]) -> LinkableOutline | None:
    """Return a photo (H, W, 3) with its person's mask (H, W, 0..1) prepared; None where it shows nobody."""
    height = figure_height(mask)
    smooth = smooth_mask(mask, height, LinkParams())
    loops = mask_loops(smooth, height_px=height)
    if not loops:
        return None
    seen = cache_edges(rgb, np.concatenate([loop.points for loop in loops]), margin_px=READY * height)
    return LinkableOutline(smooth, tuple(loops), seen, height)


def relink_stretch(
    ready: LinkableOutline, contours_px: tuple[Floats, ...], fixed_px: Floats, moved_px: Floats
) -> tuple[Floats, ...]:
    """Return the outline relinked around one point, and passing through it.

    Parameters
    ----------
    ready : Linkable
    contours_px : tuple of (M, 2) float64
        The standing outline, closed polygons, px.
    fixed_px : (F, 2) float64
        All points that the outline must pass through, px.
    moved_px : (2,) float64
        The one of them that moved; elsewhere the outline stays.
    """
    loop = min(ready.loops, key=lambda each: float(np.linalg.norm(each.points - moved_px, axis=1).min()))
    found = _linked_stretch(ready, loop, fixed_px, moved_px)
    number = int(np.argmin([_end_distance_px(contour, found) for contour in contours_px]))
    spliced = _splice(contours_px[number], found)
    return (*contours_px[:number], spliced, *contours_px[number + 1 :])


def _linked_stretch(ready: LinkableOutline, loop: MaskLoop, fixed_px: Floats, moved_px: Floats) -> Floats:
    """Return the stretch (M, 2) around a moved point, in the contour's direction, through all fixed points on it."""
    params, size = LinkParams(), len(loop.points)
    distances, at = cKDTree(loop.points).query(fixed_px)
    gap, centre = cKDTree(loop.points).query(moved_px)
    half = min(int(REACH_PER_HEIGHT * gap + BEYOND * ready.height_px), (size - 1) // 2)
    beside = (at - centre + size // 2) % size - size // 2
    own = (np.abs(beside) < half - _SPOILT) & (distances < READY * ready.height_px)
    bent = loop_from_points(bend_through(loop.points, fixed_px[own]), height_px=ready.height_px, is_hole=loop.is_hole)
    rows = np.arange(centre - half, centre + half + 1) % size
    piece = MaskLoop(bent.points[rows], bent.tangents[rows], bent.inward[rows], loop.is_hole)
    seen = ready.seen.around(piece.points, margin_px=params.margin * ready.height_px)
    (band,) = gather_band(seen, ready.mask, [piece], height_px=ready.height_px, params=params)
    places = np.unique(np.asarray(beside[own] + half, dtype=np.intp))
    band = keep_in_cones(band, places, contour_points=len(rows))
    indices = np.unique(np.concatenate([[0], places, [len(rows) - 1]]))
    traced = trace_loop(piece, band, indices, height_px=ready.height_px, params=params).polygon
    steps = np.linalg.norm(np.roll(traced, -1, axis=0) - traced, axis=1)
    opened = np.roll(traced, -(int(np.argmax(steps)) + 1), axis=0)[_SPOILT:-_SPOILT]
    return bend_through(opened, fixed_px[own])


def _end_distance_px(contour_px: Floats, stretch_px: Floats) -> float:
    """Return the distance of a stretch's ends from a contour, px."""
    ends = stretch_px[[0, -1]]
    return float(np.linalg.norm(contour_px[:, None] - ends[None], axis=2).min(axis=0).sum())


def _splice(contour_px: Floats, stretch_px: Floats) -> Floats:
    """Return a closed contour with one stretch replaced."""
    first, last = (int(np.argmin(np.linalg.norm(contour_px - end, axis=1))) for end in stretch_px[[0, -1]])
    replaced = (last - first) % len(contour_px)
    if replaced > _LONGEST * len(stretch_px):
        return contour_px
    kept = np.roll(contour_px, -last, axis=0)[1 : len(contour_px) - replaced]
    return np.concatenate([stretch_px, kept])
