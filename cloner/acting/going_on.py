"""A scenario that a page continues by itself: its initial state as numbers, and the engine that reads them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from cloner.acting.tracks import feet_of
from cloner.behaviour.beginning import beginning
from cloner.behaviour.core.host import MODULE
from cloner.behaviour.language import read_text
from cloner.behaviour.world import world_of
from cloner.crowd.drawing.player import ENGINE_FILE, MINDS_FILE
from cloner.crowd.packs.files import packed
from cloner.crowd.staged.footing import Acted


@dataclass(frozen=True, slots=True)
class GoingOn:
    """What a page needs to continue a scenario: files of a pack, and their entry in ``crowd.json``."""

    files: Mapping[str, bytes]
    facts: Mapping[str, Any]


def welcoming(text: str, where: str = "scenario") -> str:
    """Return a scenario in which whoever walks along in the page can be somebody: a guest, if none is expected.

    Raises
    ------
    ClonerError
        If something is wrong in it; ``where`` is what it is called then.
    """
    groups = read_text(text, where).groups
    if any(one.outside for one in groups):
        return text
    taken = {str(one.name) for one in groups}
    name = next(one for one in (f"visitor{'_' * k}" for k in range(len(taken) + 1)) if one not in taken)
    return f"{text.rstrip()}\ncrowd 1 {name}: from outside\n"


def going_on(text: str, seed: int, acted: Acted, clips: Sequence[Mapping[str, Any]]) -> GoingOn:
    """Return what a page needs to continue a scenario.

    Parameters
    ----------
    text, seed
        Of the scenario, which has been checked.
    acted : Acted
        Its people are the scenario's.
    clips : rows of the clones' clips in ``crowd.json``
    """
    scenario = read_text(text)
    world = world_of(scenario, seed, feet_of(acted.touches, acted.clips, acted.people, clips))
    begun, tables = beginning(world)
    data, arrays = packed(tables)
    facts = {"text": text, "seed": seed, "begun": begun, "arrays": arrays, "events": world.names.events,
             "things": world.names.things}  # fmt: skip
    return GoingOn({MINDS_FILE: data, ENGINE_FILE: MODULE.read_bytes()}, facts)
