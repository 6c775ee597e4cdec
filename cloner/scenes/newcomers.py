"""A clone that comes while a scene is shown: its files as a pack has them, and the part it takes in what is acted.

Nobody's way is worked out anew: a newcomer takes the part of somebody who is walking just then, with steps of its
own. So it meets nobody whom the scenario did not let meet, and gives the part back when it leaves. A newcomer is seen
from near or small, never as an impostor: baking those takes longer than anybody waits (16 s of two busy cores; the
rest 4 s).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.acting.walkers import Track, Walker
from cloner.behaviour.trajectories import RATE_HZ
from cloner.crowd import stock
from cloner.crowd.cast import cast_of
from cloner.crowd.files import packed, shell_bytes, webp
from cloner.crowd.footing import CLIP, FROM, GONE, LAST, UNTIL, Acted, rows_at, touches_of
from cloner.crowd.levels import BodyLevels
from cloner.crowd.pack import ATLAS_QUALITY
from cloner.crowd.people import Found, load_person
from cloner.crowd.scene import IDLE, WALK
from cloner.errors import ClonerError

Array = NDArray[np.float64]

#: Who walks now, this time long at least, and farthest in the next while, is whose part is taken; seconds, taste.
WALKS_S: Final = 4.0
WHILE_S: Final = 12.0
#: How often parts are looked at to choose one, a second.
LOOKS_HZ: Final = 2
_GENERIC: Final = re.compile(r"generic ([0-9a-f]+)")


@dataclass(frozen=True, slots=True, eq=False)
class Newcomer:
    """A clone that can join: files by name, what the page is told of them, touches (K, 48, 6) and clips (K, 2)."""

    files: Mapping[str, bytes]
    row: Mapping[str, Any]
    touches: NDArray[np.float32]
    clips: NDArray[np.float32]
    names: tuple[str, ...]


def newcomer_of(found: Found, facts: Mapping[str, Any], body: BodyLevels) -> Newcomer:
    """Return a finished clone made ready for a pack that acts.

    Raises
    ------
    ClonerError
        If it cannot be read, may not be shown, or does not fit the pack's clones.
    """
    own = facts["people"][0]
    match = _GENERIC.search(str(own["stamp"]))
    clone, _ = load_person(found, match.group(1) if match else "")
    names = tuple(str(one["name"]) for one in own["clips"])
    cast = cast_of("newcomer", clone, body, poses=int(facts["impostors"]["poses"]), feelings=len(names) > IDLE + 2)
    if tuple(one.name for one in cast.clips) != names:
        hint = "Make the pack again with cloner crowd --feelings, without --walk, and the scene of it"
        raise ClonerError("the scene's clones walk as newcomers cannot", hint, found.identifier)
    numbers = stock.numbers_of(cast)
    texels = float(facts["switch"]["texels_per_m"])
    arrays: dict[str, NDArray[Any]] = {
        "vertices": numbers.vertices, "loose": numbers.loose, "corners": numbers.corners, "bones": numbers.bones,
        "table": stock.table_row(cast, [0] * len(cast.clips), texels, int(own["views"]), 0),
        "tiles": np.zeros((2, 4), np.float32),
    }  # fmt: skip
    data, told = packed(arrays)
    files = {
        "numbers.bin": data, "atlas.webp": webp(cast.atlas, ATLAS_QUALITY), "codes.webp": webp(cast.marks, None),
        "shell.webp": shell_bytes(cast.shell),
    }  # fmt: skip
    clips = [{"frames": len(one.frames), "speed_m_s": one.speed_m_s} for one in cast.clips]
    row = {"arrays": told, "stature_m": round(cast.stature_m, 4)}
    lengths = np.array([[len(one.frames), one.seconds] for one in cast.clips], np.float32)
    return Newcomer(files, row, touches_of(numbers, body, clips), lengths, names)


@dataclass(frozen=True, slots=True, eq=False)
class Parts:
    """Where everybody is who acts, `LOOKS_HZ` times a second: (T, N, 2) metres, and (T, N) who is there and walks."""

    places_m: Array
    present: NDArray[np.bool_]
    walking: NDArray[np.bool_]


def parts_in(acted: Acted, seconds: float) -> Parts:
    """Return the parts that are acted."""
    times = np.arange(max(int(seconds * LOOKS_HZ), 1)) / LOOKS_HZ
    rows = np.stack([rows_at(acted, float(now)) for now in times])
    walking = np.zeros(rows.shape[:2], bool)
    for who in range(rows.shape[1]):
        own = acted.footings[acted.starts[who] : acted.starts[who + 1]]
        walking[:, who] = own[_footing(own, times), LAST] >= 0.0
    return Parts(rows[:, :, 0, 1:3].astype(np.float64), rows[:, :, 0, 0] < GONE, walking)


def part_for(parts: Parts, now: float, taken: frozenset[int]) -> int:
    """Return whose part to take at a time: who walks now and goes farthest in the next while.

    Raises
    ------
    ClonerError
        If nobody is there whose part is free.
    """
    count = len(parts.places_m)
    at = (int(now * LOOKS_HZ) + np.arange(int(WHILE_S * LOOKS_HZ))) % count
    places, there, walks = parts.places_m[at], parts.present[at], parts.walking[at]
    both = there[:-1] & there[1:] & (at[1:] > at[:-1])[:, None]
    gone = (np.linalg.norm(np.diff(places, axis=0), axis=2) * both).sum(axis=0)
    soon = max(int(WALKS_S * LOOKS_HZ), 1)
    worth = gone + 1e3 * walks[:soon].all(axis=0)
    worth[~there[0]] = -1.0
    worth[list(taken)] = -1.0
    best = int(np.argmax(worth))
    if worth[best] < 0.0:
        raise ClonerError("nobody's part is free in the scene", "Take a scenario with more people", "scene")
    return best


def footings_for(newcomer: Newcomer, acted: Acted, who: int) -> NDArray[np.float32]:
    """Return somebody's part as a newcomer acts it, (n, COLUMNS)."""
    run = newcomer.names.index("run") if "run" in newcomer.names else -1
    track = track_in(acted, who, newcomer.names)
    own = Walker(track, newcomer.touches, newcomer.clips, 1.0, 0.37, run=run)
    return own.footings().astype(np.float32)


def track_in(acted: Acted, who: int, names: tuple[str, ...]) -> Track:
    """Return where somebody is and what is done there in what is acted, ten times a second."""
    own = acted.footings[acted.starts[who] : acted.starts[who + 1]]
    end = float(own[-1, UNTIL])
    times = np.arange(max(int(end * RATE_HZ), 2)) / RATE_HZ
    alone = replace(acted, footings=own, starts=np.array([0, len(own)], np.uint32), people=acted.people[who : who + 1])
    rows = np.stack([rows_at(alone, float(now))[0] for now in times])
    place = _footing(own, times)
    stands = own[:, LAST] < 0.0
    acts = np.where(stands, own[:, CLIP], IDLE).astype(np.int64)
    walks = np.where(stands, WALK, own[:, CLIP]).astype(np.int64)
    for k in range(len(walks) - 1, -1, -1):  # who stands will walk as next
        if stands[k] and k + 1 < len(walks):
            walks[k] = walks[k + 1]
    walks[[names[one] == "run" for one in walks]] = WALK  # who has to, runs
    return Track(times, rows[:, 0, 1:3].astype(np.float64), rows[:, 0, 3].astype(np.float64), acts[place], walks[place])


def _footing(own: NDArray[np.float32], times: Array) -> NDArray[np.int64]:
    found = np.searchsorted(own[:, FROM], times, side="right") - 1
    return np.clip(found, 0, len(own) - 1).astype(np.int64)
