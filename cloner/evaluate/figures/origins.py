"""The source photo and pixel of every texel of a clone's atlas."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman, load_generic
from cloner.paint.composing.compose import paint, paint_table
from cloner.paint.lookups.sources import Source
from cloner.stages.textures import Params, before_painting, prepare_sources

#: Side of the atlas that is asked, texels: enough to count.
SIZE: Final = 512
#: Pixel places are carried through the painter as colours, which it keeps within 0..255 levels.
_TOP_LEVEL: Final = 250.0


@dataclass(frozen=True, slots=True, eq=False)
class TexelOrigins:
    """Sources of the painted texels of an atlas.

    Attributes
    ----------
    vertices : (N, 3) int32
        Corners of the triangle that each texel lies on.
    barycentric : (N, 3) float32
    view : (N,) int
        Row of `views` of the photo with the largest weight there.
    mirrored : (N,) bool
        Whether that photo painted its mirror image.
    pixel_px : (N, 2) float32
        Place in that photo.
    views : tuple of ViewId
    """

    vertices: NDArray[np.int32]
    barycentric: NDArray[np.float32]
    view: NDArray[np.intp]
    mirrored: NDArray[np.bool_]
    pixel_px: NDArray[np.float32]
    views: tuple[ViewId, ...]


def texel_origins(values: Mapping[str, Any]) -> TexelOrigins | None:
    """Return the origins of a clone's texels, by painting it again with the same rules; None where no photo shows the
    body.

    Parameters
    ----------
    values : mapping
        All values of the pipeline, by name.
    """
    generic, params = load_generic(), Params()
    photos, proposals, joined, hiding = before_painting(
        generic, values["photos"], values["proposals"], values["obeyed"], values["shells"]
    )
    silhouettes = values["obeyed_silhouettes"]
    shared, _ = prepare_sources(generic, photos, proposals, silhouettes, joined, hiding, params, lambda part: None)
    if shared is None:
        return None
    dark = np.zeros_like(shared.light[0])
    tables = [
        paint_table(generic, source, share, dark, shared.kinds)
        for source, share in zip(shared.sources, shared.shares, strict=True)
    ]
    scales = [max(source.matted.inside_px.shape) / _TOP_LEVEL for source in shared.sources]
    placed = [_with_position_picture(source, scale) for source, scale in zip(shared.sources, scales, strict=True)]
    return _owners(generic, placed, tables, scales, params)


def _with_position_picture(source: Source, scale: float) -> Source:
    """Return a source whose photo encodes each pixel's position as red and green."""
    height, width = source.matted.inside_px.shape
    row, column = np.mgrid[:height, :width].astype(np.float32) / np.float32(scale)
    places: Any = np.stack([column, row, np.zeros_like(row)], axis=2)
    return replace(source, matted=replace(source.matted, rgb=places, shares=None))


def _owners(
    generic: GenericHuman,
    sources: list[Source],
    tables: list[NDArray[np.float32]],
    scales: list[float],
    params: Params,
) -> TexelOrigins:
    atlas = generic_atlas(generic, SIZE)
    count = SIZE * SIZE
    best, owner = np.zeros(count, np.float32), np.full(count, -1)
    pixel = np.zeros((count, 2), np.float32)
    for k, (texel, place, weight) in enumerate(paint(generic, atlas, sources, tables, params.limits)):
        more = weight > best[texel]
        texel = texel[more]
        best[texel], owner[texel] = weight[more], k
        pixel[texel] = place[more, :2] * np.float32(scales[k])
    views = tuple(dict.fromkeys(source.view for source in sources))
    rows = np.flatnonzero(owner[atlas.texel] >= 0)
    texel = atlas.texel[rows]
    row_of_view = np.array([views.index(source.view) for source in sources])
    mirrored = np.array([source.mirrored for source in sources])
    return TexelOrigins(
        vertices=atlas.triangles[atlas.triangle[rows]],
        barycentric=atlas.barycentric[rows],
        view=row_of_view[owner[texel]],
        mirrored=mirrored[owner[texel]],
        pixel_px=pixel[texel],
        views=views,
    )
