"""Positions and looks of people who stand, walk and sit: the same rules as ``web/scene.js``, number for number.

Paths are closed formulas of time, so that the shaders place everybody: lanes along Z, rings around the middle, seats.
Neighbouring lanes and rings take their clones from three different classes, so the same clone never comes near itself.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

SCENES: Final = ("walk", "plaza", "stadium")
#: The scene of a pack that acts a scenario: see `footing`.
ACTED: Final = "scenario"
LANE_M: Final = 0.85
ALONG_M: Final = 1.8
RING_FROM_M: Final = 6.0  # smaller rings would turn a standing foot by more than a centimetre
RING_M: Final = 0.95
SEAT_M: Final = 0.56
ROW_M: Final = 0.85
ROW_UP_M: Final = 0.42
STAND_FROM_M: Final = 24.0
AISLE_M: Final = 2.6
CLASSES: Final = 3
#: Clones from which on every class has enough of them.
ENOUGH: Final = 9
#: From so many in a row on they change places; the same clone then comes again after one place fewer at the earliest.
MIXED: Final = 5
PERSON_TEXELS: Final = 5
WALK, IDLE, SIT = 0, 1, 2
_MASK: Final = 0xFFFFFFFF


class Mulberry32:
    """The Mulberry32 random generator: 32 bits of state, the same numbers in every language."""

    def __init__(self, seed: int) -> None:
        self._state = seed & _MASK

    def roll(self) -> float:
        """Return the next number, 0 <= x < 1."""
        self._state = (self._state + 0x6D2B79F5) & _MASK
        t = self._state
        t = ((t ^ (t >> 15)) * (1 | t)) & _MASK
        t = (((t + (((t ^ (t >> 7)) * (61 | t)) & _MASK)) & _MASK) ^ t) & _MASK
        return ((t ^ (t >> 14)) & _MASK) / 4294967296.0

    def pick(self, count: int) -> int:
        """Return an integer, 0 <= k < count."""
        return min(int(self.roll() * count), count - 1)


@dataclass(frozen=True, slots=True, eq=False)
class Casting:
    """What the rules know of the clones.

    Attributes
    ----------
    clones : int
    palettes : mapping of "top", "bottom", "shoes", "hair" to colours 0xRRGGBB; an empty one dyes nobody
    wardrobe : mapping of garment to a list a clone of the clones whose garment it can wear
    own_share, dyed_share : of people in their own clothes, and in dyed ones; the rest wears others' garments
    """

    clones: int
    palettes: Mapping[str, Sequence[int]]
    wardrobe: Mapping[str, Sequence[Sequence[int]]]
    own_share: float = 0.3
    dyed_share: float = 0.45


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """People ready for the shaders.

    Attributes
    ----------
    rows : (N, 5, 4) float32
    lane_m : float
        Length of the lanes.
    """

    rows: NDArray[np.float32]
    lane_m: float


def make_scene(name: str, people: int, casting: Casting, seed: int = 1) -> Scene:
    """Return a number of people in a scene of `SCENES`.

    Raises
    ------
    KeyError
        If there is no such scene.
    """
    maker = {"walk": _walk, "plaza": _plaza, "stadium": _stadium}[name]
    return maker(people, casting, Mulberry32(seed))


def _walk(people: int, casting: Casting, dice: Mulberry32) -> Scene:
    lane_m = max(40.0, math.ceil(math.sqrt(people * LANE_M * ALONG_M) * 1.2))
    each = math.floor(lane_m / ALONG_M)
    lanes = math.ceil(people / each)
    rows: list[list[float]] = []
    for lane in range(lanes):
        order = _order(lane, casting, dice)
        speed = 1.15 + 0.35 * dice.roll()
        way = 1.0 if (lane // 3) % 2 == 0 else -1.0
        shift = dice.roll() * lane_m
        for k in range(min(each, people - len(rows) // PERSON_TEXELS)):
            start = shift + k * lane_m / each + (dice.roll() - 0.5) * 0.5
            x = (lane - (lanes - 1) / 2.0) * LANE_M + (dice.roll() - 0.5) * 0.1
            _add(rows, [1.0, x, start, way], speed, order[k % len(order)], WALK, 0.0, casting, dice)
    return _scene(rows, lane_m)


def _plaza(people: int, casting: Casting, dice: Mulberry32) -> Scene:
    rows: list[list[float]] = []
    ring = 0
    while len(rows) // PERSON_TEXELS < people:
        radius = RING_FROM_M + RING_M * ring
        order = _order(ring, casting, dice)
        speed = 1.15 + 0.35 * dice.roll()
        way = 1.0 if (ring // 2) % 2 == 0 else -1.0
        stands = ring % 4 == 3
        each = math.floor(2.0 * math.pi * radius / ALONG_M)
        each -= each % len(order) if each >= len(order) else 0  # else a clone meets itself where the ring closes
        for k in range(min(each, people - len(rows) // PERSON_TEXELS)):
            angle = (k + (dice.roll() - 0.5) * 0.3) * 2.0 * math.pi / each
            if stands:
                heading = dice.roll() * 2.0 * math.pi
                path = [0.0, radius * math.sin(angle), radius * math.cos(angle), heading]
                _add(rows, path, 0.0, order[k % len(order)], IDLE, 0.0, casting, dice)
            else:
                _add(rows, [2.0, radius, angle, way], speed, order[k % len(order)], WALK, 0.0, casting, dice)
        ring += 1
    return _scene(rows, 100.0)


def _stadium(people: int, casting: Casting, dice: Mulberry32) -> Scene:
    rows: list[list[float]] = []
    rises = max(8, math.ceil(math.sqrt(people) / 4.0))
    row = 0
    while len(rows) // PERSON_TEXELS < people:
        tier, level = row // rises, row % rises
        radius = STAND_FROM_M + ROW_M * level
        order = _order(level, casting, dice)
        arc = 2.0 * math.pi / 3.0 - AISLE_M / radius
        each = math.floor(arc * radius / SEAT_M)
        for k in range(min(each, people - len(rows) // PERSON_TEXELS)):
            _mixed(order, k, dice)
            angle = math.pi - arc / 2.0 + (k + 0.5) * arc / each + tier * 2.0 * math.pi / 3.0
            path = [
                0.0,
                radius * math.sin(angle),
                radius * math.cos(angle),
                angle + math.pi + (dice.roll() - 0.5) * 0.3,
            ]
            clip = IDLE if dice.roll() < 0.15 else SIT
            _add(rows, path, 0.0, order[k % len(order)], clip, ROW_UP_M * level, casting, dice)
        row += 1
    return _scene(rows, 100.0)


def _order(line: int, casting: Casting, dice: Mulberry32) -> list[int]:
    """Return the clones of a lane, ring or row in repeating order."""
    own = [c for c in range(casting.clones) if casting.clones < ENOUGH or c % CLASSES == line % CLASSES]
    for k in range(len(own) - 1, 0, -1):
        other = dice.pick(k + 1)
        own[k], own[other] = own[other], own[k]
    return own


def _mixed(order: list[int], k: int, dice: Mulberry32) -> None:
    """Exchange some neighbours after each repetition, as repeated rows are conspicuous.

    Rings and lanes close, and a clone would meet itself there.
    """
    if k and k % len(order) == 0 and len(order) >= MIXED:
        for j in range(k // len(order) % 2, len(order) - 1, 2):
            if dice.roll() < 0.5:
                order[j], order[j + 1] = order[j + 1], order[j]


def _add(
    rows: list[list[float]],
    path: list[float],
    speed: float,
    clone: int,
    clip: int,
    up: float,
    casting: Casting,
    dice: Mulberry32,
) -> None:
    scale = random_scale(dice)
    phase = dice.roll()
    donors, dyes = random_look(clone, casting, dice)
    rows += [path, [speed, phase, clone, scale], [*donors, clip], dyes, [up, 0.0, 0.0, 0.0]]


def random_scale(dice: Mulberry32) -> float:
    """Return a person's size relative to the clone."""
    return 0.96 + 0.08 * dice.roll()


def random_look(clone: int, casting: Casting, dice: Mulberry32) -> tuple[list[float], list[float]]:
    """Return whose top, bottom and shoes a person wears, and the dyes of top, bottom, shoes and hair or -1."""
    donors, dyes = [float(clone)] * 3, [-1.0] * 4
    kind = dice.roll()
    for k, garment in enumerate(("top", "bottom", "shoes")):
        first, second = dice.roll(), dice.roll()
        palette, others = casting.palettes.get(garment, ()), casting.wardrobe.get(garment, ())
        if casting.own_share <= kind < casting.own_share + casting.dyed_share:
            if palette and (k == 0 or first < 0.6):
                dyes[k] = float(palette[min(int(second * len(palette)), len(palette) - 1)])
        elif kind >= casting.own_share and others and others[clone] and (k == 0 or first < 0.5):
            donors[k] = float(others[clone][min(int(second * len(others[clone])), len(others[clone]) - 1)])
    first, second = dice.roll(), dice.roll()
    hair = casting.palettes.get("hair", ())
    if hair and first < 0.5:
        dyes[3] = float(hair[min(int(second * len(hair)), len(hair) - 1)])
    return donors, dyes


def _scene(rows: list[list[float]], lane_m: float) -> Scene:
    return Scene(np.array(rows, np.float32).reshape(-1, PERSON_TEXELS, 4), lane_m)


def places_at(scene: Scene, now: float) -> NDArray[np.float64]:
    """Return (N, 3) everybody's position at a time, metres; as ``common.glsl`` does."""
    path, pace, up = (scene.rows[:, k].astype(np.float64) for k in (0, 1, 4))
    out = np.column_stack([path[:, 1], up[:, 0], path[:, 2]])
    lane = path[:, 0] == 1.0
    along = np.mod(path[:, 2] + pace[:, 0] * now, scene.lane_m)
    out[lane, 2] = (path[:, 3] * (along - scene.lane_m / 2.0))[lane]
    ring = path[:, 0] == 2.0
    angle = path[:, 2] + path[:, 3] * pace[:, 0] * now / np.where(ring, path[:, 1], 1.0)
    out[ring, 0] = (path[:, 1] * np.sin(angle))[ring]
    out[ring, 2] = (path[:, 1] * np.cos(angle))[ring]
    return out


def looks_shown(scene: Scene) -> int:
    """Return the number of different looks: clone, whose garments, dyes."""
    looks = np.column_stack([scene.rows[:, 1, 2], scene.rows[:, 2, :3], scene.rows[:, 3]])
    return len(np.unique(looks, axis=0))


def facts(casting: Casting) -> dict[str, Any]:
    """Return a casting as JSON values."""
    return {
        "clones": casting.clones, "palettes": {k: list(v) for k, v in casting.palettes.items()},
        "wardrobe": {k: [list(one) for one in v] for k, v in casting.wardrobe.items()},
        "own_share": casting.own_share, "dyed_share": casting.dyed_share,
    }  # fmt: skip
