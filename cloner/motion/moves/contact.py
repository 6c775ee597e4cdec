"""Foot contacts: a sole near the floor, whose rolling part is slow against the ground."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.motion.limbs.body import Body
from cloner.records.arrays import Array
from cloner.records.motions import Motion

Mask = NDArray[np.bool_]

#: A sole stands while its lowest point is this near to the floor and this slow against it; taste, human gait.
NEAR_M: Final = 0.02
SLOW_M_S: Final = 0.45
#: A stand that breaks off for less than the first is one stand, and one shorter than the second is none, seconds:
#: nobody takes a foot off the floor and puts it back in a tenth of a second.
GAP_S: Final = 0.1
SHORTEST_S: Final = 0.06


def foot_contacts(body: Body, motion: Motion) -> tuple[Mask, Mask]:
    """Return for the left and the right foot (F,) whether its sole is in contact with the floor at y = 0."""
    left, right = (
        _debounced(_stands(motion, height, slip), height, motion) for height, slip in _lowest_part(body, motion)
    )
    return left, right


def _lowest_part(body: Body, motion: Motion) -> list[tuple[Array, Array]]:
    """Return for each foot (F,) the height of its lowest part and (F, 2) that part's slip since the last frame, m.

    The lowest of heel, ball and toes is what the foot rolls over; a rolling foot moves, its lowest part does not.
    """
    found = []
    for points, rolls in zip(body.sole_points(body.world(motion), motion.root_m), body.rolls, strict=True):
        parts = np.einsum("kn,fna->fka", rolls, points)
        height = parts[..., 1]
        ground = parts[..., [0, 2]] + np.outer(motion.times_s, (0.0, motion.speed_m_s))[:, None]
        lowest = np.argmin(height[1:] + height[:-1], axis=1)
        slip = np.take_along_axis(np.diff(ground, axis=0), lowest[:, None, None], axis=1)[:, 0]
        first = slip[-1:] if motion.cyclic else np.zeros((1, 2))
        found.append((height.min(axis=1), np.concatenate([first, slip])))
    return found


def _stands(motion: Motion, height: Array, slip: Array) -> Mask:
    step = float(np.diff(motion.times_s).mean())
    slow = np.linalg.norm(slip, axis=1) < SLOW_M_S * step
    return np.asarray((height < NEAR_M) & (slow | np.roll(slow, -1)))


def _debounced(flags: Mask, height: Array, motion: Motion) -> Mask:
    """Return the contacts without short gaps, if the foot stays near the floor, and without short contacts."""
    step = float(np.diff(motion.times_s).mean())
    count = len(flags) - 1 if motion.cyclic else len(flags)
    out = flags[:count].copy()
    for value, shortest in ((False, GAP_S), (True, SHORTEST_S)):
        for first, last in cyclic_runs(out == value) if motion.cyclic else runs(out == value):
            rows = np.arange(first, last + 1) % count
            inside = motion.cyclic or (first > 0 and last < count - 1)
            if (
                inside
                and len(rows) < count
                and (last - first + 1) * step < shortest
                and height[rows].max() < 2.0 * NEAR_M
            ):
                out[rows] = not value
    return np.concatenate([out, out[:1]]) if motion.cyclic else out


def on_ground(body: Body, motion: Motion) -> Motion:
    """Return the motion with the root at the height at which the lower sole touches the floor in every frame."""
    left, right = body.sole_points(body.world(motion), motion.root_m)
    low = np.minimum(left[..., 1].min(axis=1), right[..., 1].min(axis=1))
    return replace(motion, root_m=motion.root_m - np.outer(low, (0.0, 1.0, 0.0)))


def cyclic_runs(flags: Mask) -> list[tuple[int, int]]:
    """Return first and last row of every run of True in a cycle; a run over the end continues."""
    if flags.all() or not flags.any():
        return runs(flags)
    start = int(np.flatnonzero(~flags)[0])
    return [(first + start, last + start) for first, last in runs(np.roll(flags, -start))]


def runs(flags: Mask) -> list[tuple[int, int]]:
    """Return first and last row of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(np.int8), [0]])))
    return [(int(first), int(last) - 1) for first, last in edges.reshape(-1, 2)]
