"""Visitors who walk in a page as guests of the scenario."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour.guests import free_guest, leave, receive
from cloner.behaviour.world import World

#: X and Z in the page's frame, metres, and the heading of the eye.
Place = tuple[float, float, float]
#: Who walks along in a page that says nothing for so long is taken to have gone, seconds.
SILENT_S: Final = 3.0


class Guests:
    """Which page's walker has which guest's part in a world, and when it was heard last."""

    def __init__(self) -> None:
        self._pages: dict[object, tuple[int, float]] = {}

    def hear(self, world: World, page: object, place: Place | None, now: float) -> int:
        """Let the guest of a page be where it says, or be gone; return whose part that is, -1 if there is none."""
        who, _ = self._pages.pop(page, (-1, 0.0))
        if place is None:
            leave(world, who)
            return -1
        who = free_guest(world) if who < 0 else who
        if who >= 0:
            x, z, heading = place
            receive(world, who, (x, -z), (float(np.sin(heading)), -float(np.cos(heading))))
            self._pages[page] = (who, now)
        return who

    def go_on(self, world: World, now: float) -> None:
        """Let those be gone whose pages have fallen silent."""
        for page, (_, heard) in list(self._pages.items()):
            if now - heard > SILENT_S:
                self.hear(world, page, None, now)
