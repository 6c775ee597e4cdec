"""Measurement of foot sliding: how far a sole moves over the ground during contact.

Unlike what plants the feet, this asks nothing about speed or about which foot ought to stand: a toe that scuffs before
it lifts counts as much as a heel that skids.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation, Slerp

from cloner.motion.limbs.body import Body
from cloner.records.arrays import Array
from cloner.records.motions import Motion

#: A sole's lowest point touches below this height, metres, and is looked at so often a second: the ruler's definition.
TOUCHES_M: Final = 0.004
RULER_HZ: Final = 60.0
#: Between two steps a foot is lifted by more than this, metres: half of what walkers clear the ground by.
LIFTED_M: Final = 0.02


def step_slides_m(body: Body, motion: Motion) -> Array:
    """Return the slide (S,) of each step of either foot over the ground, metres.

    A step lasts from one highest place of the foot to the next. From frame to frame the horizontal way of the sole's
    lowest point counts wherever it is below `TOUCHES_M` at either end, relative to the ground, which runs backwards at
    the motion's speed. Frames between the motion's own are those that viewers show: turns and places interpolated.
    """
    shown = resampled(motion, RULER_HZ)
    soles = body.sole_points(body.world(shown), shown.root_m)
    return np.concatenate([foot_slides_m(points, shown) for points in soles])


def resampled(motion: Motion, frames_per_s: float) -> Motion:
    """Return the motion at a viewer's frame rate; face targets are left out."""
    count = max(round(float(motion.times_s[-1]) * frames_per_s), 1)
    times = np.linspace(0.0, float(motion.times_s[-1]), count + 1)
    rotations, root = posed_at(motion, times)
    return Motion(motion.name, times, root, rotations, cyclic=motion.cyclic, speed_m_s=motion.speed_m_s)


def posed_at(motion: Motion, times_s: Array) -> tuple[Array, Array]:
    """Return (N, J, 3) rotation vectors and (N, 3) root offsets of a motion at some times, on shortest arcs."""
    rotations = np.zeros((len(times_s), *motion.rotations.shape[1:]))
    for joint in np.flatnonzero(np.abs(motion.rotations).max(axis=(0, 2)) > 0.0):
        own = np.array(motion.rotations[:, joint])
        rotations[:, joint] = Slerp(motion.times_s, Rotation.from_rotvec(own))(times_s).as_rotvec()
    root = np.column_stack([np.interp(times_s, motion.times_s, motion.root_m[:, axis]) for axis in range(3)])
    return rotations, root


def foot_slides_m(points: Array, motion: Motion) -> Array:
    """Return (S,) the slides of one foot's steps from its sole's (F, N, 3) places, metres."""
    ground = points[..., [0, 2]] + np.outer(motion.times_s, (0.0, motion.speed_m_s))[:, None]
    lowest, height = points[..., 1].argmin(axis=1), points[..., 1].min(axis=1)
    way = np.diff(ground, axis=0)
    rows = np.arange(len(way))
    touching = np.where(height[:-1] < TOUCHES_M, lowest[:-1], lowest[1:])
    counts = np.minimum(height[:-1], height[1:]) < TOUCHES_M
    slid = np.where(counts, np.linalg.norm(way[rows, touching], axis=1), 0.0)
    if motion.cyclic:  # begin at the highest place: no step is cut
        start = int(height[:-1].argmax())
        slid, height = np.roll(slid, -start), np.roll(height[:-1], -start)
    else:
        height = height[:-1]
    number = np.cumsum(_apexes(height))
    sums = np.bincount(number, weights=slid)
    touched = np.bincount(number, weights=height < TOUCHES_M) > 0
    return np.asarray(sums[touched])


def _apexes(height: Array) -> NDArray[np.bool_]:
    """Return (F,) the frames at which a lifted foot is highest between two touches."""
    found, lifted = np.zeros(len(height), dtype=np.bool_), height > LIFTED_M
    touches = np.flatnonzero(height < TOUCHES_M)
    for first, last in pairwise(touches):
        if lifted[first:last].any():
            found[first + int(height[first:last].argmax())] = True
    return found
