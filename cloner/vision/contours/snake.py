"""The structured snake: a curve pulled on to image edges by its gradient, while springs keep its structure (method §3).

A curve's points know where they lie towards their neighbours. Edges pull along the curve's normals only, with the
strength of their gradient; springs hold every point at its place relative to its neighbours; anchors hold what is
known. Each turn looks for edges anew in a narrower band and solves one small linear system.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/vision.toml``.
_CALIBRATED: Final = calibrated("vision.snake")

Picture = NDArray[np.float32]
Sign = Literal["any", "rising", "falling", "line"]

_STEP_PX: Final = _CALIBRATED.number("step_px", "px")
_HALF_GRADIENT: Final = _CALIBRATED.number("half_gradient", "grey")
_RIVAL: Final = _CALIBRATED.number("rival", "factor")


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """A curve to be pulled.

    Attributes
    ----------
    points_px : (N, 2) float64
        Where it probably lies; its structure.
    closed : bool
    anchors : (N,) float64
        How strongly each point is held where it is, 0 not at all; in units of the springs.
    sign : "any", "rising", "falling" or "line"
        What the edge is like along the normal, which lies to the right of the curve's direction as seen: any edge, one
        to brighter or to darker pixels, or the middle of a dark line.
    """

    points_px: Array
    closed: bool
    anchors: Array
    sign: Sign


@dataclass(frozen=True, slots=True)
class SnakeParams:
    """How a snake moves; lengths in pixels.

    Attributes
    ----------
    reach_px : float
        How far edges are looked for in the first turn; half of it in the last.
    spring : float
        Stiffness of the structure against the pull of a sure edge.
    turns : int
    """

    reach_px: float
    spring: float = _CALIBRATED.number("spring", "factor")
    turns: int = 4


def normals(points_px: Array, *, closed: bool) -> Array:
    """Return (N, 2) unit normals: to the right of the curve's direction as seen (x right, y down)."""
    if closed:
        along = np.roll(points_px, -1, axis=0) - np.roll(points_px, 1, axis=0)
    else:
        along = np.gradient(points_px, axis=0)
    along = along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    return np.column_stack([-along[:, 1], along[:, 0]])


def sample_along_normals(picture: Picture, points_px: Array, across: Array, reach_px: float) -> tuple[Array, Array]:
    """Return offsets (S,) and the smoothed picture (N, S, C) along normals.

    Parameters
    ----------
    picture : (H, W, C) float32, grey levels
    points_px, across : (N, 2) float64
    reach_px : float
    """
    count = int(np.ceil(reach_px / _STEP_PX)) + 2
    offsets: Array = _STEP_PX * np.arange(-count, count + 1, dtype=np.float64)
    place = points_px[:, None] + offsets[None, :, None] * across[:, None]
    x, y = place[..., 0].astype(np.float32), place[..., 1].astype(np.float32)
    seen = cv2.remap(picture, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return offsets, np.asarray(seen, dtype=np.float64).reshape(*x.shape, -1)


def find_edges(picture: Picture, points_px: Array, across: Array, reach_px: float, sign: Sign) -> tuple[Array, Array]:
    """Return the offset of each point's best edge along its normal, (N,) px, and its confidence, (N,) 0..1.

    The offset is refined by a parabola through the gradient's peak, which gives parts of a pixel.
    """
    offsets, seen = sample_along_normals(picture, points_px, across, reach_px)
    slope: Array = np.asarray(np.gradient(seen, _STEP_PX, axis=1))
    strength: Array
    if sign == "line":
        strength = np.asarray(
            np.gradient(slope.mean(axis=2), _STEP_PX, axis=1)
        )  # a dark line's middle curves upwards most
    elif sign == "any":
        strength = np.linalg.norm(slope, axis=2) / np.sqrt(slope.shape[2])
    else:
        strength = slope.mean(axis=2) * (1.0 if sign == "rising" else -1.0)
    near = np.exp(-0.5 * (offsets / (0.6 * reach_px)) ** 2)
    score = np.maximum(strength, 0.0) * near
    score[:, [0, -1]] = 0.0
    best = score.argmax(axis=1)
    rows = np.arange(len(best))
    before, here, after = (score[rows, np.clip(best + k, 0, len(offsets) - 1)] for k in (-1, 0, 1))
    bend = before - 2.0 * here + after
    part = np.where(bend < -1e-9, 0.5 * (before - after) / np.where(bend < -1e-9, bend, -1.0), 0.0)
    rivals = score.copy()
    apart = np.abs(offsets[None] - offsets[best][:, None]) < 0.35 * reach_px
    rivals[apart] = 0.0
    alone = np.clip((1.0 - rivals.max(axis=1) / np.maximum(here, 1e-9)) / (1.0 - _RIVAL), 0.0, 1.0)
    trust = here**2 / (here**2 + _HALF_GRADIENT**2) * (0.3 + 0.7 * alone)
    return offsets[best] + _STEP_PX * np.clip(part, -0.5, 0.5), trust


def spring_matrix(count: int, *, closed: bool) -> Array:
    """Return the (E, N) matrix of first and second differences between neighbours, scaled by their number at rest."""
    rows = []
    for step in (1, 2):
        for first in range(count if closed else count - step):
            row = np.zeros(count)
            row[first], row[(first + step) % count] = -1.0, 1.0
            rows.append(row / step)
    return np.array(rows).reshape(-1, count)


def run_snake(picture: Picture, curve: Curve, params: SnakeParams) -> tuple[Array, Array]:
    """Return the curve on the image's edges, (N, 2) px, and the confidence of each point's last edge, (N,) 0..1.

    Parameters
    ----------
    picture : (H, W) or (H, W, C) float32
        Grey levels, smoothed over about a pixel.
    curve : Curve
    params : SnakeParams

    Notes
    -----
    Minimised are, over points x with structure r: the sum of trust (n . (x - edge))^2, of spring |(x_j - x_i) -
    (r_j - r_i)|^2 between neighbours, and of anchors |x - r|^2. The paper names these terms but gives no formula.

    References
    ----------
    Lee, Gu, Magnenat-Thalmann 2000, section 2.1; Kass, Witkin, Terzopoulos 1988.
    """
    rest, count = curve.points_px, len(curve.points_px)
    springs = spring_matrix(count, closed=curve.closed)
    held = params.spring * (springs.T @ springs) + np.diag(curve.anchors * params.spring + 1e-4)
    stiff = np.kron(held, np.eye(2))
    now, trust = rest.copy(), np.zeros(count)
    for turn in range(params.turns):
        across = normals(now, closed=curve.closed)
        reach = params.reach_px * (1.0 - 0.5 * turn / max(params.turns - 1, 1))
        offset, trust = find_edges(picture, now, across, reach, curve.sign)
        edge = ((now - rest) * across).sum(axis=1) + offset
        system, right = stiff.copy(), np.zeros(2 * count)
        for row in range(count):
            block = slice(2 * row, 2 * row + 2)
            system[block, block] += trust[row] * np.outer(across[row], across[row])
            right[block] = trust[row] * edge[row] * across[row]
        now = rest + np.linalg.solve(system, right).reshape(count, 2)
    return now, trust


def snake_picture(rgb: NDArray[np.uint8], points_px: Array, *, unit_px: float, unit: float) -> tuple[Picture, Array]:
    """Return the part of a photo around points at a standard size, and the (2, 3) map from photo px to its px.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    points_px : (N, 2)
    unit_px : float
        A known length in the photo, for example the eye distance.
    unit : float
        The same in the result, px.
    """
    scale = min(unit / unit_px, 1.0)
    low, high = points_px.min(axis=0) - 0.6 * unit_px, points_px.max(axis=0) + 0.6 * unit_px
    low = np.maximum(np.floor(low), 0).astype(int)
    high = np.minimum(np.ceil(high), [rgb.shape[1], rgb.shape[0]]).astype(int)
    part = rgb[low[1] : high[1], low[0] : high[0]]
    if min(part.shape[:2]) < 2:
        return np.zeros((2, 2, 3), np.float32), np.array([[1.0, 0.0, -low[0]], [0.0, 1.0, -low[1]]])
    size = (max(2, round(part.shape[1] * scale)), max(2, round(part.shape[0] * scale)))
    small = cv2.resize(part, size, interpolation=cv2.INTER_AREA) if scale < 1.0 else part
    smooth = cv2.GaussianBlur(small.astype(np.float32), (0, 0), 1.0)
    ratio = np.array([size[0] / part.shape[1], size[1] / part.shape[0]])
    shift = (0.5 - low) * ratio - 0.5
    return np.asarray(smooth, np.float32), np.column_stack([np.diag(ratio), shift])
