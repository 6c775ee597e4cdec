"""Room lighting for the renderers: exposure, sky, and the sun's shadow camera.

``web/room.js`` does the same, number for number. Lights are irradiances, 1 shows a white surface white.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from cloner.crowd.staged.eye import CrowdCamera
from cloner.crowd.staged.rooms import CHEST_M, Probes, light_at
from cloner.records.arrays import Array

#: Shares of red, green and blue in how bright a colour is (ITU-R BT.709).
LUMA: Final = np.array([0.2126, 0.7152, 0.0722])
#: A white thing in average light is shown this bright; taste.
KEY: Final = 0.85
#: The eye gets used to so much of a change of light: rooms stay darker than squares, nights darker than days; taste.
ADAPTS, ADAPTS_TO_NIGHT, ADAPTS_TO_COLOUR = 0.8, 0.35, 0.5
#: Where ahead of the eye the light is looked at, metres; no place counts as darker than this.
AHEAD_M: Final = (0.0, 1.5, 3.0)
DARKEST: Final = 0.02
#: Shadows of people are seen within so many metres around a place so far ahead of the eye; texels of their map.
CAST_M, CAST_AHEAD_M, CAST_PX = 9.0, 6.0, 1536
#: Nobody who stands in the way is farther from there towards the sun, metres.
CAST_DEEP_M: Final = 40.0


@dataclass(frozen=True, slots=True)
class RoomLight:
    """A room's lighting at a time: a factor of its light, stars, additional exposure (stops), and a lantern.

    ``lantern`` is x, y, z and radius, metres (radius 0: none), ``lantern_light`` what it gives at one metre.
    """

    daylight: tuple[float, float, float] = (1.0, 1.0, 1.0)
    stars: float = 0.0
    stops: float = 0.0
    lantern: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    lantern_light: tuple[float, float, float] = (0.0, 0.0, 0.0)


DAY: Final = RoomLight()


def room_values(probes: Probes, data: Mapping[str, Any], eye: CrowdCamera, hour: RoomLight) -> dict[str, Any]:
    """Return the uniforms of everything that is drawn in a room."""
    right, up, back = eye.axes()
    wide, tall = (size / 2.0 / eye.focal_px for size in eye.size_px)
    values = {
        "roomed": 1, "sunWay": tuple(data["sun_way"]), "sunLight": tuple(data["sun_light"]),
        "skyLight": tuple(data["sky_light"]), "groundColour": tuple(data["ground"]),
        "brightest": float(data["brightest"]), "daylight": hour.daylight, "starry": hour.stars,
        "exposure": exposure(probes, data, eye.place_m, -back, hour),
        "lantern": hour.lantern, "lanternLight": hour.lantern_light,
        "skyAhead": tuple(-back), "skyRight": tuple(right * wide), "skyUp": tuple(up * tall),
    }  # fmt: skip
    return values | ({"shadowed": 1, "shadowFromWorld": sun_clip(data, eye.place_m, -back)} if any(data["sun_light"])
                     else {})  # fmt: skip


def exposure(probes: Probes, data: Mapping[str, Any], place: Array, ahead: Array, hour: RoomLight) -> tuple[float, ...]:
    """Return the factors of red, green and blue for a camera that looks ahead from a point."""
    level_way = ahead * (1.0, 0.0, 1.0) / max(float(np.hypot(ahead[0], ahead[2])), 1e-6)
    places = np.array([[place[0], CHEST_M, place[2]] + level_way * far for far in AHEAD_M])
    light, sun = light_at(probes, places)
    around = light[:, :, 0] + 0.25 * sun[:, None] * np.array(data["sun_light"])  # a ball gets a quarter of the sun
    colour = np.exp(np.log(np.maximum(around, DARKEST)).mean(axis=0))
    level, day = float(colour @ LUMA), max(float(np.array(hour.daylight) @ LUMA), 1e-4)
    gain = (KEY / level) ** ADAPTS / day**ADAPTS_TO_NIGHT * 2.0**hour.stops
    return tuple((gain * (level / colour) ** ADAPTS_TO_COLOUR).tolist())


def sun_clip(data: Mapping[str, Any], place: Array, ahead: Array) -> Array:
    """Return the (4, 4) matrix to the clip space of the sun's shadow map of who stands before a camera."""
    way = np.array(data["sun_way"], float)
    right = np.cross([0.0, 0.0, 1.0] if abs(way[2]) < 0.9 else [1.0, 0.0, 0.0], way)
    right /= np.linalg.norm(right)
    up = np.cross(way, right)
    level_way = ahead * (1.0, 0.0, 1.0) / max(float(np.hypot(ahead[0], ahead[2])), 1e-6)
    middle = np.array([place[0], 0.0, place[2]]) + level_way * CAST_AHEAD_M
    step = 2.0 * CAST_M / CAST_PX
    out = np.zeros((4, 4))
    for row, axis in ((0, right), (1, up)):
        out[row, :3] = axis / CAST_M
        out[row, 3] = -np.floor(float(axis @ middle) / step) * step / CAST_M  # whole texels: edges do not swim
    out[2, :3], out[2, 3], out[3, 3] = -way / CAST_DEEP_M, float(way @ middle) / CAST_DEEP_M, 1.0
    return out
