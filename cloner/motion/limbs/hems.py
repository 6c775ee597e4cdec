"""Loose cloth around the legs as swinging joint chains: skirts, and the lower part of coats and dresses."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.generic.load import load_generic
from cloner.motion.limbs.tails import SHORTEST_M, Tail, chain_weights, search_shells
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.heads import Shell

#: Chains around a hem; the first turns so far from straight ahead that each hangs beside one leg; taste.
CHAINS: Final = 8
_FIRST_RAD: Final = np.pi / CHAINS
#: Length of one bone, metres, and the most of a chain: more look no softer (taste).
BONE_M: Final = 0.16
MOST_BONES: Final = 4
#: Cloth swings from this far below the hip joints on, share of the distance between them: above, it lies on the body.
BELOW_HIPS: Final = 0.25
#: Half its thickness for what it must not fall into, metres; taste.
RADIUS_M: Final = 0.012


def hems(clone: Clone) -> tuple[Tail, ...]:
    """Return the chains of a clone's loose cloth, each attached to the leg beside it; none where it ends too high."""
    return search_shells(clone, "cloth", _chains)


def _chains(clone: Clone, shell: Shell, number: int) -> list[Tail]:
    generic = load_generic()
    left, right = (clone.joints_m[generic.joint(f"{side}_hip")] for side in ("l", "r"))
    points, middle = shell.vertices_m, 0.5 * (left + right)
    top = float(middle[1] - BELOW_HIPS * np.linalg.norm(left - right))
    turn = np.arctan2(points[:, 0] - middle[0], points[:, 2] - middle[2])
    place = np.mod((turn - _FIRST_RAD) * CHAINS / (2.0 * np.pi), CHAINS)  # in chains around the hem
    away = np.abs(np.mod(place[:, None] - np.arange(CHAINS) + CHAINS / 2.0, CHAINS) - CHAINS / 2.0)
    beside = np.clip(1.0 - away, 0.0, 1.0)
    found = []
    for chain in range(CHAINS):
        near = away[:, chain] < 0.5
        if not near.any() or top - points[near, 1].min() < SHORTEST_M:
            return []  # cloth all around or none: a hem in tatters would tear
        bones = int(np.clip(round((top - points[near, 1].min()) / BONE_M), 2, MOST_BONES))
        course = _course(points[near], top, bones)
        share = beside[:, [chain]] * _along(points[:, 1], course[:, 1])
        side = "l" if course[-1, 0] > middle[0] else "r"
        found.append(Tail(number, course, np.full(bones + 1, RADIUS_M), share, f"{side}_hip"))
    return found


def _course(points_m: Array, top_m: float, bones: int) -> Array:
    """Return the ends (bones + 1, 3) of a chain down one strip of cloth, metres."""
    heights = np.linspace(top_m, float(points_m[:, 1].min()), bones + 1)
    reach = 0.25 * (heights[0] - heights[1])
    flat = [points_m[np.abs(points_m[:, 1] - height) < reach][:, [0, 2]].mean(axis=0) for height in heights]
    return np.insert(np.array(flat), 1, heights, axis=1)


def _along(heights_m: Array, ends_m: Array) -> Array:
    """Return the weights (N, B) of a chain's bones: zero at its start, then blended from one to the next."""
    return chain_weights(np.interp(-heights_m, -ends_m, np.arange(len(ends_m), dtype=np.float64)), len(ends_m) - 1)
