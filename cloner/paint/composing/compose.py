"""Photos into texels, tile by tile: visibility per texel, then one multiresolution blend."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import cast

import numpy as np
from numpy.typing import NDArray

from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman
from cloner.generic.photo_shares import head_weight
from cloner.geometry.charts.atlas import AtlasMap
from cloner.geometry.charts.partition import blend_weights, partition_surface
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.paint.composing.baked import AtlasInProgress, blank_atlas
from cloner.paint.composing.grain import coarse_tiles
from cloner.paint.composing.tiles import Tile, cut_tiles
from cloner.paint.lookups.materials import SQUARE, Materials, continues, shows_garment
from cloner.paint.lookups.prepared import Limits
from cloner.paint.lookups.sources import Source, covered_by_hair, shown_colours, visible_points
from cloner.paint.lookups.zones import always_bare, hair_allowed, hair_kept
from cloner.parallel import parallel_map
from cloner.records.arrays import Array
from cloner.vision.photographs.blending import Layer, blend_pyramids, push_pull
from cloner.vision.retouching.aligning import sample
from cloner.vision.retouching.normalising import apply_light

OWNERS = 0.01  # who has less of a texel than this is asked only where nobody has more
SECOND_CHOICE = 0.002  # of a full share: paints only where the owner is hidden at that very texel
LAST_CHOICE = 0.0005  # beside an inner outline a photo paints only what no other one sees
OWNER_SMOOTHING = 4  # rounds; borders of 2-3 edge lengths' smoothness
CLASH = 0.6  # of a full difference between skin and not skin
#: Share of the weight from which one photo owns a texel (taste).
OWNER_SHARE = 0.6
BORDER_KIND = 0.25  # half the range of kinds that is border
KIND_EDGE = 0.15  # kinds mix where their shares differ by less
FILL_SHARE = 1e-6  # the smooth fill shows only where no photo does
SHARE_COLUMN = 6  # of the table that :func:`paint_table` makes

COARSEST = 128  # pixels a side of an atlas in which a band is one pixel wide
MOST_LEVELS = 4  # reach 30 texels, within a tile's margin

Painted = tuple[NDArray[np.int32], NDArray[np.float32], NDArray[np.float32]]
"""Texels (N,), their colours (N, 3) in levels and weights (N,) from one photo."""


def blend_shares(
    generic: GenericHuman, sources: list[Source], graph: SurfaceGraph, *, band_m: float, head_band_m: float
) -> Array:
    """Return the blend weights (K, V) of the sources, with bands along the borders of their regions."""
    scores = np.stack([source.score for source in sources])
    owner = partition_surface(scores, graph, smoothing=OWNER_SMOOTHING)
    head = head_weight(generic)
    band = head_band_m * head + band_m * (1.0 - head)
    shares = blend_weights(owner, len(sources), graph, band)
    return np.where(scores > 0.0, shares + SECOND_CHOICE * scores, 0.0)


def blend_levels(size: int) -> int:
    """Return the pyramid levels for an atlas of ``size`` texels a side: its coarsest pixel is as wide as the bands.

    Bands are 16 mm wide on the head and 24 mm on the body, 16 texels of 2,048. Margins of tiles allow no more levels.
    """
    return max(min((size // COARSEST).bit_length() - 1, MOST_LEVELS), 1)


def bake(
    generic: GenericHuman,
    size: int,
    sources: list[Source],
    shares: Array,
    light: Array,
    base: NDArray[np.float32],
    kinds: Materials,
    limits: Limits,
    *,
    levels: int,
    tick: Callable[[float], None],
) -> AtlasInProgress:
    """Return the atlas painted with the photos.

    Tile by tile: large atlases need hardly more memory than small ones, and no more time where photos hold no more.

    Parameters
    ----------
    size : int
        Side of the atlas, texels.
    shares : (K, V); light : (K, V, 3) log gains; base : (3, V, 3) levels of skin, hair and cloth
    levels : int
        Pyramid levels of the blend.
    tick : callable, called with fractions 0..1
    """
    tables = [paint_table(generic, source, shares[k], light[k], kinds) for k, source in enumerate(sources)]
    whole, tiles = blank_atlas(size), cut_tiles(size)
    coarse = coarse_tiles(generic, size, tiles, sources, shares)

    def paint_tile(tile: Tile, halvings: int) -> AtlasInProgress | None:
        atlas = generic_atlas(generic, size >> halvings, window=tile.outer)
        if not atlas.texel.size:
            return None
        rgb, seen = bake_tile(generic, atlas, sources, tables, base, kinds, limits, levels - halvings)
        levels_rgb = np.clip(np.rint(rgb[tile.inner]), 0, 255).astype(np.uint8)
        return AtlasInProgress(levels_rgb, atlas.covered()[tile.inner], seen[tile.inner])

    def paint_either(number: int) -> AtlasInProgress | None:
        if not coarse[number]:
            return paint_tile(tiles[number], 0)
        small = paint_tile(tiles[number].halved(), 1)
        return small and small.doubled()

    for number, part in enumerate(parallel_map(paint_either, range(len(tiles)))):
        place = tiles[number].place
        if part is not None:
            whole.rgb[place], whole.covered[place], whole.seen[place] = part.rgb, part.covered, part.seen
        tick((number + 1) / len(tiles))
    return whole


def bake_tile(
    generic: GenericHuman,
    atlas: AtlasMap,
    sources: list[Source],
    tables: list[NDArray[np.float32]],
    base: NDArray[np.float32],
    kinds: Materials,
    limits: Limits,
    levels: int,
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Return colours (h, w, 3) in levels of one window of the atlas, and which texels a photo shows (h, w)."""
    covered = atlas.covered()
    ground = np.zeros((covered.size, 3), np.float32)
    ground[atlas.texel] = ground_colours(atlas, base, kinds)
    ground = push_pull(ground.reshape(*covered.shape, 3), covered.astype(np.float32))
    seen = np.zeros(covered.size, bool)

    def layers() -> Iterator[Layer]:
        yield Layer(ground, np.full(covered.shape, FILL_SHARE, np.float32))
        for source, (texel, colour, weight) in zip(
            sources, paint(generic, atlas, sources, tables, limits), strict=True
        ):
            if texel.size == 0:
                continue
            if not source.mirrored:
                seen[texel[weight > 2 * FILL_SHARE]] = True
            yield dense_layer(ground, texel, colour, weight, 1 << levels)

    rgb = blend_pyramids(layers(), (*covered.shape, 3), levels)
    return rgb, seen.reshape(covered.shape)


def paint_table(
    generic: GenericHuman, source: Source, share: Array, light: Array, kinds: Materials
) -> NDArray[np.float32]:
    """Return the per-vertex table (V, 18) for :func:`paint`: lookups and depth, weights, kinds, light, skin."""
    around = np.zeros_like(light) if kinds.around is None else kinds.around
    return np.column_stack(
        [
            source.visibility.pixel_px,
            source.lookup_px,
            source.visibility.depth_m,
            source.visibility.cosine,
            share,
            hair_allowed(generic),
            hair_kept(generic),
            kinds.bare,
            always_bare(generic),
            light,
            kinds.skin & (kinds.around is not None),
            around,
        ]
    ).astype(np.float32)


def paint(
    generic: GenericHuman,
    atlas: AtlasMap,
    sources: list[Source],
    tables: list[NDArray[np.float32]],
    limits: Limits,
) -> list[Painted]:
    """Return the layer that each photo paints.

    A texel's owners first; others are asked only where none of them shows it.
    """
    skin = generic.skin
    outside = skin & ~generic.region("mouth_interior")
    claims, shown = [], np.zeros(atlas.shape[0] * atlas.shape[1], np.float32)
    found: list[Painted] = []
    for source, table in zip(sources, tables, strict=True):
        useful = (table[:, SHARE_COLUMN] > 0.0) & outside
        rows = atlas.rows_of(useful[atlas.triangles].any(axis=1) & skin[atlas.triangles[:, 0]])
        share = atlas.interpolate(table[:, SHARE_COLUMN], rows)
        found.append(_paint_rows(atlas, source, table, rows[share > OWNERS], limits))
        claims.append(rows[(share > 0.0) & (share <= OWNERS)])
        shown[found[-1][0]] += found[-1][2]
    for k, rows in enumerate(claims):
        rows = rows[shown[atlas.texel[rows]] < OWNERS]
        more = _paint_rows(atlas, sources[k], tables[k], rows, limits)
        found[k] = cast(Painted, tuple(np.concatenate(both) for both in zip(found[k], more, strict=True)))
    return found


def _paint_rows(
    atlas: AtlasMap,
    source: Source,
    table: NDArray[np.float32],
    rows: NDArray[np.int64],
    limits: Limits,
) -> Painted:
    """Return texels, colours and weights of some texels; ``table`` as made by :func:`paint_table`."""
    # Cheap tests first: what they leave is sampled in the photo, what that leaves is coloured.
    values = atlas.interpolate(table[:, :7], rows)
    first = np.flatnonzero((values[:, 6] > 0.0) & (values[:, 5] > limits.steepest_cosine))
    values, rows = values.take(first, axis=0), rows.take(first)
    seen = visible_points(source, limits, values[:, :2], values[:, 2:4], values[:, 4], values[:, 5])
    values, rows = values.compress(seen, axis=0), rows[seen]
    pixel, lookup, depth, cosine, weight = values[:, :2], values[:, 2:4], values[:, 4], values[:, 5], values[:, 6]
    scalp, face, bare, own, *_ = kinds = atlas.interpolate(table[:, 7:], rows).T
    good = ~covered_by_hair(source, pixel, lookup, depth, scalp > 0.5, face > 0.5)
    # Only who owns a border draws it: another's collar a little off would lie beside it.
    skin = sample(source.matted.skin, lookup)[:, 0] / 255.0
    head = np.flatnonzero(own > 0.0)
    own[head] *= ~shows_garment(source, lookup[head])
    clash = np.abs(np.maximum(skin, own) - bare)
    unsure = (weight > OWNER_SHARE) & (np.abs(bare - 0.5) < BORDER_KIND)
    good &= (clash < CLASH) | unsure
    unsafe = source.visibility.before_edge(pixel, depth, cosine)
    weight = np.where(unsafe, LAST_CHOICE * weight, weight)
    doubtful = np.flatnonzero(good & (cosine < SQUARE) & (kinds[7] > 0.5))
    blurred = shown_colours(source, lookup[doubtful], skin[doubtful], blurred=True)
    good[doubtful] = continues(blurred, kinds[8:, doubtful].T)
    colour = apply_light(shown_colours(source, lookup[good], skin[good]), kinds[4:7, good].T)
    return atlas.texel[rows[good]], colour.astype(np.float32), weight[good]


def ground_colours(atlas: AtlasMap, base: NDArray[np.float32], kinds: Materials) -> NDArray[np.float32]:
    """Return the fill (N, 3) of all texels: one kind each, mixed only over the width of a few texels."""
    share = np.column_stack([kinds.bare * (1.0 - kinds.scalp), kinds.bare * kinds.scalp, kinds.worn])
    order = np.sort(share, axis=1)
    kind = np.where(order[:, 2] - order[:, 1] > KIND_EDGE, share.argmax(axis=1), -1)[atlas.triangles]
    pure = np.where((kind == kind[:, :1]).all(axis=1), kind[:, 0], -1)[atlas.triangle]
    found = np.zeros((len(atlas.texel), 3), np.float32)
    for k in range(3):
        rows = np.flatnonzero(pure == k)
        found[rows] = atlas.interpolate(base[k], rows)
    border = np.flatnonzero(pure < 0)
    part = atlas.interpolate(share, border)
    part = np.maximum(part - part.max(axis=1, keepdims=True) + KIND_EDGE, 0.0)
    part /= part.sum(axis=1, keepdims=True)
    for k in range(3):
        rows = border[part[:, k] > 0.0]
        found[rows] += part[part[:, k] > 0.0, k : k + 1] * atlas.interpolate(base[k], rows)
    return found


def dense_layer(
    ground: NDArray[np.float32],
    texel: NDArray[np.int32],
    colour: NDArray[np.float32],
    weight: NDArray[np.float32],
    grid: int,
) -> Layer:
    """Return the part of the atlas that one photo paints, as a layer.

    Where the photo paints nothing the image follows the ground plus a smooth
    difference, so that the pyramid finds no edge where the photo's texels end.

    Parameters
    ----------
    ground : (h, w, 3); texel, weight : (N,); colour : (N, 3)
    grid : int
        Corners of the crop are multiples of this.
    """
    row, column = np.divmod(texel, ground.shape[1])
    top, left = (max(int(v.min()) // grid - 1, 0) * grid for v in (row, column))
    ends = zip((row, column), ground.shape, strict=False)
    bottom, right = (min((int(v.max()) // grid + 2) * grid, end) for v, end in ends)
    below = ground[top:bottom, left:right]
    image = np.zeros(below.shape, np.float32)
    known = np.zeros(below.shape[:2], np.float32)
    place = (row - top, column - left)
    image[place] = colour - below[place]
    known[place] = 1.0
    image = push_pull(image, known)
    image += below
    known[place] = weight
    return Layer(image, known, (top, left))
