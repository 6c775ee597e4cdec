"""Loose clothing in one outline: cloth that fills the gap between the legs and ends in a hem.

A body's legs part gradually below the crotch; a skirt or coat fills the gap and
stands off on both sides until, within a few centimetres, it ends. The pose says
where the legs are inside.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d, median_filter

from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.loose import AROUND_LEGS, HEM_PLACES, LooseRegion
from cloner.vision.segmentation.leg_rows import LegRows, leg_rows

Bools = NDArray[np.bool_]

#: Everything below is a share of the figure's height in the photo.
ARC_SHARE = 0.045  # a level hem 0.25 m wide looks this high from a camera 0.7 m above it
HIGHEST_ARCH = 1.5  # a hem rises between its ends by so many arcs at most
STEEPEST = 0.8  # a hem's slope in the photo; the sides of legs are steeper
END_TRUST = 0.05  # an edge's end counts like this share of the hem's columns
LEAST_LEGLESS = 0.1  # of the hem's columns
BENT = 0.02  # resistance to arches: one arc costs as much as an error of a seventh of one
LOOSE_SHARE = 0.004  # hems are ragged by this
END_SHARE = 0.0015  # an edge ends where it falls behind its widest place by this
SETTLE_SHARE = 0.012  # outlines are smoothed over this
LEAST_DROP = 0.035  # a hem gives up this much width at once
SURE_DROP = 0.10
MOST = 0.85  # of the deepest drop
LEAST_STEP = 0.012  # both edges step in by this at a hem that is not seen to bridge the legs
LEAST_GAP = 0.018  # legs nearer to each other say nothing
CALVES, STANDS_OFF = (0.60, 0.95), 0.025  # where cloth to the floor stands off usual legs by this on both sides
LEAST_SEEN = 0.25  # of the rows above a hem; arms may hide the others
HIGH_DROP = 0.07  # so near the crotch, wide thighs that touch and then part can lose nearly as much
SURE_BRIDGE, LOW_BRIDGE = 0.05, 0.25  # narrow skirts step in little: they must bridge legs apart, well below the crotch
#: Shares of hip to ankle between which a hem is believed: above it is a jacket's; a near one looks lower than ankles.
HEMS = (0.20, 1.15)
SAME_HEM = 0.15  # levels of one hem in two photos, with the error of both poses (measured: 0.12 on a coat)
FILLED = 0.9  # of the rows above the hem
#: Below this share of hip to ankle so much of the room between the legs is enough: trousers of 65 people fill .25 at
#: most, a dress with holes in its mask .59 in one photo and .96 in the other.
KNEE, MOSTLY = 0.5, 0.6


@dataclass(frozen=True, slots=True)
class Hem:
    """The hem of cloth around the legs in one photo.

    Attributes
    ----------
    level : float
        Share of hip to ankle.
    confidence : float in 0..1
    bridges : bool
        Whether the cloth fills what the legs have apart; otherwise only both its edges step in at once.
    """

    level: float
    confidence: float
    bridges: bool


def find_hem(legs: LegRows, *, both_legs: bool, between: tuple[float, float] = HEMS) -> Hem | None:
    """Return the hem of cloth around the legs, None where there is none.

    Parameters
    ----------
    legs : LegRows
    both_legs : bool
        True when the photo shows the legs beside each other; from the side only the width can tell.
    between : levels where it is looked for
    """
    arc, settle = (max(2, round(share * legs.figure_px)) for share in (ARC_SHARE, SETTLE_SHARE))
    drops = np.zeros(len(legs.level))
    bridging, holed = np.zeros((2, len(legs.level)), dtype=np.bool_)
    for row in range(2 * arc, len(drops) - settle):
        if not between[0] < legs.level[row] < between[1]:
            continue
        above, below = slice(row - 2 * arc, row - arc), slice(row + 1, row + 1 + settle)
        steps = _steps(legs, above, below)
        drop = float(steps.sum() + np.median(legs.inner_px[above]) - np.median(legs.inner_px[below])) / legs.figure_px
        if np.isnan(drop) or drop < LEAST_DROP:
            continue
        both_in = float(steps.min()) > LEAST_STEP * legs.figure_px
        low = _is_low(legs, above)
        sure = low if both_in else low and drop > SURE_BRIDGE
        if both_legs and (sure or (both_in and drop > HIGH_DROP)):
            bridging[row], holed[row] = _bridges(legs, above), _mostly_bridges(legs, above)
        if bridging[row] or holed[row] or both_in or not both_legs:
            drops[row] = drop
    bridging = bridging if bridging.any() else holed
    if bridging.any():
        drops[~bridging] = 0.0
    deepest = int(np.argmax(drops))
    if drops[deepest] == 0.0:
        return _floor_length(legs) if both_legs else None
    # legs go on tapering below a hem: it is where most of the width is lost first
    row = deepest - arc + int(np.argmax(drops[deepest - arc : deepest + 1] >= MOST * drops[deepest]))
    return Hem(float(legs.level[row]), min(float(drops[deepest]) / SURE_DROP, 1.0), bool(bridging[deepest]))


def _floor_length(legs: LegRows) -> Hem | None:
    """Return the hem of floor-length cloth: it fills the gap between the legs and stands off down to the ankles."""
    rows = np.flatnonzero((legs.level > CALVES[0]) & (legs.level < CALVES[1]))
    if rows.size == 0 or legs.joined[rows].mean() < FILLED:
        return None
    apart = float(np.median(legs.gap_px[rows])) > LEAST_GAP * legs.figure_px
    off = float(np.median(legs.off_px[rows], axis=0).min()) / legs.figure_px
    if not apart or off < STANDS_OFF:
        return None
    return Hem(float(legs.level[-1]), min(2.0 * off / SURE_DROP, 1.0), bridges=True)


def _steps(legs: LegRows, above: slice, below: slice) -> Array:
    """Return how far both edges step in, (2,) px; an edge that arms cover takes the other's value, NaN if both are."""
    steps = np.full(2, np.nan)
    for side in (0, 1):
        high, low = (legs.off_px[rows, side][legs.seen[rows, side]] for rows in (above, below))
        if high.size >= LEAST_SEEN * (above.stop - above.start) and low.size > 0:
            steps[side] = np.median(high) - np.median(low)
    return np.where(np.isnan(steps), steps[::-1], steps)


def _bridges(legs: LegRows, rows: slice) -> bool:
    """Return whether the outline fills all of the gap between the legs."""
    return bool(legs.joined[rows].mean() >= FILLED)


def _mostly_bridges(legs: LegRows, rows: slice) -> bool:
    """Return whether it fills most of the gap below the knees: a mask may have holes there."""
    return bool(np.median(legs.level[rows]) > KNEE and legs.filled[rows].mean() >= MOSTLY)


def _is_low(legs: LegRows, rows: slice) -> bool:
    """Return whether rows lie below where thighs touch, and the legs are apart there."""
    apart = np.median(legs.gap_px[rows]) > LEAST_GAP * legs.figure_px
    return bool(apart and np.median(legs.level[rows]) > LOW_BRIDGE)


def region_around_legs(mask: Bools, legs: LegRows, hem: Hem) -> LooseRegion:
    """Return the region from the waist to a hem.

    Parameters
    ----------
    mask : (H, W) bool, the filled outline
    legs : LegRows
    hem : Hem
        Of this photo.
    """
    arc, settle = (max(2, round(share * legs.figure_px)) for share in (ARC_SHARE, SETTLE_SHARE))
    row = int(np.searchsorted(legs.level, hem.level))
    ends = np.array([_edge_end(legs, column, row, arc, settle) for column in (0, 1)], dtype=np.float64)
    line = np.arange(len(legs.level))
    edges, seen = legs.edges_px.copy(), legs.seen & (line[:, None] <= ends)
    for column, sign in ((0, -1.0), (1, 1.0)):
        out, known = sign * edges[:, column], np.flatnonzero(seen[:, column])
        if known.size:
            # below the last row that is surely cloth's, arm and cloth cannot be told: the outline itself is kept
            kept = np.concatenate([known, line[(line > known[-1]) & (line <= ends[column])]])
            # nor does cloth reach beyond the outline
            limit = np.where(line > ends[column], np.inf, out)
            edges[:, column] = sign * np.minimum(np.interp(line, kept, out[kept]), limit)
        edges[:, column] = gaussian_filter1d(edges[:, column], 0.5 * settle, mode="nearest")
    ends_px = hem_rows(mask[legs.top_px :], edges, ends, legs.figure_px)
    last = min(int(max(ends_px.max(), row)) + settle, len(line) - 1)
    return LooseRegion(
        AROUND_LEGS, legs.top_px, edges[: last + 1], legs.top_px + ends_px, seen[: last + 1], hem.confidence
    )


def _edge_end(legs: LegRows, column: int, row: int, arc: int, settle: int) -> float:
    """Return the row in which one edge of the cloth ends, where it steps in to the leg."""
    out = median_filter(legs.off_px[:, column], 3)
    first, last = max(row - 2 * arc, 0), min(row + arc, len(out) - 1 - settle)
    rows = np.arange(first, last)
    if rows.size < 2:
        return float(row)
    step = out[rows] - out[rows + settle]
    corner = int(rows[np.argmax(step)])
    if step.max() < LEAST_STEP * legs.figure_px:
        return float(row - arc // 2)
    near = np.arange(max(corner - settle, 0), corner + settle)
    # the flat ellipse of a hem is a little past its end when it has lost this much
    return float(near[out[near] > out[near].max() - END_SHARE * legs.figure_px][-1])


def hem_rows(mask: Bools, edges_px: Array, ends_px: Array, figure_px: float) -> Array:
    """Return the rows (K,) in which cloth ends at `HEM_PLACES`, a smooth curve between and beside the legs.

    In a column without a leg the cloth ends where the mask does. Where a leg comes out the mask goes on, so that its
    end falls off steeply at the leg's sides: such columns tell nothing, and the curve keeps to the highest ends.

    Parameters
    ----------
    mask : (H, W) bool
        Rows as in ``edges_px``.
    edges_px : (R, 2)
        First and last column of the cloth in every row.
    ends_px : (2,)
        Rows in which the two edges end.
    figure_px : float
        Height of the figure.
    """
    arc = ARC_SHARE * figure_px
    low, high = edges_px[int(ends_px.min())]
    columns = np.arange(max(int(low), 0), min(int(high), mask.shape[1] - 1) + 1)
    first = max(int(ends_px.min() - HIGHEST_ARCH * arc), 0)
    strip = mask[first : int(ends_px.max() + 2.0 * arc), columns]
    level = np.interp(HEM_PLACES, [-1.0, 1.0], ends_px)
    if columns.size < 8 or not strip.size:
        return level
    length = np.argmin(strip, axis=0).astype(np.float64)  # rows filled from the strip's top; 0 where all are
    steep = np.abs(np.gradient(median_filter(length, 3))) > STEEPEST
    legless = (length > 0.0) & ~steep
    across = 2.0 * (columns - low) / max(high - low, 1.0) - 1.0
    row = np.concatenate([first + length[legless] - 1.0, ends_px])
    place = np.concatenate([across[legless], [-1.0, 1.0]])
    own = np.concatenate([np.ones(int(legless.sum())), np.full(2, END_TRUST * columns.size)])
    if legless.mean() < LEAST_LEGLESS:
        return level
    basis = _hem_basis(place)
    stiff = np.diag([0.0, 0.0, *([BENT * columns.size / arc**2] * 3)])
    curve = np.zeros(basis.shape[1])
    curve[:2] = np.mean(ends_px), 0.5 * (ends_px[1] - ends_px[0])
    for _ in range(12):  # ends below the curve are legs'
        below = row - basis @ curve
        weight = own / (1.0 + (np.where(below > 0.0, 2.0, 0.5) * below / (LOOSE_SHARE * figure_px)) ** 2)
        curve = np.linalg.solve((basis.T * weight) @ basis + stiff, basis.T @ (weight * row))
    return np.asarray(_hem_basis(HEM_PLACES) @ curve)


def _hem_basis(across: Array) -> Array:
    """Return what a hem's curve is made of at (N,) places, (N, 5): level, slant and three arches."""
    bulge = np.sqrt(np.clip(1.0 - across**2, 0.0, None))  # a level hem from above is half an ellipse
    return np.stack([np.ones_like(across), across, bulge, bulge**2, across * bulge**2], axis=1)


def find_loose(photos: Mapping[ViewId, tuple[Bools, Array, Array]]) -> dict[ViewId, tuple[LooseRegion, ...]]:
    """Return the loose clothing of every body photo with some.

    Cloth around the legs must bridge them from the front or from behind, and the
    other of the two must at least show its hem; the side photo then shows how far
    it reaches.

    Parameters
    ----------
    photos : view -> filled outline (H, W), pose (33, 2) and its visibility (33,)
    """
    rows = {view: leg_rows(*photo) for view, photo in photos.items() if view.is_body}
    flat = {view: legs for view, legs in rows.items() if legs is not None and view is not ViewId.BODY_SIDE}
    hems = {view: hem for view, legs in flat.items() if (hem := find_hem(legs, both_legs=True)) is not None}
    if not hems or len(hems) < len(flat) or not any(hem.bridges for hem in hems.values()):
        return {}
    levels = [hem.level for hem in hems.values()]
    if max(levels) - min(levels) > SAME_HEM:
        return {}
    found: dict[ViewId, tuple[LooseRegion, ...]] = {}
    for view, hem in hems.items():
        found[view] = (region_around_legs(photos[view][0], flat[view], hem),)
    side = rows.get(ViewId.BODY_SIDE)
    if side is None:
        return found
    level, sure = float(np.mean(levels)), min(hem.confidence for hem in hems.values())
    near = find_hem(side, both_legs=False, between=(level - SAME_HEM, level + SAME_HEM))
    hem = Hem(level if near is None else near.level, sure, bridges=False)
    found[ViewId.BODY_SIDE] = (region_around_legs(photos[ViewId.BODY_SIDE][0], side, hem),)
    return found
