"""Measurements on a soft mask: the outline beside an axis, and gaps of background between two limbs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array

Bools = NDArray[np.bool_]

#: Probability at which the outline lies.
EDGE: Final = 0.5
#: Share of the figure's height over which profiles are smoothed before extremes are sought (taste).
SMOOTH: Final = 0.004
#: Least share of a picture's border that the figure must cover to count as cut there, in figure heights.
_CUT: Final = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class SoftMask:
    """A person's soft mask with its extent.

    Attributes
    ----------
    level : (H, W) float32, probability 0..1
    top_px, bottom_px : (2,) float64
        Middle of the highest and of the lowest run of pixels, on the outline, px.
    cut : tuple of str
        Borders of the picture ("top", "bottom", "left", "right") that cut the person.
    """

    level: NDArray[np.float32]
    top_px: Array
    bottom_px: Array
    cut: tuple[str, ...]

    @property
    def height_px(self) -> float:
        """Return the person's height, px."""
        return float(self.bottom_px[1] - self.top_px[1])

    def inside(self, points_px: Array) -> Bools:
        """Return whether points (N, 2) lie on the person, (N,)."""
        return np.asarray(sample(self.level, points_px) > EDGE)

    def crossing(self, inner_px: Array, outer_px: Array) -> Array:
        """Return the subpixel outline (2,) between a point on the person and one beside it."""
        within, beyond = (float(value) for value in sample(self.level, np.stack([inner_px, outer_px])))
        share = np.clip((within - EDGE) / max(within - beyond, 1e-6), 0.0, 1.0)
        return np.asarray(inner_px + share * (outer_px - inner_px))


def soft_mask(mask: NDArray[np.uint8]) -> SoftMask | None:
    """Return the soft mask (H, W) 0..255 with its extent, None when it shows nobody."""
    level = np.asarray(mask, dtype=np.float32) / np.float32(255.0)
    inside = level > EDGE
    rows = np.flatnonzero(inside.any(axis=1))
    if len(rows) < 8:
        return None
    columns = np.flatnonzero(inside.any(axis=0))
    least = _CUT * (rows[-1] - rows[0])
    borders = {"top": inside[0], "bottom": inside[-1], "left": inside[:, 0], "right": inside[:, -1]}
    cut = tuple(name for name, border in borders.items() if np.count_nonzero(border) > least)
    top = _end(level, int(rows[0]), -1)
    return SoftMask(level, top, _end(level, int(rows[-1]), 1), cut if len(columns) else ())


def _end(level: NDArray[np.float32], row: int, step: int) -> Array:
    """Return the middle of an outermost row's pixels and its sub-pixel row."""
    columns = np.flatnonzero(level[row] > EDGE)
    column = float(columns.mean())
    here, beyond = float(level[row, columns].max()), 0.0
    if 0 <= row + step < len(level):
        beyond = float(level[row + step, columns].max())
    share = (here - EDGE) / max(here - beyond, 1e-6)
    return np.array([column, row + step * min(share, 1.0)])


def sample(level: NDArray[np.float32], points_px: Array) -> NDArray[np.float32]:
    """Return bilinear samples of an image at (..., 2) pixels; 0 outside."""
    flat = np.ascontiguousarray(points_px.reshape(-1, 2), dtype=np.float32)
    width = 4096  # cv2.remap takes no side above 32767
    padded = np.full((-(-len(flat) // width) * width, 2), -10.0, dtype=np.float32)
    padded[: len(flat)] = flat
    grid = padded.reshape(-1, width, 2)
    drawn = cv2.remap(level, grid[..., 0], grid[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT)
    return np.asarray(drawn.ravel()[: len(flat)].reshape(points_px.shape[:-1]), dtype=np.float32)


@dataclass(frozen=True, slots=True, eq=False)
class Strip:
    """The outline on both sides of an axis.

    Attributes
    ----------
    centres_px, across : (T, 2) float64
        Places on the axis, and unit vectors across it.
    near, far : (T,) float64
        Signed distance along ``across`` of the first border on its negative and positive
        side, px; NaN where the axis misses the person or no border is in reach.
    """

    centres_px: Array
    across: Array
    near: Array
    far: Array

    @property
    def width(self) -> Array:
        """Return the distance between the borders, (T,) px."""
        return np.asarray(self.far - self.near)

    @property
    def middle_px(self) -> Array:
        """Return the middle between the borders, (T, 2) px."""
        return np.asarray(self.centres_px + 0.5 * (self.near + self.far)[:, None] * self.across)

    def border_px(self, place: float, *, far: bool) -> Array | None:
        """Return the border point (2,) at a (fractional) row of the strip, None where there is none."""
        distance = self.far if far else self.near
        low = int(np.clip(np.floor(place), 0, len(distance) - 1))
        rows = np.array([low, min(low + 1, len(distance) - 1)])
        if not 0 <= place <= len(distance) - 1 or not np.isfinite(distance[rows]).all():
            return None
        share = place - low
        ends = self.centres_px[rows] + distance[rows, None] * self.across[rows]
        return np.asarray((1.0 - share) * ends[0] + share * ends[1])

    def nearest_px(self, point_px: Array, *, far: bool, reach_px: float) -> Array | None:
        """Return the border point (2,) nearest to a point, None when there is none within reach."""
        distance = self.far if far else self.near
        borders = self.centres_px + distance[:, None] * self.across
        away = np.linalg.norm(borders - point_px, axis=1)
        if not (away <= reach_px).any():
            return None
        return np.asarray(borders[int(np.nanargmin(away))])


def walk_strip(figure: SoftMask, centres_px: Array, across: Array, reach_px: float, *, slack_px: float = 0.0) -> Strip:
    """Return the first borders on both sides of an axis, subpixel, from the soft mask.

    Parameters
    ----------
    figure : Figure
    centres_px : (T, 2) float64
    across : (T, 2) float64
        Unit vectors.
    reach_px : float
        Farthest border that is looked for.
    slack_px : float
        How far beside the person the axis may run.
    """
    offsets = np.arange(-np.ceil(reach_px), np.ceil(reach_px) + 1.0)
    values = sample(figure.level, centres_px[:, None] + offsets[None, :, None] * across[:, None])
    inside = values > EDGE
    cost = np.where(inside, np.abs(offsets), np.inf)
    start = cost.argmin(axis=1)
    lost = cost[np.arange(len(cost)), start] > slack_px + 1.0
    places = np.arange(len(offsets))
    far = _first_border(values, ~inside & (places > start[:, None]), 1, offsets)
    near = _first_border(values, ~inside & (places < start[:, None]), -1, offsets)
    return Strip(centres_px, across, np.where(lost, np.nan, near), np.where(lost, np.nan, far))


def _first_border(values: NDArray[np.float32], outside: Bools, step: int, offsets: Array) -> Array:
    """Return the offset at which the mask is crossed before the first outside sample; NaN without one."""
    found = outside.any(axis=1)
    rows = np.arange(len(values))
    first = outside.argmax(axis=1) if step > 0 else outside.shape[1] - 1 - outside[:, ::-1].argmax(axis=1)
    last = np.clip(first - step, 0, values.shape[1] - 1)
    within, beyond = values[rows, last].astype(np.float64), values[rows, first].astype(np.float64)
    share = np.clip((within - EDGE) / np.maximum(within - beyond, 1e-6), 0.0, 1.0)
    return np.where(found, offsets[last] + step * share, np.nan)


def polyline(points_px: Array, step_px: float = 1.0) -> tuple[Array, Array]:
    """Return places (T, 2) every ``step_px`` along a polyline (K, 2), and their path lengths (T,)."""
    pieces = np.linalg.norm(np.diff(points_px, axis=0), axis=1)
    corners = np.concatenate([[0.0], np.cumsum(pieces)])
    along = np.arange(0.0, corners[-1] + 1e-9, step_px)
    return np.stack([np.interp(along, corners, points_px[:, axis]) for axis in (0, 1)], axis=1), along


def smoothed(profile: Array, sigma: float) -> Array:
    """Return a profile (T,) smoothed by a Gaussian that ignores NaN; NaN stays NaN."""
    known = np.isfinite(profile)
    if sigma <= 0 or not known.any():
        return profile
    reach = int(np.ceil(3 * sigma))
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    total = np.convolve(np.where(known, profile, 0.0), kernel, mode="full")[reach : reach + len(profile)]
    weight = np.convolve(known.astype(np.float64), kernel, mode="full")[reach : reach + len(profile)]
    return np.where(known, total / np.maximum(weight, 1e-12), np.nan)


def extreme(profile: Array, start: float, end: float, *, largest: bool) -> float | None:
    """Return the place of an interior extreme of a profile between two places, None without one.

    An extreme at the end of the window is none: the profile only rises or falls there.
    """
    low, high = int(np.ceil(max(start, 0.0))), int(np.floor(min(end, len(profile) - 1.0)))
    window = profile[low : high + 1]
    if len(window) < 5 or np.count_nonzero(np.isfinite(window)) < 0.7 * len(window):
        return None
    signed = np.where(np.isfinite(window), window if largest else -window, -np.inf)
    at = int(signed.argmax())
    if at in (0, len(window) - 1) or not np.isfinite(signed[at - 1 : at + 2]).all():
        return None
    left, here, right = signed[at - 1 : at + 2]
    bend = left - 2.0 * here + right
    return float(low + at + (0.5 * (left - right) / bend if bend < -1e-9 else 0.0))


def gap_between(figure: SoftMask, first_px: Array, second_px: Array) -> Array:
    """Return the width (T,) px of the background between two axes, row by row: 0 where the person fills it.

    Parameters
    ----------
    first_px, second_px : (T, 2) float64
        Places on two limbs' axes, one pair a row.
    """
    span = np.linalg.norm(second_px - first_px, axis=1)
    count = int(max(np.ceil(span.max(initial=2.0)), 2))
    share = np.linspace(0.0, 1.0, count)
    values = sample(figure.level, first_px[:, None] + share[None, :, None] * (second_px - first_px)[:, None])
    outside = values <= EDGE
    # background at an axis itself belongs to no gap: the axis has left its limb there
    opened = np.maximum.accumulate(~outside, axis=1)
    closed = np.maximum.accumulate(~outside[:, ::-1], axis=1)[:, ::-1]
    return np.asarray((outside & opened & closed).mean(axis=1) * span)


def gap_top(gap_px: Array, least_px: float) -> int | None:
    """Return the first row from which a gap stays open for ``least_px`` rows, None without one."""
    open_rows = gap_px > 0.0
    run = 0
    for row, is_open in enumerate(open_rows):
        run = run + 1 if is_open else 0
        if run >= least_px:
            return row - run + 1
    return None


def gap_apex(figure: SoftMask, first_px: Array, second_px: Array) -> Array:
    """Return the subpixel top (2,) of the gap whose first open row lies between two pixels of that row."""
    count = int(max(np.ceil(abs(second_px[0] - first_px[0])), 2))
    row = first_px[None] + np.linspace(0.0, 1.0, count)[:, None] * (second_px - first_px)[None]
    values = sample(figure.level, row)
    column = row[int(values.argmin()), 0]
    above = np.stack([np.full(9, column), first_px[1] - np.arange(9.0)], axis=1)
    climb = sample(figure.level, above)
    inside = np.flatnonzero(climb > EDGE)
    if len(inside) == 0 or inside[0] == 0:
        return np.array([column, first_px[1]])
    k = int(inside[0])
    share = (EDGE - float(climb[k - 1])) / max(float(climb[k] - climb[k - 1]), 1e-6)
    return np.array([column, first_px[1] - (k - 1 + share)])
