"""Viewers of a page who walk in the scene as guests of the scenario."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour.guests import find_free_guest, move_guest, remove_guest
from cloner.behaviour.world import World

#: X and Z in the page's frame, metres, and the heading of the eye.
Place = tuple[float, float, float]
#: Who walks along in a page that says nothing for so long is taken to have gone, seconds.
SILENT_S: Final = 3.0


class PageGuests:
    """Which page controls which guest, and when it was heard last."""

    def __init__(self) -> None:
        self._pages: dict[object, tuple[int, float]] = {}

    def update(self, world: World, page: object, place: Place | None, now: float) -> int:
        """Move the guest of a page to a place, or remove it (None); return the guest's number, -1 if none is free."""
        who, _ = self._pages.pop(page, (-1, 0.0))
        if place is None:
            remove_guest(world, who)
            return -1
        who = find_free_guest(world) if who < 0 else who
        if who >= 0:
            x, z, heading = place
            move_guest(world, who, (x, -z), (float(np.sin(heading)), -float(np.cos(heading))))
            self._pages[page] = (who, now)
        return who

    def drop_silent(self, world: World, now: float) -> None:
        """Remove the guests of pages that have fallen silent."""
        for page, (_, heard) in list(self._pages.items()):
            if now - heard > SILENT_S:
                self.update(world, page, None, now)
