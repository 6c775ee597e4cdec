"""Eyelids: margins on an eyeball of anatomical size, rotated about it for blinks and gaze.

Photos show where the lids' edges are, seen from the front; how deep they lie follows from the ball. All functions take
and give the grid's points (K, N, 3), metres, rings by columns as :class:`cloner.generic.face_grids.Grid` has them.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.easing import smoothstep
from cloner.generic.face_grids import Grid
from cloner.geometry.meshes.eyeballs import BALL_M, CORNEA, Eyeball, cornea
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.lids")

#: Millimetres of the rings from the margin on, as metres.
OVER_M = np.array(_CALIBRATED.numbers("over_mm", "mm")) / 1000.0
SHARE = np.array(_CALIBRATED.numbers("share", "share"))
#: Millimetres of the rings behind the margin, as metres.
UNDER_M = np.array(_CALIBRATED.triple("under_mm", "mm")) / 1000.0
DEPTH_SHARE = np.array(_CALIBRATED.numbers("depth_share", "share"))
MEETING = _CALIBRATED.number("meeting", "share")
FOLLOWS = _CALIBRATED.pair("follows", "share")
FARTHEST = _CALIBRATED.number("farthest", "share")
DRAPED_RAD = _CALIBRATED.number("draped_rad", "rad")
STEEPEST_RAD = _CALIBRATED.number("steepest_rad", "rad")
#: Rounds in which the margins of a shut eye become one line.
LINE_TURNS = 3
CLEAR_M = _CALIBRATED.number("clear_m", "m")
REACH = _CALIBRATED.pair("reach", "share")


def margin_contact(grid: Grid, points: Array, ball: Eyeball) -> Array:
    """Return the weight (N,) with which each column's margin touches the eyeball: 1 in the middle, 0 at the corners."""
    away = points[grid.margin] - ball.centre
    return np.asarray(1.0 - smoothstep(np.hypot(away[:, 0], away[:, 1]) / (BALL_M + OVER_M[0]), *REACH))


def eyeball_depth(grid: Grid, points: Array, centre_xy: Array) -> float:
    """Return the depth (z, metres) of the eyeball that fits the lid margins best, their frontal positions kept.

    Parameters
    ----------
    centre_xy : (2,)
        Where the ball's centre is from the front.
    """
    margin = points[grid.margin]
    across = np.hypot(*(margin[:, :2] - centre_xy).T)
    over = BALL_M + OVER_M[0]
    weight = 1.0 - smoothstep(across / over, 0.6, 0.9)
    weight[grid.corners] = 0.0
    depth = margin[:, 2] - np.sqrt(np.maximum(over**2 - across**2, 1e-8))
    return float((weight * depth).sum() / max(float(weight.sum()), 1e-9))


def lids_on_eyeball(grid: Grid, points: Array, ball: Eyeball) -> Array:
    """Return the lids at rest with their margins on the eyeball, frontal positions kept."""
    reach = margin_contact(grid, points, ball)
    away = points[grid.margin] - ball.centre
    across = np.hypot(away[:, 0], away[:, 1])
    over = BALL_M * (1.0 + cornea(np.arcsin(np.clip(across / BALL_M, 0.0, 1.0)))) + OVER_M[0]
    step = reach * (np.sqrt(np.maximum(over**2 - across**2, 0.0)) - away[:, 2])
    out = points.copy()
    outer = out[grid.margin :]  # a view
    outer[:, :, 2] += DEPTH_SHARE[: len(outer), None] * step
    outer[:] = _at_radius(outer, ball, BALL_M + OVER_M[: len(outer), None], np.inf)
    inner = out[: grid.margin]
    under = BALL_M - UNDER_M[:, None]
    # The ring behind the margin dives under the ball where the margin lies on it; at the corners it and the next one
    # bridge to the ball, which the last one reaches.
    share = np.stack([np.ones_like(reach), reach, reach])[..., None]
    nearest = np.array([0.0, 0.0, under[2, 0]])[:, None]
    inner += share * (_at_radius(inner, ball, nearest, under) - inner)
    return out


def _at_radius(points: Array, ball: Eyeball, least: Array, most: Array | float) -> Array:
    """Return points moved radially until their distance from the eyeball's centre lies between two."""
    spokes = points - ball.centre
    distance = np.linalg.norm(spokes, axis=-1)
    return np.asarray(ball.centre + spokes * (np.clip(distance, least, most) / np.maximum(distance, 1e-9))[..., None])


def _margin_values(grid: Grid, lid: NDArray[np.bool_], aside: Array, values: Array) -> Array:
    """Return the values (N,) of one lid's margin from corner to corner, interpolated at every column."""
    own = lid.copy()
    own[grid.corners] = True
    columns = np.flatnonzero(own)[np.argsort(aside[own])]
    return np.asarray(np.interp(aside, aside[columns], values[columns]))


def closing_angles(grid: Grid, points: Array, ball: Eyeball) -> Array:
    """Return the rotations (N,) of the margins until they meet, radians, positive upwards; corners stay."""
    aside, elevation, _ = ball.unrolled(points[grid.margin])
    upper, lower = (_margin_values(grid, lid, aside, elevation) for lid in (grid.upper, grid.lower))
    meeting = upper + MEETING * (lower - upper)
    meeting[grid.corners] = elevation[grid.corners]
    # the lower lid's columns lie on the line that the upper lid's draw when they have come down
    return np.asarray(np.where(grid.upper, meeting, _margin_values(grid, grid.upper, aside, meeting)) - elevation)


def closed_lids(grid: Grid, points: Array, ball: Eyeball) -> Array:
    """Return closed lids: both margins on one line, the skin around them smooth."""
    out = rotate_margins(grid, points, ball, closing_angles(grid, points, ball))
    aside, elevation, distance = ball.unrolled(out[grid.margin :])
    line = np.stack([elevation[0], distance[0]])
    for _ in range(LINE_TURNS):
        # columns of the two lids lie beside each other: each line bends to the other's until one covers the other
        lower = np.stack([_margin_values(grid, grid.upper, aside[0], values) for values in line])
        line = np.where(grid.lower, lower, line)
        upper = np.stack([_margin_values(grid, grid.lower, aside[0], values) for values in line])
        line = np.where(grid.upper, (line + upper) / 2.0, line)
    share = SHARE[: len(distance), None]
    elevation += share * (line[0] - elevation[0])
    distance += share * (line[1] - distance[0])
    out[grid.margin :] = ball.rolled(aside, elevation, distance)
    return np.asarray(out)


def rotate_margins(grid: Grid, points: Array, ball: Eyeball, turn: Array) -> Array:
    """Return the grid with its margins rotated about the eyeball, without touching it on the way.

    Parameters
    ----------
    points : (K, N, 3)
        At rest, as `lids_on_eyeball` gives them.
    turn : (N,)
        Radians, positive upwards.
    """
    aside, elevation, distance = ball.unrolled(points)
    outwards = np.arange(len(points)) - grid.margin
    share = np.where(outwards < 0, 1.0, SHARE[np.maximum(outwards, 0)])[:, None]
    over = OVER_M[np.maximum(outwards, 0)][:, None]
    on_cornea = BALL_M * (1.0 + CORNEA)
    # A straight way that must not cut the ball ends no nearer than its tangent through the start.
    clear = np.sqrt(np.maximum((on_cornea + CLEAR_M) ** 2 - aside**2, 1e-10))
    at_rest = np.sqrt(np.maximum(distance**2 - aside**2, 1e-10))
    beyond = np.abs(share * turn) - np.arccos(np.minimum(clear / at_rest, 1.0))
    needed = clear / np.cos(np.clip(beyond, 0.0, STEEPEST_RAD)) + over - OVER_M[0]
    # Skin that unrolls from the fold comes to lie on the ball: the more of the margin's motion it takes, the closer.
    draped = np.sqrt(np.maximum((on_cornea + over) ** 2 - aside**2, 1e-10))
    close = share * np.clip(np.abs(turn) / DRAPED_RAD, 0.0, 1.0) * margin_contact(grid, points, ball)
    close[outwards < 0] = 0.0
    away = close * np.maximum(needed, draped) + (1.0 - close) * at_rest
    out = ball.rolled(aside, elevation + share * turn, np.hypot(away, aside))
    return np.asarray(np.where((np.abs(share * turn) > 1e-9)[..., None], out, points))


def keep_on_eyeball(grid: Grid, points: Array, moved: Array, ball: Eyeball) -> Array:
    """Return displaced lids with their margins on the eyeball as at rest, none inside it and none crossed.

    Parameters
    ----------
    points, moved : (K, N, 3)
        At rest, as `lids_on_eyeball` gives them, and after the motion.
    """
    out = moved.copy()
    at_rest = ball.unrolled(points[grid.margin])[2]
    aside, elevation, distance = ball.unrolled(moved[grid.margin])
    reach = margin_contact(grid, points, ball)
    upper, lower = (_margin_values(grid, lid, aside, elevation) for lid in (grid.upper, grid.lower))
    crossed = np.minimum(upper - lower, 0.0) / 2.0
    step = np.where(grid.upper, -crossed, np.where(grid.lower, crossed, 0.0))
    wanted = ball.rolled(aside, elevation + step, distance + reach * (at_rest - distance))
    outer = out[grid.margin :]  # a view
    outer += SHARE[: len(outer), None, None] * (wanted - moved[grid.margin])
    outer[:] = _at_radius(outer, ball, BALL_M + OVER_M[: len(outer), None], np.inf)
    out[: grid.margin] += wanted - moved[grid.margin]
    return np.asarray(out)


def lids_following_gaze(grid: Grid, points: Array, ball: Eyeball, up_rad: float) -> Array:
    """Return the lids for a gaze turned up, radians: the upper lid follows most of the way, the lower one a little."""
    closing = closing_angles(grid, points, ball)
    profile = np.abs(closing) / np.maximum(np.where(grid.upper, np.abs(closing[grid.upper]).max(),
                                                    np.abs(closing[grid.lower]).max()), 1e-9)  # fmt: skip
    way = np.where(grid.upper, FOLLOWS[0], FOLLOWS[1]) * up_rad * profile
    return rotate_margins(grid, points, ball, np.where(grid.upper, np.maximum(way, FARTHEST * closing), way))
