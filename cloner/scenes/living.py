"""A built scene into which clones come while it is shown: who is there, whose part each has, and what pages are told.

Nothing of a newcomer is written: its files lie in memory and are gone with it. Pages are told in order what has
happened; who opens a page later is told who is there.
"""

from __future__ import annotations

import base64
import json
import secrets
import threading
import time
from collections import OrderedDict
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from numpy.typing import NDArray

from cloner.crowd.files import MARK, packed
from cloner.crowd.levels import body_levels
from cloner.crowd.people import Found
from cloner.crowd.player import player_page
from cloner.crowd.reading import read_acted, read_facts
from cloner.errors import ClonerError
from cloner.project.clone_file import CLONE_FILE
from cloner.project.folder import safe_identifier
from cloner.project.results import RESULT_MARK
from cloner.scenes.newcomers import Newcomer, footings_for, newcomer_of, part_for, parts_in

#: So many newcomers are there at once; the one who came first makes place. Each is 3 MB of a page's textures; taste.
MOST: Final = 12
#: How often finished clones are looked for, seconds.
EVERY_S: Final = 0.5
#: Pages that may listen at once.
MOST_PAGES: Final = 8
#: A part is on the way to a page for so long; it is chosen for then, seconds.
AHEAD_S: Final = 0.5
PART_FILE: Final = "part.json"

Event = tuple[str, dict[str, Any]]
#: A folder and when the clone in it was made.
Mark = tuple[Path, float]


@dataclass(slots=True, eq=False)
class _There:
    """A newcomer who is there: what pages are told, the files they may ask for, and whose part it has, -1 for none."""

    told: dict[str, Any]
    newcomer: Newcomer
    who: int = -1
    part: bytes = b""


class Living:
    """A built scene, and who has come.

    Parameters
    ----------
    pack : Path
        What ``cloner scene build`` (or ``behave bake``) wrote.
    clones : callable
        Returns the folders of finished clones that may be shown, the newest first.
    said : callable
        Gets a line for whoever runs the scene.

    Raises
    ------
    ClonerError
        If the pack is damaged or acts nothing.
    """

    def __init__(self, pack: Path, clones: Callable[[], tuple[Path, ...]], said: Callable[[str], None]) -> None:
        self.pack, self.over = pack, ""
        self._clones, self._said = clones, said
        self._facts = read_facts(pack)
        self._acted = read_acted(pack, self._facts)
        self._parts = parts_in(self._acted, self.seconds)
        staged = self._facts.get("staging", {})
        self._things = frozenset(int(one[0]) for one in (*staged.get("stone", ()), *staged.get("wakes", ())))
        self._body = body_levels()
        self._there: OrderedDict[str, _There] = OrderedDict()
        self._keys: dict[Mark, str] = {}
        self._old = frozenset(self._marks())
        self._events: list[Event] = []
        self._turn = threading.Condition()
        self._begun = time.monotonic()

    @property
    def seconds(self) -> float:
        """How long the scene is before it begins again."""
        return float(self._facts["acted"]["seconds"])

    def now(self) -> float:
        """Return the scene's own time, the same in all pages, seconds."""
        return (time.monotonic() - self._begun) % self.seconds

    def page(self) -> bytes:
        """Return the page that shows the scene and asks this server who comes."""
        return player_page(self.pack, self._facts | {"live": True})

    def look(self) -> None:
        """See who has come and who has gone since the last time, and make at most one newcomer ready.

        Raises
        ------
        ClonerError
            If the pack was taken away, as when somebody in it is forgotten, or made anew; all pages are told.
        """
        if _described(self.pack) != self._facts["player"]:
            self.stop("The scene was taken away or made anew.")
            hint = "Build it again without whom it may not show, and serve it again"
            raise ClonerError("the scene was taken away or made anew", hint, self.pack.name)
        wanted = self._marks()
        for mark in [one for one in self._keys if one not in wanted]:
            self._leave(self._keys.pop(mark))
        for mark in wanted:
            if mark not in self._keys:
                self._come(mark)
                return

    def _marks(self) -> list[Mark]:
        """Return who is to be there: folders and when their clones were made, the newest first."""
        made = [(folder, _made(folder)) for folder in self._clones()]
        return [(folder, when) for folder, when in made if when is not None][:MOST]

    def file(self, key: str, name: str) -> bytes | None:
        """Return a newcomer's file, None for anything else; the part is chosen when a page first asks for it.

        So nobody has walked away before a slow page can show it, and all pages show the same.
        """
        with self._turn:
            found = self._there.get(key)
            if found is None or name != PART_FILE:
                return found.newcomer.files.get(name) if found else None
            if not found.part:
                try:
                    found.part = self._part(found)
                except ClonerError as error:
                    self._said(f"not shown: {error}")
                    return None
            return found.part

    def _part(self, one: _There) -> bytes:
        """Choose a newcomer's part and return it as pages read it: whose it is, and arrays in line."""
        taken = frozenset(other.who for other in self._there.values() if other.who >= 0) | self._things
        one.who = part_for(self._parts, (self.now() + AHEAD_S) % self.seconds, taken)
        arrays: dict[str, NDArray[Any]] = {
            "footings": footings_for(one.newcomer, self._acted, one.who), "touches": one.newcomer.touches,
            "clips": one.newcomer.clips,
        }  # fmt: skip
        data, told = packed(arrays)
        held = {"who": one.who, "arrays": told, "data": base64.b64encode(data).decode("ascii")}
        return json.dumps(held).encode()

    def told(self, wait_s: float) -> Iterator[Event | None]:
        """Yield who is there, then what happens; None where nothing did for a while; until all is over."""
        with self._turn:
            place = len(self._events)
            hello = {"now": self.now(), "newcomers": [{**one.told, "fresh": False} for one in self._there.values()]}
        yield "hello", hello
        while True:
            with self._turn:
                if len(self._events) <= place and not self.over:
                    self._turn.wait(wait_s)
                new = self._events[place:]
                place = len(self._events)
            yield from new or (None,)
            if self.over:
                return

    def stop(self, text: str = "The scene is no longer shown.") -> None:
        """Tell all pages that it is over; nobody's files are given out any more."""
        with self._turn:
            self._there.clear()
        self._tell("over", {"text": text})
        self.over = text

    def _come(self, mark: Mark) -> None:
        name = safe_identifier(mark[0].resolve().name)
        self._keys[mark] = ""
        try:
            newcomer = newcomer_of(Found(name, mark[0]), self._facts, self._body)
        except ClonerError as error:
            self._said(f"not shown: {error}")
            return
        if _made(mark[0]) != mark[1]:  # forgotten, or made anew, in the meantime
            self._keys.pop(mark)
            return
        key = self._keys[mark] = secrets.token_urlsafe(12)
        told = {"key": key, "row": dict(newcomer.row)}
        with self._turn:
            self._there[key] = _There(told, newcomer)
        self._tell("come", {**told, "fresh": mark not in self._old})
        self._said(f"{name} is in the scene")

    def _leave(self, key: str) -> None:
        with self._turn:
            if self._there.pop(key, None) is None:
                return
        self._tell("gone", {"key": key})
        self._said("somebody has left the scene")

    def _tell(self, kind: str, what: dict[str, Any]) -> None:
        with self._turn:
            self._events.append((kind, what))
            self._turn.notify_all()


def line(event: Event | None) -> bytes:
    """Return an event as a stream of events has it (HTML, 9.2); a remark where nothing happened."""
    if event is None:
        return b": \n\n"
    return f"event: {event[0]}\ndata: {json.dumps(event[1])}\n\n".encode()


def finished_in(folder: Path) -> tuple[Path, ...]:
    """Return the finished clones in a folder of results, the newest first."""
    found = []
    for path in folder.glob(f"*/{CLONE_FILE}"):
        made = _made(path.parent)
        if made is not None and (path.parent / RESULT_MARK).is_file() and not path.parent.name.startswith("."):
            found.append((made, path.parent))
    return tuple(one for _, one in sorted(found, reverse=True))


def _made(folder: Path) -> float | None:
    try:
        return (folder / CLONE_FILE).stat().st_mtime
    except OSError:
        return None


def _described(pack: Path) -> Any:
    """Return what a pack says of its page now, None where there is no pack any more."""
    try:
        return json.loads((pack / MARK).read_bytes())["player"]
    except (OSError, ValueError, LookupError, TypeError):
        return None
