"""A scenario that goes on by the clock, told as footings: minds decide a little ahead of what is shown.

The world is `HEAD_S` seconds ahead of whoever watches: it is known where everybody goes when the feet have to set out,
and orders are seen after as long.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.acting.walkers import SEEN_S, Track, Walker
from cloner.behaviour.guests import guests
from cloner.behaviour.loop import run
from cloner.behaviour.trajectories import RATE_HZ, STEPS
from cloner.behaviour.world import World
from cloner.crowd.staged.footing import Acted
from cloner.crowd.staged.scene import IDLE, WALK
from cloner.errors import ClonerError

#: So far ahead of what is shown minds decide, seconds: what feet need to know, the longest footing (.8), and 1.2 for a
#: machine that does something else just then.
HEAD_S: Final = SEEN_S + 2.0
#: Frames of a track that are kept: feet are never farther behind the minds.
KEPT: Final = round(2.0 * HEAD_S * RATE_HZ)
#: Whoever goes farthest in this time is whose part a newcomer takes, seconds.
GOES_S: Final = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class Look:
    """What a walker's feet are: (K, 48, 6) touches and (K, 2) clips (`crowd.staged.footing.Acted`), and its size."""

    touches: NDArray[np.float32]
    clips: NDArray[np.float32]
    scale: float


@dataclass(slots=True, eq=False)
class Minds:
    """A running scenario and everybody's feet. Frames are (n, 2) places, (n,) headings, acts, walks, who is there."""

    world: World
    walkers: list[Walker]
    looks: list[Look]
    postures: NDArray[np.int64]
    gaits: NDArray[np.int64]
    frames: deque[tuple[NDArray[Any], ...]] = field(default_factory=lambda: deque(maxlen=KEPT))
    gone_s: dict[int, float] = field(default_factory=dict)

    def go_on(self, shown_s: float) -> dict[int, NDArray[np.float32]]:
        """Let time pass until minds are `HEAD_S` ahead of what is shown; return everybody's new footings.

        A footing that goes on where the last one was is told again, longer: it begins at the same time. Between two
        calls at most `HEAD_S` may pass.
        """
        if not self.frames:
            self._look()
        for now in run(self.world, max(shown_s + HEAD_S - self.world.time_s, 0.0)):
            if now.steps % STEPS == 0:
                self._look()
        times = (self._frame() - np.arange(len(self.frames))[::-1]) / RATE_HZ
        places, headings, acts, walks, there = (np.stack(one, axis=1) for one in zip(*self.frames, strict=True))
        found = {}
        for who, walker in enumerate(self.walkers):
            until = self.world.time_s - SEEN_S
            if there[who, -1] and who in self.gone_s:
                first = len(times) - int(np.argmin(np.append(there[who][::-1], False)))
                walker.enter(float(times[first]), places[who, first], float(headings[who, first]))
                del self.gone_s[who]
            if not there[who, -1]:
                until = self.gone_s.setdefault(who, float(times[there[who]][-1]) if there[who].any() else 0.0)
            walker.track = Track(times, places[who], headings[who], acts[who], walks[who])
            rows = walker.more(until)
            if len(rows):
                found[who] = rows
        return found

    def goes(self, taken: frozenset[int]) -> int:
        """Return who goes farthest just now, of those whose part is not taken.

        Raises
        ------
        ClonerError
            If nobody is left.
        """
        before = self.frames[-min(len(self.frames), round(GOES_S * RATE_HZ))]
        worth = np.linalg.norm(self.frames[-1][0] - before[0], axis=1)
        worth[~self.frames[-1][4]] = -1.0
        worth[list(taken)] = -1.0
        best = int(np.argmax(worth))
        if worth[best] < 0.0:
            raise ClonerError("nobody's part is free in the scene", "Take a scenario with more people", "scene")
        return best

    def dress(self, who: int, look: Look | None) -> float:
        """Give somebody other feet, None for the own ones; return from which time on, seconds."""
        own = look or self.looks[who]
        walker = self.walkers[who]
        walker.touches, walker.clips, walker.scale = own.touches, own.clips, own.scale
        return walker.now

    def over(self) -> bool:
        """Return whether nobody is there any more, but for guests."""
        return int(self.world.bodies.present.sum()) == guests(self.world)

    def _frame(self) -> int:
        return self.world.steps // STEPS

    def _look(self) -> None:
        people, bodies = self.world.people, self.world.bodies
        place, facing = bodies.place, bodies.facing
        self.frames.append(
            (
                np.column_stack([place[:, 0], -place[:, 1]]),
                np.arctan2(facing[:, 0], -facing[:, 1]),
                self.postures[people.posture],
                self.gaits[people.emotion],
                bodies.present.copy(),
            )
        )


def minds_of(world: World, acted: Acted, clips: Sequence[Mapping[str, Any]]) -> Minds:
    """Return a scenario's people with the feet that a pack gives them.

    Parameters
    ----------
    world : World
        At its beginning.
    acted : Acted
        What the pack acts: its first people are the scenario's.
    clips : rows of the clones' clips in ``crowd.json``
    """
    names = [str(one["name"]) for one in clips]
    still = {str(one["name"]): k for k, one in enumerate(clips) if not one["speed_m_s"]}
    styles = [f"walk_{one.walk}" for one in world.scenario.emotions]
    count = len(world.people.home)
    rows = acted.people[:count]
    looks = [Look(acted.touches[int(row[1, 2])], acted.clips[int(row[1, 2])], float(row[1, 3])) for row in rows]
    run_clip = names.index("run") if "run" in names else -1
    nowhere = Track(np.zeros(1), np.zeros((1, 2)), np.zeros(1), np.zeros(1, np.int64), np.zeros(1, np.int64))
    minds = Minds(
        world, [], looks, np.array([still.get(str(one), IDLE) for one in world.acts]),
        np.array([names.index(one) if one in names else WALK for one in styles]),
    )  # fmt: skip
    minds._look()
    places, headings, *_ = minds.frames[0]
    for who, (look, row) in enumerate(zip(looks, rows, strict=True)):
        walker = Walker(nowhere, look.touches, look.clips, look.scale, float(row[1, 1]), run=run_clip)
        walker.at, walker.heading = places[who], float(headings[who])
        minds.walkers.append(walker)
    return minds
