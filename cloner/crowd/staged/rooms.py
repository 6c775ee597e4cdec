"""A lit room for a pack's clones: its triangles, light map, and light probes for people.

``room.bin`` holds arrays; ``room_looks.webp`` textures one below another; ``room_light.webp`` the light map without the
sun's own light, sRGB, white standing for ``brightest``; ``room_sun.webp`` how much of the sun falls there, so that
people can stand in its way. ``cloner scene build`` writes them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array

ROOM_FILE, LOOKS_FILE, LIGHT_FILE = "room.bin", "room_looks.webp", "room_light.webp"
SUN_FILE: Final = "room_sun.webp"
ROOM_FILES: Final = (ROOM_FILE, LOOKS_FILE, LIGHT_FILE, SUN_FILE)
#: How the room sounds on its largest floor, where that was worked out.
ECHO_FILE: Final = "room_echo.wav"
#: Texels that a person's light has: c0 and c of red, green and blue; how much of the sun is seen.
GLOW: Final = 4
#: People are lit as their chests are, metres.
CHEST_M: Final = 1.1


@dataclass(frozen=True, slots=True, eq=False)
class Probes:
    """Probes on a grid.

    Attributes
    ----------
    low : (3,) the first probe's place, metres; heights, (H,) of the levels
    step : metres along X and Z
    light : (H, nz, nx, 3, 4) c0, c of each colour: a surface of unit normal n gets E(n) = c0 + c . n
    sun : (H, nz, nx) share of the sun that is seen
    """

    low: Array
    heights: Array
    step: float
    light: NDArray[np.float32]
    sun: NDArray[np.float32]


@dataclass(frozen=True, slots=True, eq=False)
class LitRoom:
    """What is drawn: (3 T, 8) corners (position, uv, light-map uv, look); pictures (H, W, 3); the
    sun's share (H, W).
    """

    corners: NDArray[np.float32]
    looks: NDArray[np.uint8]
    light: NDArray[np.uint8]
    sun: NDArray[np.uint8]
    probes: Probes
    facts: Mapping[str, Any]


def light_at(probes: Probes, places: Array) -> tuple[Array, Array]:
    """Return the (N, 3, 4) light and (N,) sun at (N, 3) points, trilinear between the eight probes around."""
    levels = np.interp(places[:, 1], probes.heights, np.arange(len(probes.heights)))
    across = (places[:, [2, 0]] - probes.low[[2, 0]]) / probes.step
    shape = np.array(probes.sun.shape)
    at = np.clip(np.column_stack([levels, across]), 0.0, shape - 1.0)
    first = np.minimum(at.astype(int), np.maximum(shape - 2, 0))
    share = at - first
    light, sun = np.zeros((len(places), 3, 4)), np.zeros(len(places))
    for corner in np.ndindex(2, 2, 2):
        index = tuple(np.minimum(first + corner, shape - 1).T)
        weight = np.where(corner, share, 1.0 - share).prod(axis=1)
        light += weight[:, None, None] * probes.light[index]
        sun += weight * probes.sun[index]
    return light, sun


def people_light(probes: Probes, rows: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the (N, GLOW, 4) light of people at the positions in their (N, 5, 4) rows."""
    places = np.column_stack([rows[:, 0, 1], CHEST_M + rows[:, 4, 2], rows[:, 0, 2]]).astype(np.float64)
    light, sun = light_at(probes, places)
    glow = np.zeros((len(rows), GLOW, 4), np.float32)
    glow[:, :3], glow[:, 3, 0] = light, sun
    return glow
