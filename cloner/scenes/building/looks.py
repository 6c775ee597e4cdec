"""Appearance of floors, walls and blocks: procedural textures and photos."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from cloner.records.arrays import Array

SIDE_PX: Final = 256  # taste: of a texture that repeats every few metres
#: Metres that a texture's side spans, and its mean colour (sRGB 0..1).
_BASE: Final[dict[str, tuple[float, tuple[float, float, float]]]] = {
    "flags": (2.0, (0.62, 0.58, 0.52)),
    "cobbles": (1.0, (0.50, 0.49, 0.47)),
    "plaster": (2.0, (0.80, 0.77, 0.71)),
    "stone": (2.0, (0.69, 0.65, 0.58)),
    "timber": (1.0, (0.47, 0.35, 0.24)),
    "marble": (1.0, (0.86, 0.84, 0.81)),
    "earth": (2.0, (0.56, 0.43, 0.31)),
    "white": (1.0, (1.0, 1.0, 1.0)),
}


LOOKS: Final = tuple(_BASE)
#: A page's textures have one side, at most so many texels, and lie one below another in a WebP, which has no more rows.
LARGEST_SIDE_PX, MOST_ROWS = 1024, 16383


@dataclass(frozen=True, slots=True, eq=False)
class Look:
    """A repeating texture.

    Attributes
    ----------
    pixels : (H, W, 3) sRGB
    span_m : how wide and high it is, metres
    albedo : (3,) mean share of light that it gives back, linear
    fits : whether it begins at each surface's own lower left corner, as photos do, instead of the plan's
    """

    pixels: NDArray[np.uint8]
    span_m: tuple[float, float]
    albedo: Array
    fits: bool = False


@cache
def procedural_look(name: str) -> Look:
    """Return one of the procedural looks."""
    pixels, span = texture(name), _BASE[name][0]
    return Look(pixels, (span, span), np.full(3, 0.8) if name == "white" else mean_albedo(pixels))


def mean_albedo(pixels: NDArray[np.uint8]) -> Array:
    """Return the (3,) mean linear albedo of (H, W, 3) sRGB pixels."""
    return np.asarray(((pixels / 255.0) ** 2.2).mean(axis=(0, 1)))


def texture_sheet(found: Sequence[Look]) -> NDArray[np.uint8]:
    """Return textures stacked vertically as squares of one size: the procedural ones', or larger with photos."""
    side, wanted = SIDE_PX, max(max(one.pixels.shape[:2]) for one in found)
    while side < min(wanted, LARGEST_SIDE_PX) and 2 * side * len(found) <= MOST_ROWS:
        side *= 2
    return np.concatenate([_resized_tile(one.pixels, side) for one in found])


def _resized_tile(pixels: NDArray[np.uint8], side: int) -> NDArray[np.uint8]:
    """Return a resized texture that still repeats without a seam."""
    tall, wide = pixels.shape[:2]
    if (tall, wide) == (side, side):
        return pixels
    scale = np.array([wide, tall]) / side
    at = np.arange(side) + 0.5
    if scale.max() > 1.0:
        return np.asarray(cv2.resize(pixels, (side, side), interpolation=cv2.INTER_AREA))
    x, y = np.meshgrid(at * scale[0] - 0.5, at * scale[1] - 0.5)
    return np.asarray(
        cv2.remap(pixels, x.astype(np.float32), y.astype(np.float32), cv2.INTER_LINEAR, borderMode=cv2.BORDER_WRAP)
    )


def texture(look: str) -> NDArray[np.uint8]:
    """Return a look's (SIDE_PX, SIDE_PX, 3) sRGB texture, which repeats without a seam."""
    base = np.array(_BASE[look][1])
    rng = np.random.default_rng(sum(look.encode()))
    shade = np.ones((SIDE_PX, SIDE_PX))
    y, x = np.mgrid[0:SIDE_PX, 0:SIDE_PX] / SIDE_PX
    fine, broad = _noise(rng, 1.2), _noise(rng, 14.0)
    if look == "flags":
        shade += 0.05 * fine + 0.05 * broad + _tiles(rng, x, y, 2, 2, 0.07) - 0.35 * _joints(x, y, 2, 2, 0.006)
    elif look == "cobbles":
        shade += 0.08 * fine + _tiles(rng, x, y, 8, 8, 0.12) - 0.5 * _joints(x, y, 8, 8, 0.012)
    elif look == "plaster":
        shade += 0.015 * fine + 0.012 * broad
    elif look == "stone":
        shade += 0.04 * fine + 0.04 * broad + _tiles(rng, x, y, 2, 4, 0.05) - 0.22 * _joints(x, y, 2, 4, 0.004)
    elif look == "timber":
        grain = gaussian_filter(rng.normal(size=(SIDE_PX, SIDE_PX)), (20.0, 0.8), mode="wrap")
        shade += 0.1 * grain / grain.std() + _tiles(rng, x, y, 5, 1, 0.1) - 0.5 * _joints(x, y, 5, 1, 0.008)
    elif look == "earth":
        lumps = np.maximum(_noise(rng, 5.0), 0.0)
        shade += 0.06 * fine + 0.05 * broad + 0.05 * lumps - 0.12 * (_noise(rng, 2.5) > 1.9)
    elif look == "marble":
        vein = np.abs(np.sin(np.pi * (2 * x + 2 * y) + 1.5 * broad))
        shade -= 0.12 * np.exp(-8.0 * vein) - 0.02 * fine
    return np.asarray(np.clip(base * shade[..., None] * 255.0 + 0.5, 0, 255).astype(np.uint8))


def _noise(rng: np.random.Generator, sigma: float) -> Array:
    made = gaussian_filter(rng.normal(size=(SIDE_PX, SIDE_PX)), sigma, mode="wrap")
    return np.asarray(made / made.std())


def _tiles(rng: np.random.Generator, x: Array, y: Array, across: int, down: int, spread: float) -> Array:
    """Return each tile's own shade; every second row is offset by half a tile."""
    row = np.minimum((y * down).astype(int), down - 1)
    column = ((x * across + 0.5 * (row % 2)) % across).astype(int) % across
    return np.asarray(rng.normal(0.0, spread, (down, across))[row, column])


def _joints(x: Array, y: Array, across: int, down: int, wide: float) -> Array:
    row = np.minimum((y * down).astype(int), down - 1)
    u, v = (x * across + 0.5 * (row % 2)) % 1.0, (y * down) % 1.0
    near = np.minimum(np.minimum(u, 1.0 - u) / across, np.minimum(v, 1.0 - v) / down)
    if down == 1:
        near = np.minimum(u, 1.0 - u) / across
    return np.asarray(np.clip(1.5 - near / wide, 0.0, 1.0))
