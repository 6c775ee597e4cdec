"""Footsteps of a film, at the time and place of each heel strike; the same sound as ``web/sound.js``."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.crowd.staged.footing import FROM, GONE, LAST, Acted
from cloner.crowd.staged.scene import Mulberry32
from cloner.crowd.staged.staging import STONE, UP, Staging
from cloner.records.arrays import Array
from cloner.scenes.films.hearing import RATE_HZ, Source

#: So far steps are heard, metres; how loud; how high above the floor; whose are stone make none. As in ``sound.js``.
HEARD_M, LOUD, HIGH_M, STONY = 14.0, 0.5, 0.05, 0.5
#: A heel: its length, seconds; a click and a thud of noise (loudness, decay in seconds); a thump (Hz, loudness, decay).
HEEL_S: Final = 0.14
CLICK, THUD, THUMP = (0.7, 0.006), (0.12, 0.03), (95.0, 0.5, 0.035)
#: Everybody's steps are somewhat higher or lower: from the first, by the second, spread by the golden section.
LOWEST, SPREAD, GOLDEN = 0.85, 0.3, 0.618


def heel_sound() -> Array:
    """Return (N,) the sound of a heel strike at `RATE_HZ`; always the same numbers."""
    dice = Mulberry32(5)
    t = np.arange(int(np.ceil(HEEL_S * RATE_HZ))) / RATE_HZ
    noise = 2.0 * np.array([dice.roll() for _ in t]) - 1.0
    shape = CLICK[0] * np.exp(-t / CLICK[1]) + THUD[0] * np.exp(-t / THUD[1])
    return np.asarray(noise * shape + THUMP[1] * np.sin(2.0 * np.pi * THUMP[0] * t) * np.exp(-t / THUMP[2]))


def footsteps(acted: Acted, staging: Staging, seconds: float) -> list[Source]:
    """Return the footsteps audible in a film of some length."""
    sound, found = heel_sound(), []
    own = {who: _pitched(sound, who) for who in range(len(acted.people))}
    for when, who in sorted(_heel_strikes(acted)):
        if when >= seconds:
            break
        rows = staging.rows(acted, when)
        row, (eye, _, _) = rows[who], staging.camera(rows, when)
        place = np.array([row[0, 1], row[4, UP] + HIGH_M, row[0, 2]], np.float64)
        if row[0, 0] < GONE and row[4, STONE] <= STONY and np.linalg.norm(place - eye) <= HEARD_M:
            found.append(Source(when, who, own[who], place))
    return found


def _heel_strikes(acted: Acted) -> list[tuple[float, int]]:
    """Return the times of heel strikes by person: the beginnings of walking footings except the first."""
    found = []
    for who in range(len(acted.people)):
        rows = acted.footings[acted.starts[who] : acted.starts[who + 1]][1:]
        found += [(float(row[FROM]), who) for row in rows if row[LAST] >= 0.0]
    return found


def _pitched(sound: Array, who: int) -> Array:
    """Return a sound played at a person's step frequency."""
    rate = LOWEST + SPREAD * (GOLDEN * who % 1.0)
    at = np.arange(0.0, len(sound) - 1.0, rate)
    return np.asarray(LOUD * np.interp(at, np.arange(len(sound)), sound))
