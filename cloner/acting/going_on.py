"""A scenario that a page continues by itself: its initial state as numbers, and the engine that reads them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from cloner.acting.tracks import make_feet
from cloner.behaviour.beginning import initial_state
from cloner.behaviour.core.host import MODULE
from cloner.behaviour.language import parse_scenario
from cloner.behaviour.world import make_world
from cloner.crowd.drawing.player import ENGINE_FILE, MINDS_FILE
from cloner.crowd.packs.files import pack_arrays
from cloner.crowd.staged.footing import Acted


@dataclass(frozen=True, slots=True)
class Continuation:
    """What a page needs to continue a scenario: files of a pack, and their entry in ``crowd.json``."""

    files: Mapping[str, bytes]
    facts: Mapping[str, Any]


def with_guest(text: str, where: str = "scenario") -> str:
    """Return a scenario with at least one guest, whom a viewer of the page can control.

    Raises
    ------
    ClonerError
        If something is wrong in it; ``where`` is what it is called then.
    """
    groups = parse_scenario(text, where).groups
    if any(one.outside for one in groups):
        return text
    taken = {str(one.name) for one in groups}
    name = next(one for one in (f"visitor{'_' * k}" for k in range(len(taken) + 1)) if one not in taken)
    return f"{text.rstrip()}\ncrowd 1 {name}: from outside\n"


def make_continuation(text: str, seed: int, acted: Acted, clips: Sequence[Mapping[str, Any]]) -> Continuation:
    """Return what a page needs to continue a scenario.

    Parameters
    ----------
    text, seed
        Of the scenario, which has been checked.
    acted : Acted
        Its people are the scenario's.
    clips : rows of the clones' clips in ``crowd.json``
    """
    scenario = parse_scenario(text)
    world = make_world(scenario, seed, make_feet(acted.touches, acted.clips, acted.people, clips))
    begun, tables = initial_state(world)
    data, arrays = pack_arrays(tables)
    facts = {"text": text, "seed": seed, "begun": begun, "arrays": arrays, "events": world.names.events,
             "things": world.names.things}  # fmt: skip
    return Continuation({MINDS_FILE: data, ENGINE_FILE: MODULE.read_bytes()}, facts)
