"""Limits on mixed face targets: lids and lips never cross, nothing overshoots.

Targets are added; each alone is a sound face, their sum need not be. Everything here is measured on the clone itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.generic.face_grids import Grid, eye_grid, lip_gaps_m, mouth_grid
from cloner.generic.load import load_generic
from cloner.generic.morphs import target_offsets
from cloner.records.arrays import Array
from cloner.records.clones import Clone

#: Points that no sum takes farther than the target that takes them farthest.
POINTS: Final = ("chin_front", "mouth_corner_L", "mouth_corner_R", "lip_top", "lip_bottom", "nose_tip")
#: A target moves a point when it does so by more than this, metres.
MOVES_M: Final = 0.001
#: Lips may press on each other by this much, metres, before what closes them is held back.
PRESS_M: Final = 0.0005
TURNS: Final = 4
#: A tongue that is out presses into the lips' middles by no more than this, metres, and is drawn in by such steps.
TONGUE, TONGUE_PRESS_M, TONGUE_WIDE_M, TONGUE_STEP, TONGUE_TURNS = "tongueOut", 0.001, 0.006, 0.75, 8


@dataclass(frozen=True, slots=True, eq=False)
class _Reach:
    """What every target (T) does alone.

    Points (T, P, 3) m, lids shut (T, 2) as a share, lips (T, K, N, 3) m, tongue (T, Q, 3) m.
    """

    points: Array
    shut: Array
    lips: Array
    tongue: Array


def limited(clone: Clone, weights: Mapping[str, Array]) -> dict[str, Array]:
    """Return weights (F,) of the clone's targets, held back wherever their sum would be no face.

    A blink takes the place of gaze, squint and what opens lids, and what others leave of the way to shut lids. No sum
    takes a feature point farther than any one target does. A tongue comes out as far as the lips leave it room.
    What closes the lips is held back where they would cross. Weights that do no such thing come back as they are; names
    that the clone has not are dropped.
    """
    names = tuple(name for name in clone.morph_names if name in weights)
    if not names:
        return {}
    reach, farthest = _reach(clone, names)
    rows = np.clip(np.column_stack([np.asarray(weights[name], dtype=np.float64) for name in names]), 0.0, 1.0)
    rows = _held_points(rows, reach.points, farthest)
    rows = _held_lids(rows, reach.shut, names)
    rows = _held_tongue(rows, clone.vertices_m, reach, names)
    rows = _held_lips(rows, clone.vertices_m[mouth_grid().rings], reach.lips)
    return {name: rows[:, column] for column, name in enumerate(names)}


def _reach(clone: Clone, names: tuple[str, ...]) -> tuple[_Reach, Array]:
    """Return the named targets' displacements, and their largest displacement of the points (P,), metres."""
    generic = load_generic()
    vertices = [generic.feature(name) for name in POINTS]
    eyes, mouth = (eye_grid("left"), eye_grid("right")), mouth_grid()
    rest = clone.vertices_m
    opened = [_lid_height(grid, rest) for grid in eyes]
    points, shut, lips, tongue, farthest = [], [], [], [], np.zeros(len(vertices))
    for name, offsets in target_offsets(clone):
        own = offsets[vertices].astype(np.float64)
        farthest = np.maximum(farthest, np.linalg.norm(own, axis=1))
        if name not in names:
            continue
        shape = rest + offsets[:-1]
        points.append(own)
        shut.append([1.0 - _lid_height(g, shape) / max(o, 1e-6) for g, o in zip(eyes, opened, strict=True)])
        lips.append(offsets[mouth.rings].astype(np.float64))
        tongue.append(offsets[generic.part("tongue")].astype(np.float64))
    return _Reach(np.array(points), np.array(shut), np.array(lips), np.array(tongue)), farthest


def _lid_height(grid: Grid, shape_m: Array) -> float:
    """Return the vertical distance of the lids, metres, averaged over the opening."""
    margin = shape_m[grid.ring(0)]
    return float(margin[grid.upper, 1].mean() - margin[grid.lower, 1].mean())


def _held_points(rows: Array, points: Array, farthest: Array) -> Array:
    """Return weights (F, T) under which no point goes farther than any one target takes it."""
    moved = np.linalg.norm(np.einsum("ft,tpc->fpc", rows, points), axis=2)
    allowed = np.minimum(1.0, farthest / np.maximum(moved, 1e-9))
    moves = np.linalg.norm(points, axis=2) > MOVES_M
    factor = np.where(moves[None], allowed[:, None, :], 1.0).min(axis=2)
    return np.asarray(rows * factor)


def _held_lids(rows: Array, shut: Array, names: tuple[str, ...]) -> Array:
    """Return weights (F, T) under which lids shut at most.

    What else the eye does gives way to a blink as that comes: shut lids hide the gaze, and only a blink meets the lower
    lid all along. Cheeks and smiles stay, the blink takes what they leave.
    """
    out = rows.copy()
    for column, side in enumerate(("Left", "Right")):
        blink = f"eyeBlink{side}"
        own = shut[:, column]
        is_blink = np.array([name == blink for name in names])
        is_gaze = np.array([name.startswith("eyeLook") for name in names])
        wink = rows[:, is_blink].sum(axis=1)
        is_eyes = np.array([name.startswith(("eyeLook", "eyeSquint")) and name.endswith(side) for name in names])
        out[:, ((own < -0.01) | is_eyes) & ~is_blink] *= (1.0 - wink)[:, None]
        closes = (own > 0.01) & ~is_blink & ~is_gaze
        gazed = out[:, is_gaze] @ np.maximum(own[is_gaze], 0.0)
        closing = out[:, closes] @ own[closes]
        out[:, closes] *= np.minimum(1.0, np.maximum(1.0 - gazed, 0.0) / np.maximum(closing, 1e-9))[:, None]
        left = 1.0 - gazed - out[:, closes] @ own[closes]
        out[:, is_blink] = rows[:, is_blink] * np.clip(left, 0.0, 1.0)[:, None]
    return out


def _held_tongue(rows: Array, rest: Array, reach: _Reach, names: tuple[str, ...]) -> Array:
    """Return weights (F, T) under which the tongue comes out as far as the lips let it, which it opens itself."""
    if TONGUE not in names or not rows[:, names.index(TONGUE)].any():
        return rows
    grid, out, column = mouth_grid(), rows.copy(), names.index(TONGUE)
    lips_m, tongue_m = rest[grid.rings], rest[load_generic().part("tongue")]
    beside = np.abs(lips_m[grid.margin, :, 0] - tongue_m[:, 0].mean()) < TONGUE_WIDE_M
    alone = tongue_m + reach.tongue[column]
    touching = slice(grid.margin - 1, grid.margin + 3)
    lip = lips_m[touching][:, beside & grid.lower] + reach.lips[column][touching][:, beside & grid.lower]
    over = (alone[:, 2] > lip[..., 2].min()) & (np.abs(alone[:, 0] - tongue_m[:, 0].mean()) < TONGUE_WIDE_M)
    for weights in out:
        for _ in range(TONGUE_TURNS):
            lips = lips_m + np.tensordot(weights, reach.lips, axes=1)
            tongue = (tongue_m + np.tensordot(weights, reach.tongue, axes=1))[over, 1]
            low = tongue.min() - lips[touching][:, beside & grid.lower, 1].max()
            high = lips[touching][:, beside & grid.upper, 1].min() - tongue.max()
            if min(low, high) > -TONGUE_PRESS_M:
                break
            weights[column] *= TONGUE_STEP
        else:
            weights[column] = 0.0
    return out


def _held_lips(rows: Array, rest: Array, lips: Array) -> Array:
    """Return weights (F, T) under which lips cross nowhere: what closes them most there is held back."""
    grid, out = mouth_grid(), rows.copy()
    for frame, weights in enumerate(out):
        for _ in range(TURNS):
            shape = rest + np.tensordot(weights, lips, axes=1)
            apart = lip_gaps_m(grid, shape)
            worst = int(apart.argmin())
            if apart[worst] > -PRESS_M:
                break
            # where they cross most: how far every target alone moves the two lips' lines there to each other
            own = np.array([lip_gaps_m(grid, shape - w * step)[worst] - apart[worst] if w > 0.0 else 0.0
                            for w, step in zip(weights, lips, strict=True)])  # fmt: skip
            closes = own > 1e-6
            excess = (-PRESS_M / 2.0 - apart[worst]) / max(float(own[closes].sum()), 1e-9)
            weights = np.where(closes, weights * max(0.0, 1.0 - excess), weights)
        out[frame] = weights
    return out
