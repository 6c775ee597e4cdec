"""Photos into texels: visibility per texel, then one multiresolution blend."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from cloner.baking.materials import Materials, always_bare
from cloner.baking.sources import (
    Limits,
    Source,
    covered_by_hair,
    hair_allowed,
    hair_kept,
    shown_colours,
    visible_points,
)
from cloner.generic.load import GenericHuman
from cloner.generic.photo_shares import head_weight
from cloner.geometry.atlas import AtlasMap
from cloner.geometry.graphs import SurfaceGraph
from cloner.geometry.partition import border_shares, partition_surface
from cloner.vision.aligning import sample
from cloner.vision.blending import Layer, blend_pyramids, push_pull
from cloner.vision.evening import apply_light

Array = NDArray[np.float64]

SECOND_CHOICE = 0.002  # of a full share: paints only where the owner is hidden at that very texel
CHUNK_TEXELS = 1 << 18  # texels worked on at once: tables stay in tens of MiB
LAST_CHOICE = 0.0005  # beside an inner outline a photo paints only what no other one sees
OWNER_SMOOTHING = 4  # rounds; borders of 2-3 edge lengths' smoothness
CLASH = 0.6  # of a full difference between skin and not skin
OWNER_SHARE = 0.6
BORDER_KIND = 0.25  # half the range of kinds that is border
KIND_EDGE = 0.15  # kinds mix where their shares differ by less
FILL_SHARE = 1e-6  # the smooth fill shows only where no photo does


def share_surface(
    generic: GenericHuman, sources: list[Source], graph: SurfaceGraph, *, band_m: float, head_band_m: float
) -> Array:
    """Return (K, V) shares of the sources, mixing over bands along the borders of their regions."""
    scores = np.stack([source.score for source in sources])
    owner = partition_surface(scores, graph, smoothing=OWNER_SMOOTHING)
    head = head_weight(generic)
    band = head_band_m * head + band_m * (1.0 - head)
    shares = border_shares(owner, len(sources), graph, band)
    return np.where(scores > 0.0, shares + SECOND_CHOICE * scores, 0.0)


def bake(
    generic: GenericHuman,
    atlas: AtlasMap,
    sources: list[Source],
    shares: Array,
    light: Array,
    base: NDArray[np.float32],
    kinds: Materials,
    limits: Limits,
    *,
    levels: int,
    tick: Callable[[float], None],
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Return the atlas' colours and which texels a photo saw.

    Parameters
    ----------
    shares : (K, V); light : (K, V, 3) log gains; base : (3, V, 3) levels of skin, hair and cloth
    levels : int
        Pyramid levels of the blend.
    tick : callable, called with fractions 0..1

    Returns
    -------
    rgb : (size, size, 3) float32, levels; sensible also outside the charts
    seen : (size, size) bool, texels that a photo (not a mirrored one) painted
    """
    size = atlas.size
    covered = atlas.covered()
    ground = np.zeros((size * size, 3), np.float32)
    ground[atlas.texel] = lay_ground(atlas, base, kinds)
    ground = push_pull(ground.reshape(size, size, 3), covered.astype(np.float32))
    seen = np.zeros(size * size, bool)

    def layers() -> Iterator[Layer]:
        yield Layer(ground, np.full((size, size), FILL_SHARE, np.float32))
        for k, source in enumerate(sources):
            tick(k / len(sources))
            texel, colour, weight = paint(generic, atlas, source, shares[k], light[k], kinds, limits)
            if texel.size == 0:
                continue
            if not source.mirrored:
                seen[texel[weight > 2 * FILL_SHARE]] = True
            yield dense_layer(ground, texel, colour, weight, 1 << levels)

    rgb = blend_pyramids(layers(), (size, size, 3), levels)
    return rgb, seen.reshape(size, size)


def paint(
    generic: GenericHuman,
    atlas: AtlasMap,
    source: Source,
    share: Array,
    light: Array,
    kinds: Materials,
    limits: Limits,
) -> tuple[NDArray[np.int32], NDArray[np.float32], NDArray[np.float32]]:
    """Return texels (N,), their colours (N, 3) in levels and weights (N,) from one photo."""
    skin = generic.vertex_part == generic.part_names.index("body")
    useful = (share > 0.0) & skin & ~generic.region("mouth_interior")
    rows = atlas.rows_of(useful[atlas.triangles].any(axis=1) & skin[atlas.triangles[:, 0]])
    table = np.column_stack(
        [
            source.sight.pixel_px,
            source.lookup_px,
            source.sight.depth_m,
            source.sight.cosine,
            share,
            hair_allowed(generic),
            hair_kept(generic),
            kinds.bare,
            always_bare(generic),
            light,
        ]
    ).astype(np.float32)
    pieces = [
        _paint_rows(atlas, source, table, rows[start : start + CHUNK_TEXELS], limits)
        for start in range(0, rows.size, CHUNK_TEXELS)
    ]
    if not pieces:
        return np.zeros(0, np.int32), np.zeros((0, 3), np.float32), np.zeros(0, np.float32)
    return tuple(np.concatenate(column) for column in zip(*pieces, strict=True))  # type: ignore[return-value]


def _paint_rows(
    atlas: AtlasMap,
    source: Source,
    table: NDArray[np.float32],
    rows: NDArray[np.int64],
    limits: Limits,
) -> tuple[NDArray[np.int32], NDArray[np.float32], NDArray[np.float32]]:
    """Return texels, colours and weights of some texels; ``table`` as made in :func:`paint`."""
    values = atlas.interpolate(table, rows)
    # Cheap tests first: what they leave is sampled in the photo.
    first = np.flatnonzero((values[:, 6] > 0.0) & (values[:, 5] > limits.steepest_cosine))
    values, rows = values[first], rows[first]
    seen = np.flatnonzero(visible_points(source, limits, values[:, :2], values[:, 2:4], values[:, 4], values[:, 5]))
    values, rows = values[seen], rows[seen]
    pixel, lookup, depth, cosine, weight = values[:, :2], values[:, 2:4], values[:, 4], values[:, 5], values[:, 6]
    good = ~covered_by_hair(source, pixel, lookup, depth, values[:, 7] > 0.5, values[:, 8] > 0.5)
    unsafe = source.sight.before_edge(pixel, depth, cosine)
    weight = np.where(unsafe, LAST_CHOICE * weight, weight)
    # Only who owns a border draws it: another's collar a little off would lie beside it.
    skin = sample(source.plate.skin, lookup)[:, 0] / 255.0
    clash = np.abs(np.maximum(skin, values[:, 10]) - values[:, 9])
    unsure = (values[:, 6] > OWNER_SHARE) & (np.abs(values[:, 9] - 0.5) < BORDER_KIND)
    good &= (clash < CLASH) | unsure
    colour = apply_light(shown_colours(source, lookup[good], skin[good]), values[good, 11:14])
    return atlas.texel[rows[good]], colour.astype(np.float32), weight[good]


def lay_ground(atlas: AtlasMap, base: NDArray[np.float32], kinds: Materials) -> NDArray[np.float32]:
    """Return (N, 3) the fill of all texels: each of one kind, mixed only over the width of a few texels."""
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
    ground : (size, size, 3); texel, weight : (N,); colour : (N, 3)
    grid : int
        Corners of the crop are multiples of this.
    """
    size = ground.shape[0]
    row, column = np.divmod(texel, size)
    top, left = (max(int(v.min()) // grid - 1, 0) * grid for v in (row, column))
    bottom, right = (min((int(v.max()) // grid + 2) * grid, size) for v in (row, column))
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
