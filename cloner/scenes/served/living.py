"""A running scene: its scenario, newcomers, and messages to pages.

Pages are told what happens in order: what came from outside before which step, so that their engines do the same steps;
who comes and goes; which statue awakes. Who opens a page later, or again, is told first how things stand. Nothing of a
newcomer is written: its files lie in memory and are gone with it.
"""

from __future__ import annotations

import secrets
import threading
import time
from collections import OrderedDict, deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.beginning import engine_layout
from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import guide
from cloner.crowd.clones.levels import body_levels
from cloner.crowd.clones.people import Found
from cloner.crowd.drawing.player import MINDS_FILE, player_page
from cloner.crowd.packs.reading import read_acted, read_facts
from cloner.crowd.staged.footing import FROM, UNTIL
from cloner.errors import ClonerError
from cloner.project.folder import safe_identifier
from cloner.scenes.served.guests import PageGuests, Place
from cloner.scenes.served.minds import RunningScenario, WalkerFeet, start_scenario
from cloner.scenes.served.newcomers import Mark, Newcomer, creation_time, latest_clones, make_newcomer
from cloner.scenes.served.telling import footing_message, page_description, state_message

#: So many newcomers are there at once; the one who came first makes place. Each is 3 MB of a page's textures; taste.
MOST: Final = 12
#: How often the scene goes on, and finished clones are looked for, seconds.
EVERY_S: Final = 0.5
#: What a machine that slept or was busy for longer has missed is left out, seconds: nobody jumps.
LATE_S: Final = 2.0
#: Footings over for so long are forgotten, seconds.
PAST_S: Final = 2.0
#: So many events are kept for pages that are slow, two minutes; one that is slower begins anew.
KEPT_EVENTS: Final = 240
AWAKENS: Final = " awakens"

Event = tuple[str, dict[str, Any]]


@dataclass(slots=True, eq=False)
class Participant:
    """A newcomer in the scene: its description for pages, its files, and whose part it plays from when."""

    told: dict[str, Any]
    newcomer: Newcomer
    who: int
    at_s: float


class RunningScene:
    """A built scene and the newcomers in it.

    Parameters
    ----------
    pack : Path
        What ``cloner scene build`` made of a scenario.
    clones : callable
        Returns the folders of finished clones that may be shown, the newest first.
    said : callable
        Gets a line for whoever runs the scene.

    Attributes
    ----------
    facts, body
        The pack's.
    said
        As given.

    Raises
    ------
    ClonerError
        If the pack is damaged or holds no scenario.
    """

    def __init__(self, pack: Path, clones: Callable[[], tuple[Path, ...]], said: Callable[[str], None]) -> None:
        self.pack, self.over = pack, ""
        self._clones, self.said = clones, said
        self.facts = read_facts(pack)
        self._acted = read_acted(pack, self.facts)
        self.body = body_levels(mouth="faces" in self.facts)
        self._there: OrderedDict[str, Participant] = OrderedDict()
        self._keys: dict[Mark, str] = {}
        self._old = frozenset(latest_clones(self._clones, MOST))
        self._events: deque[Event] = deque(maxlen=KEPT_EVENTS)
        self._count = 0
        self._minding = threading.RLock()  # whoever touches minds; first, where both are taken
        self._turn = threading.Condition()  # whoever touches what pages are told: nobody thinks meanwhile
        try:
            scenario = self.facts["scenario"]
            self._scenario, self._seed = (
                parse_scenario(str(scenario["text"]), "the scene's scenario"),
                int(scenario["seed"]),
            )
            if MINDS_FILE not in self.facts["files"]:
                raise ValueError("an older version's")
        except (LookupError, TypeError, ValueError) as error:
            hint = "Build it from a scenario's text: cloner scene build --walk SCENARIO"
            raise ClonerError("the scene holds no scenario that could go on", hint, pack.name) from error
        self._begin()

    def now(self) -> float:
        """Return the scene's own time, equal in all pages, seconds."""
        return time.monotonic() - self._begun

    def page(self) -> bytes:
        """Return the page that shows the scene and connects to this server."""
        return player_page(self.pack, self.facts | {"live": True})

    def file(self, key: str, name: str) -> bytes | None:
        """Return a newcomer's file, None for anything else."""
        with self._turn:
            found = self._there.get(key)
        return found.newcomer.files.get(name) if found else None

    # ---- minds ----

    def _begin(self) -> None:
        """Start the scenario (again); newcomers get other parts in it."""
        self._minds: RunningScenario = start_scenario(
            self._scenario, self._seed, self._acted, self.facts["people"][0]["clips"]
        )
        self._guests, self._heard, self._seed = PageGuests(), 0, self._seed + 1
        new, world = self._minds.go_on(0.0), self._minds.world
        with self._turn:
            self._begun, self._shown_s = time.monotonic(), 0.0
            self._engine = engine_layout(world)
            self._kept = world.steps, world.core.memory()
            self._ways: dict[int, NDArray[np.float32]] = new
            self._awake: list[tuple[str, float]] = []
            for one in self._there.values():
                one.who = -1
            for one in self._there.values():
                self._cast(one)

    def go_on(self) -> None:
        """Advance the scene to the present, and inform the pages."""
        with self._minding:
            self._begun += max(self.now() - self._shown_s - LATE_S, 0.0)
            if self._minds.over() and self.now() > max(self._minds.gone_s.values(), default=0.0):
                self._begin()
                with self._turn:
                    self._tell("hello", self._hello())
                return
            now = self._shown_s = self.now()
            self._guests.drop_silent(self._minds.world, now)
            self._publish(self._minds.go_on(now))

    def _publish(self, new: dict[int, NDArray[np.float32]]) -> None:
        """Send the pages new footings and events, and keep those that are not over."""
        with self._turn:
            for who, rows in new.items():
                kept = self._ways.get(who, rows[:0])
                kept = kept[(kept[:, UNTIL] > self._shown_s - PAST_S) & (kept[:, FROM] < rows[0, FROM])]
                self._ways[who] = np.concatenate([kept, rows])
            world = self._minds.world
            self._kept, log = (world.steps, world.core.memory()), [[at, name, *own] for at, name, own in world.log]
            world.log.clear()
            same = world.core.call("sum") & 0xFFFFFFFF
            self._tell("steps", {"now": self.now(), "until": world.steps, "log": log, "sum": same})
            for when, text in world.told[self._heard :]:
                if text.endswith(AWAKENS):
                    self._awake.append((text.removesuffix(AWAKENS), when))
                    self._tell("awakes", {"name": text.removesuffix(AWAKENS), "at": when})
            self._heard = len(world.told)
            for key, one in self._there.items():
                if self._minds.gone_s.get(one.who, np.inf) < self.now() and not self._minds.over():
                    self._cast(one)
                    self._tell("plays", {"key": key, "who": one.who, "at": one.at_s})

    def order(self, text: str) -> None:
        """Execute a guide's order; pages show it when simulated and shown time meet.

        Raises
        ------
        ClonerError
            If the order says something wrong.
        """
        with self._minding:
            guide(self._minds.world, text)

    def walks(self, page: object, place: Place | None) -> int:
        """Move the guest of a page (`PageGuests.update`); return the guest's number."""
        with self._minding:
            return self._guests.update(self._minds.world, page, place, self.now())

    def _cast(self, one: Participant) -> None:
        """Give a newcomer the part of the person who walks farthest at present."""
        taken = frozenset(other.who for other in self._there.values() if other.who >= 0)
        one.who = self._minds.farthest_walker(taken)
        look = WalkerFeet(one.newcomer.touches, one.newcomer.clips, 1.0)
        one.at_s = self._minds.set_feet(one.who, look, one.told["key"])

    # ---- pages ----

    def told(self, wait_s: float) -> Iterator[Event | None]:
        """Yield the state, then events; None if nothing happened for a while; until the scene ends.

        Who takes events so slowly that they are not kept any more is told no more, and may ask anew.
        """
        with self._turn:
            place, hello = self._count, self._hello()
        yield "hello", hello
        while True:
            with self._turn:
                if self._count <= place and not self.over:
                    self._turn.wait(wait_s)
                missed = self._count - place
                if missed > len(self._events):
                    return
                new = list(self._events)[len(self._events) - missed :]
                place = self._count
            yield from new or (None,)
            if self.over:
                return

    def stop(self, text: str = "The scene is no longer shown.") -> None:
        """Tell all pages that it is over; no files are served any more."""
        with self._turn:
            self._there.clear()
            self._tell("over", {"text": text})
            self.over = text

    def _hello(self) -> dict[str, Any]:
        there = [{**one.told, "who": one.who, "at": one.at_s, "fresh": False} for one in self._there.values()]
        until, kept = self._kept
        return {"now": self.now(), "newcomers": there, "awake": self._awake, "begun": self._engine, "until": until,
                "state": state_message(kept), **footing_message(self._ways)}  # fmt: skip

    def _tell(self, kind: str, what: dict[str, Any]) -> None:
        self._events.append((kind, what))
        self._count += 1
        self._turn.notify_all()

    # ---- newcomers ----

    def look(self) -> None:
        """Find newcomers and leavers since the last call, and prepare at most one newcomer.

        Raises
        ------
        ClonerError
            If the pack was taken away, as when somebody in it is forgotten, or made anew; all pages are told.
        """
        if page_description(self.pack) != self.facts["player"]:
            self.stop("The scene was taken away or made anew.")
            hint = "Build it again without whom it may not show, and serve it again"
            raise ClonerError("the scene was taken away or made anew", hint, self.pack.name)
        wanted = latest_clones(self._clones, MOST)
        for mark in [one for one in self._keys if one not in wanted]:
            self.leave(self._keys.pop(mark))
        for mark in wanted:
            if mark not in self._keys:
                self._come(mark)
                return

    def _come(self, mark: Mark) -> None:
        name = safe_identifier(mark[0].resolve().name)
        self._keys[mark] = ""
        try:
            newcomer = make_newcomer(Found(name, mark[0]), self.facts, self.body)
            if creation_time(mark[0]) != mark[1]:  # forgotten, or made anew, in the meantime
                self._keys.pop(mark)
                return
            self._keys[mark] = self.enter(newcomer, fresh=mark not in self._old)
        except ClonerError as error:
            self.said(f"not shown: {error}")
            return
        self.said(f"{name} is in the scene")

    def enter(self, newcomer: Newcomer, *, fresh: bool) -> str:
        """Give a newcomer a part; return the key by which it leaves. ``fresh``: pages find and follow it."""
        key = secrets.token_urlsafe(12)
        one = Participant({"key": key, "row": dict(newcomer.row)}, newcomer, -1, 0.0)
        with self._minding, self._turn:
            self._cast(one)
            self._there[key] = one
            self._tell("come", {**one.told, "who": one.who, "at": one.at_s, "fresh": fresh})
        return key

    def leave(self, key: str) -> None:
        """Remove a newcomer."""
        with self._minding, self._turn:
            one = self._there.pop(key, None)
            if one is None:
                return
            self._minds.set_feet(one.who, None)
            self._tell("gone", {"key": key})
        self.said("somebody has left the scene")
