"""A pack's staging: who is a statue when, cameras and cuts, light, captions; ``staging.js`` plays the same.

All is told by keys: rows of a time and values, eased from one to the next, held before the first and after the last.
Frames are the page's: metres, Y up; times are seconds of the pack's own clock.
"""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from cloner.crowd.staged.daylight import RoomLight
from cloner.crowd.staged.footing import GONE, Acted, people_at
from cloner.easing import smoothstep
from cloner.records.arrays import Array

Place = tuple[float, float, float]
Keys = Sequence[Sequence[float]]

#: Columns of a person's last texel: stone 0..1, height above the floor (metres), which part is there.
STONE, UP, PART = 1, 2, 3
HEADLESS, HEAD_ALONE = 1.0, 2.0
#: Heights of the middle of a head and of the eyes, shares of the stature; the shader turns heads about the first.
HEAD_MIDDLE, EYES = 0.93, 0.93


def eased_value(keys: Keys, now: float) -> Array:
    """Return (k,) the values at a time of keys of k + 1 numbers."""
    rows = np.array(keys, np.float64)
    after = int(np.searchsorted(rows[:, 0], now, side="right"))
    if after in (0, len(rows)):
        return np.asarray(rows[max(after - 1, 0), 1:])
    first, last = rows[after - 1], rows[after]
    share = (now - first[0]) / (last[0] - first[0])
    return np.asarray(first[1:] + (last[1:] - first[1:]) * smoothstep(share))


class Staging:
    """The contents of ``staging`` in ``crowd.json``."""

    def __init__(self, data: Mapping[str, Any], statures_m: Sequence[float]) -> None:
        self._told, self._statures = data, np.array(statures_m)

    def rows(self, acted: Acted, now: float) -> NDArray[np.float32]:
        """Return everybody's staged rows at a time, as :func:`cloner.crowd.staged.footing.people_at`."""
        staging = self._told
        times = np.full(len(acted.people), now)
        for who, wakes in staging["wakes"]:
            times[who] = max(times[who], wakes)
        for who, hardens in staging["hardens"]:
            times[who] = min(times[who], hardens)
        rows = people_at(acted, times)
        for name, column in (("stone", STONE), ("up", UP)):
            for who, keys in staging[name]:
                rows[who, 4, column] = eased_value(keys, now)[0]
        for head in staging["heads"]:
            body, own = rows[head["of"]], rows[head["who"]]
            if now >= head["until"]:
                own[0, 0] = GONE
                continue
            x, y, z, heading, lean = eased_value(head["path"], now)
            middle = HEAD_MIDDLE * self._statures[int(own[1, 2])] * own[1, 3]
            own[0, 1:], own[4, UP], own[4, PART] = (x, z, heading), y - middle, HEAD_ALONE + lean % 1.0
            own[4, STONE] = body[4, STONE]
            body[4, PART] = HEADLESS
        return rows

    def hour(self, now: float) -> RoomLight:
        """Return the room's lighting at a time."""
        staging = self._told
        lantern = eased_value(staging["lantern"], now)
        light, at = lantern[3:], lantern[:3]
        return RoomLight(
            tuple(eased_value(staging["light"], now).tolist()), float(eased_value(staging["stars"], now)[0]),
            float(eased_value(staging["stops"], now)[0]), (*at.tolist(), LANTERN_M if light.any() else 0.0),
            tuple(light.tolist()),
        )  # fmt: skip

    def camera(self, rows: NDArray[np.float32], now: float) -> tuple[Place, Place, float]:
        """Return the camera's position, its target, and its vertical field of view, degrees."""
        shots = self._told["shots"]
        keys = next((one for one in reversed(shots) if now >= one[0][0]), shots[0])
        plain = [[key[0], *key[1:4], *self._look(key, rows), key[8]] for key in keys]
        found = eased_value(plain, now)
        return tuple(found[:3].tolist()), tuple(found[3:6].tolist()), float(found[6])

    def _look(self, key: Sequence[float], rows: NDArray[np.float32]) -> Array:
        return np.array(key[4:7]) if key[7] < 0 else self.head(rows, int(key[7]))

    def head(self, rows: NDArray[np.float32], who: int) -> Array:
        """Return (3,) the position of a person's eyes."""
        own = rows[who].astype(np.float64)
        return np.array([own[0, 1], own[4, UP] + EYES * self._statures[int(own[1, 2])] * own[1, 3], own[0, 2]])

    def caption(self, now: float) -> str:
        """Return the caption at a time."""
        return next((text for first, last, text in self._told["captions"] if first <= now < last), "")

    def curtain(self, now: float) -> float:
        """Return how far the curtain is open, 0 (dark) to 1."""
        return float(eased_value(self._told["curtain"], now)[0])


def read_staging(facts: Mapping[str, Any]) -> Staging | None:
    """Return a pack's staging, None without one."""
    return Staging(facts["staging"], [row["stature_m"] for row in facts["people"]]) if "staging" in facts else None


def add_caption(shown: NDArray[np.uint8], caption: str, curtain: float) -> NDArray[np.uint8]:
    """Return an (H, W, 3) picture with its caption below, darkened by the curtain."""
    image = Image.fromarray(np.rint(shown * min(max(curtain, 0.0), 1.0)).astype(np.uint8) if curtain < 1.0 else shown)
    if caption:
        size = max(image.height * LETTERS, 9.0)
        pen, letters = ImageDraw.Draw(image), ImageFont.load_default(size)
        where = (image.width / 2.0, image.height * CAPTION_AT)
        pen.multiline_text(where, wrap_caption(caption), CREAM, letters, "mm", align="center",
                           stroke_width=max(round(size / 12), 1), stroke_fill=(0, 0, 0))  # fmt: skip
    return np.asarray(image)


def wrap_caption(text: str) -> str:
    """Return a caption broken into lines that fit."""
    return "\n".join(textwrap.wrap(text, LINE))


#: Captions: height of letters and where their middle is, shares of the picture's; colour; letters a line.
LETTERS, CAPTION_AT, CREAM, LINE = 0.04, 0.9, (240, 232, 214), 56
#: Radius of a lantern, metres.
LANTERN_M: Final = 0.15
#: What is staged where nothing is told.
PLAIN: Final[Mapping[str, Any]] = {
    "wakes": [], "hardens": [], "stone": [], "up": [], "heads": [], "captions": [], "shots": [],
    "light": [[0.0, 1.0, 1.0, 1.0]], "stars": [[0.0, 0.0]], "stops": [[0.0, 0.0]], "curtain": [[0.0, 1.0]],
    "lantern": [[0.0] * 7],
}  # fmt: skip
