"""A scenario in real time, as footings computed slightly ahead of what is shown.

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

from cloner.acting.tracks import make_feet
from cloner.behaviour.feet import SEEN_S, Feet, take_footings
from cloner.behaviour.guests import guest_count
from cloner.behaviour.loop import run
from cloner.behaviour.model import Scenario
from cloner.behaviour.trajectories import STEPS
from cloner.behaviour.walking import RATE_HZ
from cloner.behaviour.world import World, make_world
from cloner.crowd.staged.footing import Acted
from cloner.errors import ClonerError
from cloner.records.arrays import Array

#: So far ahead of what is shown minds decide, seconds: what feet need to know, the longest footing (.8), and 1.2 for a
#: machine that does something else just then.
HEAD_S: Final = SEEN_S + 2.0
#: Whoever goes farthest in this time is whose part a newcomer takes, seconds.
GOES_S: Final = 2.0
#: Looks that newcomers may have at once.
SPARE: Final = 32


@dataclass(frozen=True, slots=True, eq=False)
class WalkerFeet:
    """A walker's feet: (K, 48, 6) touches and (K, 2) clips (`crowd.staged.footing.Acted`), and its size."""

    touches: NDArray[np.float32]
    clips: NDArray[np.float32]
    scale: float


@dataclass(slots=True, eq=False)
class RunningScenario:
    """A running scenario and everybody's feet; ``feet`` are those that the pack gives."""

    world: World
    feet: Feet
    places: deque[Array] = field(default_factory=lambda: deque(maxlen=round(GOES_S * RATE_HZ)))
    dressed: dict[int, int] = field(default_factory=dict)

    def go_on(self, shown_s: float) -> dict[int, NDArray[np.float32]]:
        """Simulate until `HEAD_S` ahead of what is shown; return everybody's new footings.

        A footing that goes on where the last one was is told again, longer: it begins at the same time. Between two
        calls at most `HEAD_S` may pass.
        """
        if not self.world.steps:
            self._watch()
        for now in run(self.world, max(shown_s + HEAD_S - self.world.time_s, 0.0)):
            if now.steps % STEPS == 0:
                self._watch()
        self.world.core.call("stride", self.world.time_s - SEEN_S)
        return take_footings(self.world.core)

    def farthest_walker(self, taken: frozenset[int]) -> int:
        """Return who walks farthest at present, of those whose part is not taken.

        Raises
        ------
        ClonerError
            If nobody is left.
        """
        away = self.places[-1] - self.places[0]
        worth = np.linalg.norm(away, axis=1)
        worth[~self.world.bodies.present] = -1.0
        worth[list(taken)] = -1.0
        best = int(np.argmax(worth))
        if worth[best] < 0.0:
            raise ClonerError("nobody's part is free in the scene", "Take a scenario with more people", "scene")
        return best

    def set_feet(self, who: int, look: WalkerFeet | None, key: str = "") -> float:
        """Give a person other feet (None: the original ones) of a clone with a key; return from which time on, seconds.

        Nothing is kept of feet that are given back.
        """
        arrays = self.world.core.arrays
        before = self.dressed.pop(who, None)
        if before is not None:
            arrays["touches"][before], arrays["clips"][before] = 0.0, 0.0
        number, scale = int(self.feet.look[who]), float(self.feet.scale[who])
        if look is not None:
            first = len(self.feet.touches)
            number = min(set(range(first, first + self.feet.spare)) - set(self.dressed.values()))
            arrays["touches"][number], arrays["clips"][number], scale = look.touches, look.clips, look.scale
            self.dressed[who] = number
        arrays["look_of"][who], arrays["scale"][who] = number, scale
        self.world.log.append((self.world.steps, "dress", (who, number, scale, key)))
        return float(arrays["clock"][who])

    @property
    def gone_s(self) -> dict[int, float]:
        """Return when each absent person was last present, seconds."""
        seen = self.world.core.arrays["last_seen"]
        return {int(who): float(seen[who]) / RATE_HZ for who in np.flatnonzero(~self.world.bodies.present)}

    def over(self) -> bool:
        """Return whether nobody is left except guests."""
        return int(self.world.bodies.present.sum()) == guest_count(self.world)

    def _watch(self) -> None:
        self.world.core.call("watch")
        self.places.append(self.world.bodies.place.copy())


def start_scenario(scenario: Scenario, seed: int, acted: Acted, clips: Sequence[Mapping[str, Any]]) -> RunningScenario:
    """Return a scenario's people with the feet that a pack gives them.

    Parameters
    ----------
    scenario, seed
        As of :func:`cloner.behaviour.world.make_world`.
    acted : Acted
        What the pack acts: its first people are the scenario's.
    clips : rows of the clones' clips in ``crowd.json``

    Raises
    ------
    ClonerError
        If the pack has fewer people, or as of :func:`cloner.behaviour.world.make_world`.
    """
    if scenario.people() > len(acted.people):
        raise ClonerError("the scene acts fewer people than its scenario has", "Build it again", "scene")
    feet = make_feet(acted.touches, acted.clips, acted.people[: scenario.people()], clips, spare=SPARE)
    return RunningScenario(make_world(scenario, seed, feet), feet)
