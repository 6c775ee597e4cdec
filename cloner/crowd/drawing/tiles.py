"""Rendering of impostor tiles into a page, by the samples of a bake."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones.cast import CrowdClone
from cloner.crowd.clones.stock import BAKED_FROM_M, middle_m
from cloner.crowd.drawing.texels import SAMPLES, downsample_tiles
from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.records.arrays import Array

Pixels = NDArray[np.uint8]

BAKED_LEVEL: Final = 0
BAND: Final = 256  # rows of a page that are drawn at once, for the memory's sake
_NEAR_M: Final = 1.0  # metres before the eye that are drawn from


@dataclass(frozen=True, slots=True, eq=False)
class Tile:
    """One picture of an impostor: a frame of a clip from one direction."""

    clip: int
    frame: int
    axes: Array
    box_m: tuple[float, float, float, float]  # left, bottom, right, top on the plane through the middle
    size: tuple[int, int]


def _people(cast: CrowdClone, tiles: Sequence[Tile]) -> tuple[list[int], NDArray[np.float32]]:
    """Return the row of people for each tile, and the rows: one per pose of each clip."""
    poses = sorted({(tile.clip, tile.frame) for tile in tiles})
    people = np.zeros((len(poses), 5, 4), np.float32)
    for row, (clip, frame) in enumerate(poses):
        people[row, 1] = 0.0, (frame + 0.5) / len(cast.clips[clip].frames), 0.0, 1.0
        people[row, 2] = 0.0, 0.0, 0.0, clip
        people[row, 3] = -1.0
    place = {pose: row for row, pose in enumerate(poses)}
    return [place[tile.clip, tile.frame] for tile in tiles], people


def draw_tiles(
    theatre: CrowdRenderer,
    cast: CrowdClone,
    tiles: Sequence[Tile],
    places: Sequence[tuple[int, int]],
    page: tuple[int, int],
    *,
    fine: bool = False,
) -> tuple[Pixels, Pixels]:
    """Return the page's colours (H, W, 4) and shapes, at full resolution if ``fine``, else half."""
    every = 1 if fine else 2
    colours = np.zeros((page[1], page[0], 4), np.uint8)
    shapes = np.zeros((page[1] // every, page[0] // every, 4), np.uint8)
    size = (page[0] * SAMPLES, BAND * SAMPLES)
    target = theatre.target(size, 2)
    centre = np.array([0.0, middle_m(cast), 0.0])
    rows, people = _people(cast, tiles)
    theatre.send_people(people)
    for first, last in _bands(tiles, places):
        theatre.begin(target, (0.0, 0.0, 0.0, 0.0))
        for tile, (x, y), row in zip(tiles, places, rows, strict=True):
            if not first <= y < last:
                continue
            wide, high = tile.size
            theatre.viewport((x * SAMPLES, size[1] - (y - first + high) * SAMPLES, wide * SAMPLES, high * SAMPLES))
            eye = centre + BAKED_FROM_M * tile.axes[2]
            values = {
                "clipFromWorld": _window(tile, centre), "eye": eye, "tileRight": tile.axes[0], "tileUp": tile.axes[1],
                "tileBack": tile.axes[2], "tileCentre": centre,
            }  # fmt: skip
            theatre.draw_people(BAKED_LEVEL, np.array([[row, 1.0]], np.float32), values, "bake")
        used = (last - first) * SAMPLES
        found = downsample_tiles(theatre.read(target)[:used], theatre.read(target, 1)[:used], every)
        colours[first:last], shapes[first // every : last // every] = found
    return colours, shapes


def _bands(tiles: Sequence[Tile], places: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return the first and the last row of runs of whole shelves that fit ``BAND``."""
    shelves: dict[int, int] = {}
    for tile, (_, y) in zip(tiles, places, strict=True):
        shelves[y] = max(shelves.get(y, 0), y + tile.size[1])
    bands: list[tuple[int, int]] = []
    for first, last in sorted(shelves.items()):
        if bands and last - bands[-1][0] <= BAND:
            bands[-1] = (bands[-1][0], last)
        else:
            bands.append((first, last))
    return bands


def _window(tile: Tile, centre: Array) -> Array:
    """Return the (4, 4) perspective clip space of the tile's box on the plane through the middle."""
    left, bottom, right, top = tile.box_m
    view = np.eye(4)
    view[:3, :3], view[:3, 3] = tile.axes, -tile.axes @ (centre + BAKED_FROM_M * tile.axes[2])
    far, near = 2.0 * BAKED_FROM_M, _NEAR_M
    lens = np.array(
        [
            [2 * BAKED_FROM_M / (right - left), 0, (right + left) / (right - left), 0],
            [0, 2 * BAKED_FROM_M / (top - bottom), (top + bottom) / (top - bottom), 0],
            [0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)],
            [0, 0, -1, 0],
        ]
    )
    return np.asarray(lens @ view)
