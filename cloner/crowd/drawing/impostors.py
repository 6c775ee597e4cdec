"""Impostors: a clone from many directions in every pose, as tiles of colour, coverage, normals and depth.

References
----------
McDonnell et al. 2007 (22 or 40 views, 16 poses, back faces' normals turned, one texel a pixel at the switch); depth
that moves texels to the seen view, 1.5 texels a pixel and perspective at the switch distance were measured better on
clones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from skimage.metrics import structural_similarity

from cloner.crowd.clones.cast import CrowdClone, skin_vertices
from cloner.crowd.clones.clips import Clip
from cloner.crowd.clones.levels import BodyLevels
from cloner.crowd.clones.stock import BAKED_FROM_M, TEXELS_PER_M, BakedClip, CrowdArrays, middle_m
from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.drawing.tiles import Tile, draw_tiles
from cloner.records.arrays import Array

Pixels = NDArray[np.uint8]

PAGE_WIDE: Final = 1024  # one ring of 22 views then is about as tall
_ALIGNED: Final = 4  # two levels of mips stay inside a tile
_MARGIN: Final = 1.25  # texels around the person, for filters and the search of depth
#: Where sides are compared, radians: half-way, straight and half-way behind.
_SIDES: Final = (np.pi / 4, np.pi / 2, 3 * np.pi / 4)
#: Likeness of both sides from which one stands for both. Eight clones have .88 to .96; with those from .9 mirrored the
#: impostors of all have .9855 in the mean (worst .962) at the switch instead of .9900 (.974): the bar is .985.
MIRRORED_FROM: Final = 0.9


@dataclass(frozen=True, slots=True, eq=False)
class Tiles:
    """All impostors of one clone.

    Attributes
    ----------
    rows : (2 T, 4) float32
        Two a tile: place and size in the page, texels; where the person's middle lies in it.
    sets : first tile of each clip, and which views follow
    views : int, around the person
    colours : (H, W, 4) uint8, RGB and coverage
    shapes : (H, W, 4) or (H/2, W/2, 4) uint8: normal x, y in eye axes, depth, code of garment and zone (``bake.frag``)
    """

    rows: NDArray[np.float32]
    sets: tuple[tuple[int, BakedClip], ...]
    views: int
    colours: Pixels
    shapes: Pixels


@dataclass(frozen=True, slots=True)
class BakeSettings:
    """Settings of a bake.

    Attributes
    ----------
    views : int, around the person; even, so that front and back are exact
    mirrored : int
        Views around those whose right side looks like the left one half a cycle later: one side alone is baked. 0:
        nobody's is looked at.
    elevations : radians of the rings
    texels_per_m : float
    fine : bool
        Shapes are as large as colours, for folds of cloth; else half as large.
    """

    views: int = 22
    mirrored: int = 0
    elevations: tuple[float, ...] = (np.radians(5.0),)
    texels_per_m: float = TEXELS_PER_M
    fine: bool = False

    @property
    def page_wide(self) -> int:
        """Width of a page, texels: wider for several rings, as some GPUs limit textures to 4096 rows."""
        return PAGE_WIDE if len(self.elevations) == 1 else 2 * PAGE_WIDE


def baked_views(seen: BakedClip, views: int) -> list[int]:
    """Return the baked views in the order of their tiles."""
    if seen is BakedClip.ALL:
        return list(range(views))
    if seen is BakedClip.LEFT:
        return list(range(views // 2 + 1))
    front = views // 4
    return [*range(front + 1), *range(-front, 0)]


def axes(azimuth: float, elevation: float) -> Array:
    """Return (3, 3) rows right, up and back of a camera at an azimuth (0 in front, positive left) and elevation."""
    s, c, se, ce = np.sin(azimuth), np.cos(azimuth), np.sin(elevation), np.cos(elevation)
    return np.array([[c, 0.0, -s], [-s * se, ce, -c * se], [s * ce, se, c * ce]])


def bake(cast: CrowdClone, body: BodyLevels, held: CrowdArrays, wanted: BakeSettings) -> Tiles:
    """Return the impostors of a clone.

    Parameters
    ----------
    cast : Cast
    body : BodyLevels
    held : Stock
        Of this clone alone.
    wanted : Bake

    Raises
    ------
    ClonerError
        If this machine cannot draw.
    """
    theatre = CrowdRenderer(held)
    try:
        seen = [BakedClip.ALL if clip.around else BakedClip.FRONT for clip in cast.clips]
        views = wanted.views
        if wanted.mirrored:
            likeness = [side_likeness(theatre, cast, body, number, wanted) for number in range(len(cast.clips))]
            seen = [BakedClip.LEFT if one >= MIRRORED_FROM else own for own, one in zip(seen, likeness, strict=True)]
            views = wanted.mirrored if BakedClip.LEFT in seen else wanted.views
        names = [clip.name for clip in cast.clips]
        seen = [seen[names.index(clip.far or clip.name)] for clip in cast.clips]
        tiles, starts = _plan(cast, body, replace(wanted, views=views), seen)
        places, tall = _pack_tiles(tiles, wanted.page_wide)
        colour, shape = draw_tiles(theatre, cast, tiles, places, (wanted.page_wide, tall), fine=wanted.fine)
    finally:
        theatre.close()
    lines = np.zeros((2 * len(tiles), 4), np.float32)
    for k, (tile, (x, y)) in enumerate(zip(tiles, places, strict=True)):
        lines[2 * k] = x, y, *tile.size
        lines[2 * k + 1, :2] = -tile.box_m[0] * wanted.texels_per_m, tile.box_m[3] * wanted.texels_per_m
    return Tiles(lines, tuple(zip(starts, seen, strict=True)), views, colour, shape)


def side_likeness(
    theatre: CrowdRenderer, cast: CrowdClone, body: BodyLevels, number: int, wanted: BakeSettings
) -> float:
    """Return how well a clip's right side matches its left one half a cycle later, mirrored: the worst SSIM of tiles.

    Tecchia et al. 2002 mirror symmetric walkers. Clothes, hair and light in photos are what tells sides apart.
    """
    clip = cast.clips[number]
    if clip.far or not clip.around or clip.poses % 2:
        return 0.0
    clouds, count = _pose_extents(cast, body, clip), len(clip.frames)
    tiles = []
    for azimuth in _SIDES:
        left, right = (axes(direction * azimuth, wanted.elevations[0]) for direction in (1.0, -1.0))
        for pose in range(0, clip.poses, max(clip.poses // 4, 1)):
            frame = pose * (count // clip.poses)
            tile = _tile(number, frame, left, clouds[pose], wanted.texels_per_m)
            low_x, low_y, high_x, high_y = tile.box_m
            box = -high_x, low_y, -low_x, high_y
            tiles += [tile, replace(tile, frame=(frame + count // 2) % count, axes=right, box_m=box)]
    places, tall = _pack_tiles(tiles, wanted.page_wide)
    page, _ = draw_tiles(theatre, cast, tiles, places, (wanted.page_wide, tall))
    shown = [
        _on_grey(page[y : y + tile.size[1], x : x + tile.size[0]]) for tile, (x, y) in zip(tiles, places, strict=True)
    ]
    return min(
        float(structural_similarity(left, right[:, ::-1], channel_axis=2, data_range=255.0))
        for left, right in zip(shown[::2], shown[1::2], strict=True)
    )


def _on_grey(rgba: Pixels) -> Array:
    cover = rgba[..., 3:] / 255.0
    return np.asarray(rgba[..., :3] * cover + 127.5 * (1.0 - cover))


def _plan(
    cast: CrowdClone, body: BodyLevels, wanted: BakeSettings, seen: Sequence[BakedClip]
) -> tuple[list[Tile], list[int]]:
    """Return the tiles in order (clip, ring, view, pose) and the first one of each clip."""
    found: list[Tile] = []
    starts: list[int] = []
    names = [clip.name for clip in cast.clips]
    for number, clip in enumerate(cast.clips):
        starts.append(starts[names.index(clip.far)] if clip.far else len(found))
        if clip.far:
            continue
        every = len(clip.frames) // clip.poses
        clouds = _pose_extents(cast, body, clip)
        for elevation in wanted.elevations:
            for view in baked_views(seen[number], wanted.views):
                direction = axes(view * 2.0 * np.pi / wanted.views, elevation)
                found += [
                    _tile(number, pose * every, direction, cloud, wanted.texels_per_m)
                    for pose, cloud in enumerate(clouds)
                ]
    return found, starts


def _pose_extents(cast: CrowdClone, body: BodyLevels, clip: Clip) -> list[Array]:
    """Return points that reach as far as the person does in each pose, from the middle, metres."""
    coarse, loose = slice(0, body.counts[-2]), cast.loose
    some = np.unique(np.concatenate([triangles.reshape(-1) for triangles in loose.triangles[-2:]]))
    clouds = []
    for frame in clip.frames[:: len(clip.frames) // clip.poses][: clip.poses]:
        own = skin_vertices(cast.vertices_m[coarse], body.joints[coarse], body.weights[coarse], frame)
        hair = skin_vertices(loose.vertices_m[some], loose.joints[some], loose.weights[some], frame)
        clouds.append(np.concatenate([own, hair]) - (0.0, middle_m(cast), 0.0))
    return clouds


def _tile(clip: int, frame: int, direction: Array, cloud: Array, texels_per_m: float) -> Tile:
    seen = cloud @ direction.T
    plane = seen[:, :2] * (BAKED_FROM_M / (BAKED_FROM_M - seen[:, 2:]))
    low = plane.min(axis=0) - _MARGIN / texels_per_m
    high = plane.max(axis=0) + _MARGIN / texels_per_m
    size = np.ceil((high - low) * texels_per_m / _ALIGNED).astype(int) * _ALIGNED
    middle = (low + high) / 2.0
    half = size / (2.0 * texels_per_m)
    box = (*(middle - half).tolist(), *(middle + half).tolist())
    return Tile(clip, frame, direction, box, (int(size[0]), int(size[1])))


def _pack_tiles(tiles: Sequence[Tile], page_wide: int) -> tuple[list[tuple[int, int]], int]:
    """Return each tile's position in the page, texels from its top left, and the page's height."""
    order = sorted(range(len(tiles)), key=lambda k: (-tiles[k].size[1], k))
    places = [(0, 0)] * len(tiles)
    x = y = shelf = 0
    for k in order:
        wide, tall = tiles[k].size
        if x + wide > page_wide:
            x, y, shelf = 0, y + shelf, 0
        places[k] = (x, y)
        x, shelf = x + wide, max(shelf, tall)
    return places, -(-(y + shelf) // 8) * 8


def with_tiles(held: CrowdArrays, tiles: Sequence[Tiles], wanted: BakeSettings) -> CrowdArrays:
    """Return a stock with impostors, one :class:`Tiles` per clone in the stock's order."""
    tall, wide = max(one.colours.shape[0] for one in tiles), wanted.page_wide
    count = max(len(one.rows) for one in tiles)
    rows = np.zeros((len(tiles), count, 4), np.float32)
    colours = np.zeros((len(tiles), tall, wide, 4), np.uint8)
    every = tiles[0].colours.shape[1] // tiles[0].shapes.shape[1]
    shapes = np.zeros((len(tiles), tall // every, wide // every, 4), np.uint8)
    for k, one in enumerate(tiles):
        rows[k, : len(one.rows)] = one.rows
        colours[k, : len(one.colours)] = one.colours
        shapes[k, : len(one.shapes)] = one.shapes
    return replace(held, tiles=rows, colours=colours, shapes=shapes, elevations=tuple(wanted.elevations))
