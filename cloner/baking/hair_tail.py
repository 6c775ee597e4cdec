"""Hair that stands free of the head (tails, plaits) from side and back photos."""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.baking.hair_views import FAR_MM, HairView
from cloner.frames import ViewId, m_from_mm, mm_from_m

Array = NDArray[np.float64]

ROUND_TAIL = (0.6, 2.5)  # a tail's width against its depth: limits of what is believed
WIDEST_TAIL_MM = 110.0  # wider hair in the back photo is the head's, not a tail's
THINNEST_MM = 4.0  # free hair thinner than this is noise of the labels
GRID_STEP_MM = 5.0  # cap points lie this far apart at most; closing makes their picture solid


def tail_mm(views: list[HairView], cap_m: Array, points_m: Array, middle_m: float) -> NDArray[np.float32]:
    """Return (N,) how deep points lie inside free hair, millimetres, -FAR where there is none.

    Side photos show the tail's shape; its width is that of a round tail scaled
    to what the back photo shows. Round: at distance d from the edge of a
    strand with half thickness R the half width is sqrt(d (2 R - d)).

    Parameters
    ----------
    views : list of HairView
    cap_m : (M, 3) points of the cap, which is no tail
    points_m : (N, 3)
    middle_m : float
        x of the head's middle, used where no back photo tells.
    """
    found = np.full(len(points_m), -FAR_MM, np.float32)
    for view in views:
        if view.posed.view not in (ViewId.BODY_SIDE, ViewId.FACE_SIDE) or view.flip_m is not None or not len(cap_m):
            continue
        free = free_hair(view, cap_m)
        if free.any():
            found = np.maximum(found, _inflate(views, view, free, points_m, middle_m))
    return found


def _inflate(
    views: list[HairView], view: HairView, free: NDArray[np.bool_], points_m: Array, middle_m: float
) -> NDArray[np.float32]:
    """Return the field of the round tail that one side photo shows."""
    inside = cv2.distanceTransform(free.astype(np.uint8), cv2.DIST_L2, 5)
    reach = 2 * int(np.ceil(inside.max())) + 1
    radius = cv2.dilate(inside, np.ones((reach, reach), np.uint8))  # a square is separable: 50 times faster than a disc
    half = np.sqrt(np.clip(inside * (2.0 * radius - inside), 0.0, None))
    camera = view.posed.camera
    posed = view.to_view(points_m)
    scale = mm_from_m(camera.metres_per_pixel(posed.mean(axis=0)))
    column, row = np.rint(camera.project(posed)).astype(int).T
    height, width = free.shape
    shown = (row >= 0) & (column >= 0) & (row < height) & (column < width)
    row, column = np.where(shown, row, 0), np.where(shown, column, 0)
    centre, ratio = tail_course(views, view, free, middle_m)
    lateral = mm_from_m(1.0) * np.abs(points_m[:, 0] - centre(points_m[:, 1]))
    field = half[row, column] * scale * ratio - lateral
    return np.where(shown & free[row, column], field, -FAR_MM).astype(np.float32)


def free_hair(view: HairView, cap_m: Array) -> NDArray[np.bool_]:
    """Return (H, W) hair pixels of a side photo beside both body and cap."""
    height, width = view.hair.shape
    camera = view.posed.camera
    posed = view.to_view(cap_m)
    pixel_m = camera.metres_per_pixel(posed.mean(axis=0))
    pixel = np.rint(camera.project(posed)).astype(int)
    shown = (pixel >= 0).all(axis=1) & (pixel < (width, height)).all(axis=1)
    covered = np.zeros((height, width), np.uint8)
    covered[pixel[shown, 1], pixel[shown, 0]] = 1
    step = 2 * int(np.ceil(m_from_mm(GRID_STEP_MM) / pixel_m)) + 1
    covered = cv2.morphologyEx(covered, cv2.MORPH_CLOSE, np.ones((step, step), np.uint8))
    body = cv2.resize(
        np.isfinite(view.nearest_m).astype(np.uint8), (width, height), interpolation=cv2.INTER_NEAREST
    )
    free = (view.hair & (covered == 0) & (body == 0)).astype(np.uint8)
    least = max(3, int(np.ceil(m_from_mm(THINNEST_MM) / pixel_m)))
    return np.asarray(cv2.morphologyEx(free, cv2.MORPH_OPEN, np.ones((least, least), np.uint8)) > 0)


def tail_course(
    views: list[HairView], side: HairView, free: NDArray[np.bool_], middle_m: float
) -> tuple[Callable[[Array], Array], float]:
    """Return a tail's middle x as a function of height, and its width against its depth.

    Both come from the rows of the back photo in which the tail stands alone.
    """
    rows = np.flatnonzero(free.any(axis=1))[::4]
    first = free[rows].argmax(axis=1)
    last = free.shape[1] - 1 - free[rows][:, ::-1].argmax(axis=1)
    camera = side.posed.camera
    near = np.repeat(side.to_view(_head_middle(side, middle_m)), len(rows), axis=0)
    ends = [camera.back_project(np.column_stack([edge, rows]).astype(float), near) for edge in (first, last)]
    posed = 0.5 * (ends[0] + ends[1])
    depth_m = np.linalg.norm(ends[1] - ends[0], axis=1)
    rest = (posed - side.view_from_rest[:3, 3]) @ side.view_from_rest[:3, :3]
    back = next((v for v in views if v.posed.view is ViewId.BODY_BACK), None)
    found = [_back_width(back, point) for point in rest] if back is not None else []
    good = [k for k, width in enumerate(found) if width is not None]
    if not good:
        return (lambda height_m: np.full(len(height_m), middle_m)), 1.0
    widths = np.array([found[k] for k in good])
    order = np.argsort(rest[good, 1])
    heights, centres = rest[good, 1][order], widths[order, 0]
    ratio = float(np.clip(np.median(widths[:, 1] / np.maximum(depth_m[good], 1e-3)), *ROUND_TAIL))
    return (lambda height_m: np.interp(height_m, heights, centres)), ratio


def _head_middle(view: HairView, middle_m: float) -> Array:
    """Return a rest point (1, 3) in the head's middle plane, as near the photo's middle as can be."""
    inverse = view.view_from_rest[:3, :3].T
    origin = inverse @ (view.posed.camera.position_m - view.view_from_rest[:3, 3])
    return np.array([[middle_m, origin[1], 0.0]])


def _back_width(back: HairView | None, point_m: Array) -> tuple[float, float] | None:
    """Return the middle x and width, metres, of the hair around a rest point in the back photo, None if too wide."""
    if back is None:
        return None
    camera = back.posed.camera
    posed = back.to_view(point_m[None])
    column, row = np.rint(camera.project(posed)[0]).astype(int)
    height, width = back.hair.shape
    if not (0 <= row < height and 0 <= column < width) or not back.hair[row, column]:
        return None
    line = back.hair[row]
    left = column - int(line[column::-1].argmin() if not line[: column + 1].all() else column) + 1
    right = column + int(line[column:].argmin() if not line[column:].all() else width - column) - 1
    pixel_m = camera.metres_per_pixel(posed[0])
    if mm_from_m((right - left + 1) * pixel_m) > WIDEST_TAIL_MM:
        return None
    centre = camera.back_project(np.array([[0.5 * (left + right), float(row)]]), posed)
    rest = (centre - back.view_from_rest[:3, 3]) @ back.view_from_rest[:3, :3]
    return float(rest[0, 0]), (right - left + 1) * pixel_m
