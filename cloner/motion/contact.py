"""Feet that stay where they stand: which foot stands when, and legs bent so that it does not slide."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.motion import turns
from cloner.motion.body import SIDES, Body
from cloner.records.motions import Motion

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

#: A sole stands while its lowest point is this near to the floor and this slow against it; taste, human gait.
NEAR_M: Final = 0.02
SLOW_M_S: Final = 0.45
#: The correction of a foot comes and goes over this long, seconds; taste.
EASE_S: Final = 0.12
#: A leg is never straightened farther than this share of its length: knees must not snap.
REACH: Final = 0.998


def standing(body: Body, motion: Motion) -> tuple[Mask, Mask]:
    """Return (F,) for the left and the right foot: does its sole stand on the floor at y = 0?"""
    left, right = (_stands(motion, height, slip) for height, slip in _rolling(body, motion))
    return left, right


def _rolling(body: Body, motion: Motion) -> list[tuple[Array, Array]]:
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


def grounded(body: Body, motion: Motion) -> Motion:
    """Return the motion with the root at such a height that the lower sole touches the floor in every frame."""
    left, right = body.sole_points(body.world(motion), motion.root_m)
    low = np.minimum(left[..., 1].min(axis=1), right[..., 1].min(axis=1))
    return replace(motion, root_m=motion.root_m - np.outer(low, (0.0, 1.0, 0.0)))


def planted(body: Body, motion: Motion) -> Motion:
    """Return the motion with every standing foot kept on its spot of the ground by bending hip and knee.

    The ground runs backwards by ``motion.speed_m_s``. While a foot stands, the slips of its lowest part are undone; the
    correction fades in and out around that time, round the end of a cyclic motion too.
    """
    world = body.world(motion)
    for side, (height, slip) in zip(SIDES, _rolling(body, motion), strict=True):
        stands = _stands(motion, height, slip)
        where = turns.places(world, body.joints_m, body.parents, motion.root_m)
        ankle = where[:, body.joint(f"{side}_ankle")]
        world = _legs_reaching(body, world, where, side, ankle + _corrections(motion, stands, slip))
    return replace(motion, rotations=turns.local_from_world(world, body.parents))


def _corrections(motion: Motion, stands: Mask, slip: Array) -> Array:
    """Return (F, 3) by how much a foot has to move so that its slips while it stands add up to nothing, metres."""
    step = float(np.diff(motion.times_s).mean())
    ease = max(round(EASE_S / step), 1)
    count = len(stands) - 1 if motion.cyclic else len(stands)
    total, weight = np.zeros((len(stands), 3)), np.zeros(len(stands))
    for first, last in cyclic_runs(stands[:-1]) if motion.cyclic else runs(stands):
        inner = np.arange(first + 1, last + 1) % count
        undone = -np.concatenate([np.zeros((1, 2)), np.cumsum(slip[inner], axis=0)])
        undone -= undone.mean(axis=0)  # the stand moves as little as may be
        frames = np.arange(first - ease, last + ease + 1)
        near = np.clip(1.0 - np.maximum(first - frames, frames - last) / (ease + 1), 0.0, 1.0)
        away = undone[np.clip(frames, first, last) - first]
        rows = frames % count if motion.cyclic else frames
        inside = (rows >= 0) & (rows < count)
        np.add.at(total, rows[inside], near[inside, None] * away[inside][:, [0, 0, 1]] * (1.0, 0.0, 1.0))
        np.add.at(weight, rows[inside], near[inside])
    result = total / np.maximum(weight, 1.0)[:, None]
    if motion.cyclic:
        result[-1] = result[0]
    return np.asarray(result)


def cyclic_runs(flags: Mask) -> list[tuple[int, int]]:
    """Return first and last row of every run of True in a circle; a run over the end goes on counting."""
    if flags.all() or not flags.any():
        return runs(flags)
    start = int(np.flatnonzero(~flags)[0])
    return [(first + start, last + start) for first, last in runs(np.roll(flags, -start))]


def runs(flags: Mask) -> list[tuple[int, int]]:
    """Return first and last row of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(np.int8), [0]])))
    return [(int(first), int(last) - 1) for first, last in edges.reshape(-1, 2)]


def _legs_reaching(body: Body, world: Array, where: Array, side: str, goal: Array) -> Array:
    """Return the orientations with one leg bent so that its ankle lies at ``goal`` (F, 3); the foot keeps its own."""
    hip, knee, ankle = (body.joint(f"{side}_{name}") for name in ("hip", "knee", "ankle"))
    upper, lower = where[:, knee] - where[:, hip], where[:, ankle] - where[:, knee]
    first, second = np.linalg.norm(upper, axis=1), np.linalg.norm(lower, axis=1)
    straight = goal - where[:, hip]
    far = np.linalg.norm(straight, axis=1)
    reach = np.clip(far, np.abs(first - second) + 1e-6, REACH * (first + second))
    reach = np.where(far > REACH * (first + second), np.minimum(far, 0.99999 * (first + second)), reach)
    along = straight / far[:, None]
    bend = upper - np.einsum("fa,fa->f", upper, along)[:, None] * along
    bend /= np.maximum(np.linalg.norm(bend, axis=1, keepdims=True), 1e-9)
    cosine = np.clip((first**2 + reach**2 - second**2) / (2.0 * first * reach), -1.0, 1.0)
    new_upper = first[:, None] * (cosine[:, None] * along + np.sqrt(1.0 - cosine**2)[:, None] * bend)
    new_lower = reach[:, None] * along - new_upper
    turned = world.copy()
    turned[:, hip] = turns.between(upper, new_upper) @ world[:, hip]
    turned[:, knee] = turns.between(lower, new_lower) @ world[:, knee]
    return turned


def sliding_m(body: Body, motion: Motion) -> tuple[float, float]:
    """Return by how far standing soles slip over the ground: mean and worst of all stands, metres."""
    slid = []
    for height, slip in _rolling(body, motion):
        for first, last in runs(_stands(motion, height, slip)):
            path = np.cumsum(slip[first + 1 : last + 1], axis=0)
            slid.append(float(np.linalg.norm(np.ptp(path, axis=0))) if len(path) else 0.0)
    return (float(np.mean(slid)), float(np.max(slid))) if slid else (0.0, 0.0)
