"""Displacement of photo lookups until a projected mesh outline meets the photo's outline."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array
from cloner.vision.photographs.blending import push_pull

GRID_PX = 8  # the warp is smooth: one node every 8 photo pixels
SMOOTH_NODES = 3.0  # taste: about the width of a forearm, so that both its sides move together
ROUNDS = 3  # smoothing shortens a displacement that turns along the outline; the rest is spread again
STEEPEST_COSINE = 0.6  # outlines that run in different directions are different outlines


def outline_shift(
    mesh_mask: NDArray[np.bool_],
    inside_px: NDArray[np.float32],
    usable: NDArray[np.bool_],
    limit_px: float,
    placed_px: Array | None = None,
) -> tuple[NDArray[np.float32], float]:
    """Return a smooth displacement field from mesh outline to photo outline.

    Parameters
    ----------
    mesh_mask : (H, W) bool, the projected mesh at photo resolution
    inside_px : (H, W) float32, signed distance to the photo's outline, positive inside
    usable : (H, W) bool
        False where the photo's outline is not the body's (hair) or the photo's border.
    limit_px : float
        Outline points farther apart than this are not matched.
    placed_px : (N, 2) float64, optional
        Where the mesh lies on the photo already, as a face does that was fitted to points: what is amiss at outlines
        elsewhere does not move it.

    Returns
    -------
    field : (H // GRID_PX + 1, W // GRID_PX + 1, 2) float32
        Displacement (x, y) in photo pixels; zero when nothing matches.
    gap_px : float
        Mean distance of the matched outline points before the shift.
    """
    height, width = mesh_mask.shape
    shape = (height // GRID_PX + 1, width // GRID_PX + 1)
    points = _outline_points(mesh_mask)
    if len(points) == 0:
        return np.zeros((*shape, 2), np.float32), 0.0
    soft = cv2.GaussianBlur(inside_px, (0, 0), 2.0)
    own = cv2.GaussianBlur(mesh_mask.astype(np.float32), (0, 0), 3.0)
    column, row = points.T
    slope = _unit(_gradients(soft, row, column))
    shift = -inside_px[row, column, None] * slope
    along: Array = np.asarray(np.sum(slope * _unit(_gradients(own, row, column)), axis=1), np.float64)
    target = np.rint(points + shift).astype(int)
    within: NDArray[np.bool_] = np.asarray((target >= 0).all(axis=1) & (target < (width, height)).all(axis=1), bool)
    target = np.where(within[:, None], target, 0)
    near: NDArray[np.bool_] = np.asarray(np.abs(inside_px[row, column]) < limit_px, bool)
    good = (along > STEEPEST_COSINE) & near & within & usable[row, column] & usable[target[:, 1], target[:, 0]]
    if not good.any():
        return np.zeros((*shape, 2), np.float32), 0.0
    still = np.zeros((0, 2)) if placed_px is None else placed_px
    known = np.concatenate([points[good], still])
    wanted = np.concatenate([shift[good], np.zeros_like(still)])
    field = np.zeros((*shape, 2), np.float32)
    for _ in range(ROUNDS):
        field += _interpolate_field(known, wanted - sample(field, known / GRID_PX), shape)
    return field, float(np.abs(inside_px[row, column][good]).mean())


def _outline_points(mask: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Return (N, 2) x, y of the outline's pixels, without those on the picture's border."""
    chains, _ = cv2.findContours(mask.astype(np.uint8), cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    if not chains:
        return np.zeros((0, 2), np.int64)
    points = np.concatenate([chain[:, 0] for chain in chains if len(chain) > 12] or [np.zeros((0, 2), np.int32)])
    height, width = mask.shape
    inner = (points > 2).all(axis=1) & (points < (width - 3, height - 3)).all(axis=1)
    return points[inner].astype(np.int64)


def _gradients(image: NDArray[np.float32], row: NDArray[np.int64], column: NDArray[np.int64]) -> NDArray[np.float32]:
    """Return (N, 2) slopes of an image across and down at some of its pixels."""
    orders = ((1, 0), (0, 1))
    return np.stack([cv2.Sobel(image, cv2.CV_32F, *o, scale=0.125)[row, column] for o in orders], axis=-1)


def _unit(vectors: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-6), np.float32)


def _interpolate_field(points: Array, shift: Array, shape: tuple[int, int]) -> NDArray[np.float32]:
    """Interpolate sparse displacements smoothly over the whole grid."""
    node = np.rint(points / GRID_PX).astype(int)
    flat = np.clip(node[:, 1], 0, shape[0] - 1) * shape[1] + np.clip(node[:, 0], 0, shape[1] - 1)
    size = shape[0] * shape[1]
    count = np.bincount(flat, minlength=size)
    total = np.stack([np.bincount(flat, shift[:, k], minlength=size) for k in range(2)], -1)
    mean = (total / np.maximum(count, 1)[:, None]).reshape(*shape, 2).astype(np.float32)
    known = (count > 0).reshape(shape).astype(np.float32)
    # Average neighbouring outline points first, then carry them into the inside.
    mass = cv2.GaussianBlur(known, (0, 0), SMOOTH_NODES)
    average = cv2.GaussianBlur(mean * known[..., None], (0, 0), SMOOTH_NODES) / np.maximum(mass, 1e-6)[..., None]
    field = push_pull(average.astype(np.float32), (mass > 0.02).astype(np.float32))
    return np.asarray(cv2.GaussianBlur(field, (0, 0), SMOOTH_NODES), np.float32)


def shift_points(points_px: Array, field: NDArray[np.float32]) -> Array:
    """Return (N, 2) points moved by a displacement field of :func:`outline_shift`."""
    return points_px + sample(field, points_px / GRID_PX)


def sample(image: NDArray[np.generic], points_px: NDArray[np.floating]) -> NDArray[np.float32]:
    """Return (N, C) bilinear samples of an image at (N, 2) pixels; borders repeat.

    The list is folded into rows because OpenCV's remap takes at most 32767 columns.
    """
    count, row_length = len(points_px), 4096
    rows = max(-(-count // row_length), 1)
    padded = np.zeros((rows * row_length, 2), np.float32)
    padded[:count] = points_px
    grid = padded.reshape(rows, row_length, 2)
    found = cv2.remap(image, grid, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    channels = 1 if image.ndim == 2 else image.shape[2]
    return np.asarray(found.reshape(-1, channels)[:count], np.float32)
