"""Foot planting: soles roll over the ground without slipping.

While a foot stands, the point of its sole that touches the floor keeps its place from frame to frame, whichever point
that is: the heel at first, then ball and toes. Between two stands the foot goes its own way, carried from the one place
to the other, and high enough that nothing scuffs. Hips, knees and, where a leg is too short, the pelvis give way.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

import numpy as np
from scipy.ndimage import gaussian_filter1d, maximum_filter1d

from cloner.geometry.meshes.vectors import unit
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import SIDES, Body
from cloner.motion.moves.contact import Mask, cyclic_runs, foot_contacts, runs
from cloner.records.arrays import Array
from cloner.records.motions import Motion

#: A foot that leaves the ground or comes to it does so at this speed upright, metres a second, up to this height, m:
#: a sixtieth of a second after it left it is higher than the 4 mm below which it would touch. Walkers clear 10 to 20;
#: every millimetre more bends the knees of a leg that was captured straight, by 13 degrees for the first nine.
RISES_M_S: Final = 0.54
CLEARS_M: Final = 0.009
#: What a stand's last correction adds to the way of the swing after it, metres: not more than a foot would swerve.
SWERVE_M: Final = 0.03
#: A leg is never straightened farther than this share of its length: knees must not snap.
REACH: Final = 0.9995
#: The pelvis comes down over this time before a leg would be too short, seconds; taste.
LOWERS_S: Final = 0.08
#: The knee stands before the line from hip to ankle by this share of the thigh at least: that tells which way it bends.
AHEAD: Final = 0.02


def planted(body: Body, motion: Motion, stands: tuple[Mask, Mask] | None = None, straight: int = 1) -> Motion:
    """Return the motion with standing feet kept on their spot of the ground, and all others clear of it.

    Parameters
    ----------
    body : Body
    motion : Motion
        The ground, at y = 0, runs backwards by its ``speed_m_s``.
    stands : (F,) bool of the left and of the right foot
        When they stand; None finds it out.
    straight : int
        For so many frames a foot goes straight up from where it stood and straight down to where it will.
    """
    stands = foot_contacts(body, motion) if stands is None else stands
    world = body.world(motion)
    where = turns.joint_positions(world, body.joints_m, body.parents, motion.root_m)
    goals = []
    for side, own, sole in zip(SIDES, stands, body.sole_points(world, motion.root_m), strict=True):
        goals.append(where[:, body.joint(f"{side}_ankle")] + _corrections(motion, own, sole, straight))
    root = motion.root_m - np.outer(_lowered(body, motion, where, goals), (0.0, 1.0, 0.0))
    where = turns.joint_positions(world, body.joints_m, body.parents, root)
    for side, goal in zip(SIDES, goals, strict=True):
        world = _legs_reaching(body, world, where, side, goal)
    return replace(motion, root_m=root, rotations=turns.local_from_world(world, body.parents))


def _corrections(motion: Motion, stands: Mask, sole: Array, straight: int) -> Array:
    """Return (F, 3) by how much a foot with its sole's points at (F, N, 3) has to move, metres."""
    count = len(stands) - 1 if motion.cyclic else len(stands)
    low = sole[..., 1].min(axis=1)
    slips = _slips(motion, sole)
    found = cyclic_runs(stands[:count]) if motion.cyclic else runs(stands)
    if not found:
        return np.outer(_lift(motion, stands, low), (0.0, 1.0, 0.0))
    ends: list[tuple[int, int, Array]] = []
    for first, last in found:
        # On either side the foot goes straight up and down.
        frames = np.arange(first - straight, last + straight + 1)
        frames = frames if motion.cyclic else frames[(frames >= 0) & (frames < count)]
        undone = np.zeros((len(frames), 3))
        undone[1:, [0, 2]] = -np.cumsum(slips[frames[:-1] % count], axis=0)
        undone -= undone.mean(axis=0)  # the stand moves as little as may be
        undone[:, 1] = -low[np.clip(frames, first, last) % count]
        ends.append((int(frames[0]), int(frames[-1]), undone))
    result = _joined(motion, ends, count)
    if motion.cyclic:
        result = np.concatenate([result, result[:1]])
    result[:, 1] += _lift(motion, stands, low + result[:, 1])
    return result


def _slips(motion: Motion, sole: Array) -> Array:
    """Return the sliding (F - 1, 2) of a foot's contact point over the ground between frames."""
    above = sole[..., 1] - sole[..., 1].min(axis=1, keepdims=True)
    ground = sole[..., [0, 2]] + np.outer(motion.times_s, (0.0, motion.speed_m_s))[:, None]
    touching = np.argmin(above[1:] + above[:-1], axis=1)
    return np.asarray(np.diff(ground, axis=0)[np.arange(len(touching)), touching])


def _joined(motion: Motion, ends: list[tuple[int, int, Array]], count: int) -> Array:
    """Return (count, 3) corrections: those of the stands, and between them smooth ways from one to the next."""
    result = np.zeros((count, 3))
    pairs = list(pairwise(ends))
    if motion.cyclic:
        first, last, undone = ends[0]
        pairs.append((ends[-1], (first + count, last + count, undone)))
    else:
        result[: ends[0][0]], result[ends[-1][1] :] = ends[0][2][0], ends[-1][2][-1]
    for first, last, undone in ends:
        result[np.arange(first, last + 1) % count] = undone
    for (_, start, before), (end, _, after) in pairs:
        length = end - start
        if length < 2:
            continue
        share = np.arange(1, length)[:, None] / length
        begins, arrives = (undone[1] - undone[0] if len(undone) > 1 else np.zeros(3) for undone in (before[-2:], after))
        slopes = [
            slope * min(length, SWERVE_M / max(float(np.linalg.norm(slope)), 1e-9)) for slope in (begins, arrives)
        ]
        way = _hermite(share, before[-1], after[0], *slopes)
        result[np.arange(start + 1, end) % count] = way
    return result


def _hermite(share: Array, first: Array, last: Array, begins: Array, arrives: Array) -> Array:
    """Return the cubic from ``first`` to ``last`` with the slopes at both ends, at shares (F, 1) of the way."""
    square, cube = share**2, share**3
    return np.asarray(
        (2.0 * cube - 3.0 * square + 1.0) * first
        + (cube - 2.0 * square + share) * begins
        + (3.0 * square - 2.0 * cube) * last
        + (cube - square) * arrives
    )


def _lift(motion: Motion, stands: Mask, low: Array) -> Array:
    """Return (F,) by how much a foot whose lowest point is at ``low`` is to be lifted unless it stands, metres."""
    step = float(np.diff(motion.times_s).mean())
    far = np.full(len(stands), len(stands))
    if stands.any():
        places = np.flatnonzero(stands)
        if motion.cyclic:
            count = len(stands) - 1
            places = np.concatenate([places - count, places, places + count])
        far = np.abs(np.arange(len(stands))[:, None] - places).min(axis=1)
    needed = np.minimum(far * step * RISES_M_S, CLEARS_M)
    return np.maximum(needed - low, 0.0)


def _lowered(body: Body, motion: Motion, where: Array, goals: list[Array]) -> Array:
    """Return (F,) by how much the pelvis has to come down for both ankles to reach their goals, metres."""
    needed = np.zeros(len(where))
    for side, goal in zip(SIDES, goals, strict=True):
        hip, knee, ankle = (where[:, body.joint(f"{side}_{name}")] for name in ("hip", "knee", "ankle"))
        longest = REACH * (np.linalg.norm(knee - hip, axis=1) + np.linalg.norm(ankle - knee, axis=1))
        across = np.hypot(*(goal - hip)[:, [0, 2]].T)
        upright = np.sqrt(np.maximum(longest**2 - across**2, 0.0))
        needed = np.maximum(needed, hip[:, 1] - goal[:, 1] - upright)
    width = max(round(LOWERS_S / float(np.diff(motion.times_s).mean())), 1)
    mode = "wrap" if motion.cyclic else "nearest"
    own = needed[:-1] if motion.cyclic else needed
    smooth = gaussian_filter1d(maximum_filter1d(own, 2 * width + 1, mode=mode), width / 2.0, mode=mode)
    return np.concatenate([smooth, smooth[:1]]) if motion.cyclic else np.asarray(smooth)


def _legs_reaching(body: Body, world: Array, where: Array, side: str, goal: Array) -> Array:
    """Return the orientations with one leg bent so that its ankle lies at ``goal`` (F, 3); the foot keeps its own."""
    hip, knee, ankle = (body.joint(f"{side}_{name}") for name in ("hip", "knee", "ankle"))
    upper, lower = where[:, knee] - where[:, hip], where[:, ankle] - where[:, knee]
    first, second = np.linalg.norm(upper, axis=1), np.linalg.norm(lower, axis=1)
    straight = goal - where[:, hip]
    far = np.linalg.norm(straight, axis=1)
    reach = np.clip(far, np.abs(first - second) + 1e-6, 0.99999 * (first + second))
    along = straight / far[:, None]
    front, bend = (
        vectors - np.einsum("fa,fa->f", vectors, along)[:, None] * along for vectors in (world[:, hip, :, 2], upper)
    )
    front = unit(front)
    behind = AHEAD * first - np.einsum("fa,fa->f", bend, front)
    bend += np.maximum(behind, 0.0)[:, None] * front
    bend = unit(bend)
    cosine = np.clip((first**2 + reach**2 - second**2) / (2.0 * first * reach), -1.0, 1.0)
    new_upper = first[:, None] * (cosine[:, None] * along + np.sqrt(1.0 - cosine**2)[:, None] * bend)
    new_lower = reach[:, None] * along - new_upper
    turned = world.copy()
    turned[:, hip] = turns.rotations_between(upper, new_upper) @ world[:, hip]
    turned[:, knee] = turns.rotations_between(lower, new_lower) @ world[:, knee]
    return turned
