"""Materials of statues: colour and shine of stone, clay, bronze and marble.

All colours and shares are taste, held against photographs of weathered sandstone, fired terracotta, bronze in the open
and white marble; the roughness and the split into metal and patina follow glTF's metallic-roughness model.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.easing import smoothstep
from cloner.records.arrays import Array
from cloner.statues.noise import MaterialBlock

Values = NDArray[np.floating]


@dataclass(frozen=True, slots=True, eq=False)
class Look:
    """What N places of a surface look like.

    Attributes
    ----------
    rgb : (N, 3) levels, sRGB
    rough, metal : (N,) in 0..1
    """

    rgb: Values
    rough: Values
    metal: Values


#: Makes the look of places (N, 3), metres, in a block, which lie (N,) -1 (on a ridge) to 1 (in a hollow).
Maker = Callable[[MaterialBlock, Array, Values], Look]


def stone(block: MaterialBlock, places_m: Array, hollow: Values) -> Look:
    """Return weathered sandstone: grain, blotches, pores, dirt in the hollows, worn ridges."""
    light = 0.075 * block.waves(places_m, (0.0022, 0.004)) + 0.05 * block.waves(places_m, (0.02, 0.06))
    ragged = np.clip(0.55 + 0.45 * block.waves(places_m, (0.0025, 0.0012)), 0.0, 1.0)
    pore = ragged * np.maximum(block.pores(places_m, 0.007, 0.3), block.pores(places_m, 0.018, 0.12))
    warm = 0.012 * block.waves(places_m, (0.15,))
    dirt = np.clip(hollow, 0.0, 1.0) * (1.0 + 0.5 * block.waves(places_m, (0.03, 0.008)))
    rgb = _tinted((158.0, 150.0, 135.0), light + 0.10 * np.clip(-hollow, 0.0, 1.0), warm)
    rgb = _mixed(rgb, (74.0, 68.0, 58.0), 0.55 * dirt)
    rgb *= (1.0 - 0.45 * _step(pore, 0.0, 0.5))[:, None]
    return Look(rgb, 0.90 + 0.05 * np.tanh(light * 8.0), np.zeros(len(rgb), np.float32))


def clay(block: MaterialBlock, places_m: Array, hollow: Values) -> Look:
    """Return fired terracotta: uneven firing, small inclusions, pale earth left in the hollows."""
    light = 0.03 * block.waves(places_m, (0.0025, 0.005)) + 0.05 * block.waves(places_m, (0.05, 0.14))
    warm = 0.015 * block.waves(places_m, (0.09,))
    earth = np.clip(hollow, 0.0, 1.0) * (0.8 + 0.4 * block.waves(places_m, (0.015, 0.05)))
    rgb = _tinted((150.0, 116.0, 93.0), light + 0.06 * np.clip(-hollow, 0.0, 1.0), warm)
    rgb = _mixed(rgb, (88.0, 68.0, 56.0), 0.6 * np.clip(hollow, 0.0, 1.0))
    rgb = _mixed(rgb, (178.0, 160.0, 136.0), 0.35 * earth)
    rgb *= (1.0 - 0.3 * _step(block.pores(places_m, 0.010, 0.12), 0.0, 0.5))[:, None]
    return Look(rgb, 0.92 + 0.04 * np.tanh(light * 8.0), np.zeros(len(rgb), np.float32))


def bronze(block: MaterialBlock, places_m: Array, hollow: Values) -> Look:
    """Return bronze from the open: brown, green where water stays, bright where hands and rain rub it."""
    light = 0.05 * block.waves(places_m, (0.003, 0.01, 0.04))
    spread = 0.7 * hollow + 0.3 * block.waves(places_m, (0.004, 0.012, 0.03, 0.09)) - 0.03
    green = _step(spread, 0.0, 0.75)
    rubbed = _step(-hollow, 0.15, 0.8) * (1.0 - green)
    rgb = _tinted((104.0, 76.0, 50.0), light, 0.02 * block.waves(places_m, (0.07,)))
    rgb = _mixed(rgb, (164.0, 122.0, 72.0), 0.75 * rubbed)
    patina = _tinted((96.0, 121.0, 104.0), 2.0 * light, np.zeros_like(light))
    rgb += green[:, None] * (patina - rgb)
    rgb *= (1.0 - 0.35 * np.clip(hollow - 0.3, 0.0, 1.0))[:, None]
    return Look(rgb, 0.46 - 0.14 * rubbed + 0.42 * green, 1.0 - green)


def marble(block: MaterialBlock, places_m: Array, hollow: Values) -> Look:
    """Return white marble: clouds, thin grey veins along bent planes, a little dust in the hollows."""
    bend = block.waves(places_m, (0.18,)) + 0.16 * block.waves(places_m, (0.02, 0.05))
    across = np.asarray(places_m @ np.array([5.2, 3.1, 4.0]), np.float32)  # a vein every 15 cm or so
    vein = (1.0 - np.abs(np.sin(np.pi * (across + 0.55 * bend)))) ** 14
    vein *= _step(block.waves(places_m, (0.11,)), -0.3, 1.0)
    light = 0.012 * block.waves(places_m, (0.002,)) + 0.03 * block.waves(places_m, (0.06, 0.15))
    rgb = _tinted((222.0, 217.0, 207.0), light, np.zeros_like(light))
    rgb = _mixed(rgb, (138.0, 138.0, 140.0), 0.6 * vein)
    rgb = _mixed(rgb, (132.0, 116.0, 94.0), 0.5 * np.clip(hollow, 0.0, 1.0))
    return Look(rgb, 0.34 + 0.3 * np.clip(hollow, 0.0, 1.0), np.zeros(len(rgb), np.float32))


MATERIALS: Final[Mapping[str, Maker]] = MappingProxyType(
    {"stone": stone, "clay": clay, "bronze": bronze, "marble": marble}
)


def _tinted(rgb: tuple[float, float, float], light: Values, warm: Values) -> Values:
    """Return a colour (N, 3) lightened (N,) and yellowed (N,) by shares."""
    tint = warm[:, None] * np.array([1.0, 0.2, -1.4], np.float32)
    return np.asarray(np.array(rgb, np.float32) * (1.0 + light[:, None] + tint), np.float32)


def _mixed(rgb: Values, other: tuple[float, float, float], share: Values) -> Values:
    return rgb + np.clip(share, 0.0, 1.0)[:, None] * (np.array(other, np.float32) - rgb)


def _step(values: Values, low: float, high: float) -> Values:
    """Return a smooth step from 0 at `low` to 1 at `high`."""
    return smoothstep(values, low, high).astype(np.float32)
