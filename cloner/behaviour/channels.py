"""Who has the last word on a person: guided before reaction before script before innate, for each channel alone.

An order on one channel switches nothing off on another: who is sent to the door still avoids others, until somebody
with more say orders otherwise on the channel "avoidance".
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

#: Who may order whom: the later one wins ([S]: guided before reaction before script before what is innate).
INNATE, SCRIPT, REACTION, GUIDED = range(4)
LEVELS: Final = ("innate", "script", "reaction", "guided")
#: What can be ordered, and the value that says nothing is: goal (place in the world's list), speed (m/s), posture
#: (place in the list of acts), gaze (place in the list of things), avoidance (0 or 1).
CHANNELS: Final = {"goal": -1, "speed": -1.0, "posture": -1, "gaze": -1, "avoidance": -1}


@dataclass(slots=True, eq=False)
class Orders:
    """What each level orders each of ``count`` people: (4, n) a channel."""

    count: int
    rows: dict[str, NDArray[Any]] = field(init=False)

    def __post_init__(self) -> None:
        self.rows = {name: np.full((len(LEVELS), self.count), none) for name, none in CHANNELS.items()}
        self.rows["avoidance"][INNATE] = 1

    def give(self, level: int, channel: str, who: Any, value: Any) -> None:
        """Order some people something on one channel; an earlier order of the same level is forgotten."""
        self.rows[channel][level, who] = value

    def withdraw(self, level: int, who: Any, channels: tuple[str, ...] = tuple(CHANNELS)) -> None:
        """Take back what a level ordered some people; what is innate stays."""
        for channel in channels:
            self.rows[channel][level, who] = 1 if (channel, level) == ("avoidance", INNATE) else CHANNELS[channel]

    def chosen(self, channel: str) -> NDArray[Any]:
        """Return what holds for each person, (n,): the order of the highest level that gave one."""
        found = self.rows[channel][INNATE].copy()
        for level in range(1, len(LEVELS)):
            row = self.rows[channel][level]
            found = np.where(row != CHANNELS[channel], row, found)
        return np.asarray(found)
