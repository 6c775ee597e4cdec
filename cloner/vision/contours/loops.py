"""Closed contours of a person mask, outer ones and holes, and polygons back to masks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d
from skimage.measure import find_contours

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Ints = NDArray[np.intp]

#: Least area of an outer contour and of a hole, in squares of the figure's height.  Origin:
#: measurement; a hand covers 0.003, the gap between hand and thigh 0.0005.
LEAST_BODY_AREA = 0.0020
LEAST_HOLE_AREA = 0.0002
#: Arc over which a contour's direction is averaged, in figure heights: a finger's width.
DIRECTION_ARC = 0.006


@dataclass(frozen=True, slots=True, eq=False)
class MaskLoop:
    """One closed contour of a mask, the person always on the same hand of the walk.

    Attributes
    ----------
    points : ndarray, shape (N, 2), float64
        Points about 1 px apart, not repeated at the end, px.
    tangents, inward : ndarray, shape (N, 2), float64
        Unit vectors along the walk and towards the person.
    is_hole : bool
        Whether the contour bounds a hole in the person.
    """

    points: Floats
    tangents: Floats
    inward: Floats
    is_hole: bool


def signed_area(polygon_px: Floats) -> float:
    """Return the area of a polygon, px^2; positive when walked clockwise on the screen."""
    x, y = polygon_px[:, 0], polygon_px[:, 1]
    return float(0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum())


def figure_height(mask: NDArray[np.float32]) -> float:
    """Return the height of the person in a probability mask (p > 0.5), px; 0 without one."""
    rows = np.flatnonzero((mask > 0.5).any(axis=1))
    return float(rows[-1] - rows[0] + 1) if len(rows) else 0.0


def resample_closed(polygon_px: Floats, *, step_px: float = 1.0) -> Floats:
    """Return a closed polygon's points at equal arc steps.

    Parameters
    ----------
    polygon_px : ndarray, shape (N, 2), float64
        Corners, the last not repeating the first, px.
    step_px : float
        Wanted step; the nearest that divides the circumference is taken.

    Returns
    -------
    ndarray, shape (M, 2), float64
    """
    closed = np.vstack([polygon_px, polygon_px[:1]])
    arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    count = max(round(float(arc[-1]) / step_px), 3)
    at = np.linspace(0.0, arc[-1], count, endpoint=False)
    return np.column_stack([np.interp(at, arc, closed[:, k]) for k in (0, 1)])


def loop_from_polygon(polygon_px: Floats, *, height_px: float, is_hole: bool) -> MaskLoop:
    """Return a closed contour with smooth directions.

    Parameters
    ----------
    polygon_px : ndarray, shape (N, 2), float64
        Corners in either sense, px.
    height_px : float
        Figure height, px; sets the arc over which directions are averaged.
    is_hole : bool
        Whether the person lies outside the polygon.
    """
    # Person on the right hand: outer contours clockwise on the screen, holes the other way.
    if (signed_area(polygon_px) < 0) != is_hole:
        polygon_px = polygon_px[::-1]
    return loop_from_points(resample_closed(polygon_px), height_px=height_px, is_hole=is_hole)


def loop_from_points(points: Floats, *, height_px: float, is_hole: bool) -> MaskLoop:
    """Return a closed contour of given points, about 1 px apart, walked with the person on the right hand."""
    sigma = max(DIRECTION_ARC * height_px / 2, 1.0)
    smooth = gaussian_filter1d(points, sigma, axis=0, mode="wrap")
    tangents = np.roll(smooth, -1, axis=0) - np.roll(smooth, 1, axis=0)
    tangents /= np.maximum(np.linalg.norm(tangents, axis=1, keepdims=True), 1e-9)
    inward = np.column_stack([-tangents[:, 1], tangents[:, 0]])
    return MaskLoop(points, tangents, inward, is_hole)


def mask_loops(mask: NDArray[np.float32], *, height_px: float) -> list[MaskLoop]:
    """Return the contours of a person mask at probability one half, largest first.

    Parameters
    ----------
    mask : ndarray, shape (H, W), float32
        Probability 0..1.  Beyond the picture it counts as 0, so a person cut by the border is
        closed along the outer edge of the border pixels.
    height_px : float
        Figure height, px; contours are kept by their area in its squares.

    Returns
    -------
    list of MaskLoop
        Sub-pixel contours of bodies and of holes.
    """
    rows = np.flatnonzero((mask > 0.25).any(axis=1))
    columns = np.flatnonzero((mask > 0.25).any(axis=0))
    if len(rows) == 0:
        return []
    top, left = max(int(rows[0]) - 1, 0), max(int(columns[0]) - 1, 0)
    part = mask[top : int(rows[-1]) + 2, left : int(columns[-1]) + 2]
    loops = []
    for contour in find_contours(np.pad(part, 1), 0.5):
        polygon = contour[:-1, ::-1] + np.array([left - 1.0, top - 1.0])
        if len(polygon) < 8:
            continue
        area = signed_area(polygon)
        is_hole = area * _BODY_SIGN < 0
        least = (LEAST_HOLE_AREA if is_hole else LEAST_BODY_AREA) * height_px**2
        if abs(area) >= least:
            loops.append(loop_from_polygon(polygon, height_px=height_px, is_hole=is_hole))
    return sorted(loops, key=lambda loop: -len(loop.points))


def _sign_of_bodies() -> float:
    """Return the sign that find_contours gives the area of a bright blob."""
    blob = np.zeros((5, 5))
    blob[2, 2] = 1.0
    return float(np.sign(signed_area(find_contours(blob, 0.5)[0][:-1, ::-1])))


_BODY_SIGN = _sign_of_bodies()


def fill_polygons(polygons_px: list[Floats], are_holes: list[bool], shape: tuple[int, int]) -> Bools:
    """Return the pixels whose centres lie in the bodies and in no hole.

    Parameters
    ----------
    polygons_px : list of ndarray, shape (M, 2), float64
    are_holes : list of bool
    shape : tuple of int
        (H, W) of the picture.

    Returns
    -------
    ndarray, shape (H, W), bool
        Exact at pixel centres: cv2.fillPoly would also set every pixel it touches, which
        grows a figure by half a pixel.
    """
    filled = np.zeros(shape, dtype=bool)
    for wanted in (False, True):
        for polygon, is_hole in zip(polygons_px, are_holes, strict=True):
            if is_hole == wanted:
                filled[fill_polygon(polygon, shape)] = not is_hole
    return filled


def fill_polygon(polygon_px: Floats, shape: tuple[int, int]) -> Bools:
    """Return the pixels whose centres a closed polygon winds around.

    Each side crosses the pixel rows between its ends; the running sum of the crossings'
    signs along a row is the winding number.

    Parameters
    ----------
    polygon_px : ndarray, shape (M, 2), float64
    shape : tuple of int
        (H, W) of the picture.

    Returns
    -------
    ndarray, shape (H, W), bool
    """
    ahead = np.roll(polygon_px, -1, axis=0)
    low = np.ceil(np.minimum(polygon_px[:, 1], ahead[:, 1])).astype(np.intp)
    count = np.ceil(np.maximum(polygon_px[:, 1], ahead[:, 1])).astype(np.intp) - low
    side = np.repeat(np.arange(len(count)), count)
    rows = low[side] + np.arange(len(side)) - np.repeat(np.cumsum(count) - count, count)
    delta = (ahead - polygon_px)[side]
    x = polygon_px[side, 0] + (rows - polygon_px[side, 1]) * delta[:, 0] / delta[:, 1]
    columns = np.clip(np.ceil(x), 0, shape[1]).astype(np.intp)
    seen = (rows >= 0) & (rows < shape[0])
    flat = rows[seen] * (shape[1] + 1) + columns[seen]
    signs = np.sign(delta[seen, 1])
    crossings = np.bincount(flat, weights=signs, minlength=shape[0] * (shape[1] + 1))
    turns = np.rint(crossings).astype(np.int16).reshape(shape[0], shape[1] + 1)
    return np.asarray(np.cumsum(turns, axis=1, dtype=np.int16)[:, :-1] != 0)


def place_feature_points(loop: MaskLoop, *, spacing_px: float, smooth_px: float) -> Ints:
    """Choose outline feature points: corners of the contour, and regular ones between.

    Parameters
    ----------
    loop : MaskLoop
    spacing_px : float
        Longest feature segment wanted, px.
    smooth_px : float
        Scale at which corners are looked for, px.

    Returns
    -------
    ndarray, shape (K,), intp
        Increasing indices into ``loop.points``; at least two.
    """
    size = len(loop.points)
    smooth = gaussian_filter1d(loop.points, smooth_px, axis=0, mode="wrap")
    first = (np.roll(smooth, -1, axis=0) - np.roll(smooth, 1, axis=0)) / 2
    second = np.roll(smooth, -1, axis=0) - 2 * smooth + np.roll(smooth, 1, axis=0)
    speed = np.maximum(np.linalg.norm(first, axis=1), 1e-3)
    turn = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / speed**3
    chosen: list[int] = []
    # Corners turn by more than 45 degrees within the smoothing scale on either side.
    for index in np.argsort(-turn, kind="stable"):
        if turn[index] * smooth_px < np.pi / 8:
            break
        if all(min(abs(index - c), size - abs(index - c)) > 3 * smooth_px for c in chosen):
            chosen.append(int(index))
    return fill_between(np.array(sorted(chosen), dtype=np.intp), size, spacing=spacing_px)


def fill_between(indices: Ints, size: int, *, spacing: float) -> Ints:
    """Add indices between sorted cyclic ones until none are farther apart than ``spacing``."""
    if len(indices) == 0:
        indices = np.zeros(1, dtype=np.intp)
    result: list[int] = []
    for at, following in zip(indices, np.append(indices[1:], indices[0] + size), strict=True):
        pieces = max(int(np.ceil((following - at) / spacing)), 2 if len(indices) == 1 else 1)
        result.extend(np.linspace(at, following, pieces, endpoint=False).astype(int) % size)
    return np.unique(np.array(result, dtype=np.intp))
