"""A captured walk made cyclic: cut at two similar steps, with the gap blended."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from cloner.errors import ClonerError
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import Body
from cloner.motion.moves.contact import foot_contacts, runs
from cloner.motion.moves.planting import planted
from cloner.records.motions import Motion

#: People take two steps in this time, seconds.
SHORTEST_S: Final = 0.6
LONGEST_S: Final = 2.0
#: Slower than this nobody walks, metres a second: it is standing with shifting feet.
SLOWEST_M_S: Final = 0.4


def walk_cycle(body: Body, motion: Motion) -> Motion:
    """Return the two steps of a walk that close best, on the spot, first and last frame alike.

    Parameters
    ----------
    body : Body
    motion : Motion
        Walking roughly straight ahead.

    Raises
    ------
    ClonerError
        If no two steps with the same foot are in it.
    """
    first, last = _best_cut(body, motion)
    rows = slice(first, last + 1)
    times = motion.times_s[rows] - motion.times_s[first]
    share = times / times[-1]
    own = turns.matrices(motion.rotations[rows])
    gap = turns.vectors(np.swapaxes(own[-1], -1, -2) @ own[0])
    closed = own @ turns.matrices(share[:, None, None] * gap)
    root = motion.root_m[rows] - motion.root_m[first] * (1.0, 0.0, 1.0)
    travel = root[-1] - root[0]
    heading = turns.rotations_about(1, -np.arctan2(travel[0], travel[2]))
    root = (root - np.outer(share, travel)) @ heading.T
    closed[:, 0] = heading @ closed[:, 0]  # the root is joint 0: the walk goes to the front
    made = replace(
        motion,
        times_s=times,
        root_m=root,
        rotations=turns.vectors(closed),
        weights={name: values[rows] for name, values in motion.weights.items()},
        cyclic=True,
        speed_m_s=float(np.hypot(travel[0], travel[2]) / times[-1]),
    )
    # Which foot stands when is told by the whole capture: the short piece, closed, says it less clearly.
    left, right = (flags[rows] for flags in foot_contacts(body, motion))
    return planted(body, made, (left, right))


def _best_cut(body: Body, motion: Motion) -> tuple[int, int]:
    """Return the frames of two strikes of one foot whose poses, and the way they change, differ least."""
    step = float(np.diff(motion.times_s).mean())
    best, cut = np.inf, (0, 0)
    pace = np.gradient(motion.rotations, axis=0)
    for flags in foot_contacts(body, motion):
        strikes = [first for first, last in runs(flags) if first > 0 and last - first >= 2]
        for first in strikes:
            for last in strikes:
                way = np.hypot(*(motion.root_m[last] - motion.root_m[first])[[0, 2]])
                if SHORTEST_S <= (last - first) * step <= LONGEST_S and way >= SLOWEST_M_S * (last - first) * step:
                    away = np.linalg.norm(motion.rotations[first] - motion.rotations[last])
                    away += np.linalg.norm(pace[first] - pace[last])
                    if away < best:
                        best, cut = float(away), (first, last)
    if not np.isfinite(best):
        hint = "Give a capture with at least three steps straight ahead"
        raise ClonerError("no walk can be found in the capture", hint, motion.name)
    return cut
