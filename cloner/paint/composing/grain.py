"""Resolution of the photos: tiles whose texels are finer than half a photo pixel are baked coarser."""

from __future__ import annotations

import numpy as np

from cloner.generic.load import GenericHuman
from cloner.geometry.meshes.triangles import areas
from cloner.paint.composing.tiles import Tile
from cloner.paint.lookups.sources import Source
from cloner.records.arrays import Array

HALF_GRAIN = 0.55  # photo pixels a texel: at half the texels there is still about one texel a pixel
OWN_SHARE = 0.3  # of a photo in a surface: less adds no detail
FEW = 0.05  # of a tile's seen texels may lose some detail


def coarse_tiles(
    generic: GenericHuman, size: int, tiles: list[Tile], sources: list[Source], shares: Array
) -> list[bool]:
    """Return for each tile whether half as many texels a side hold all that the photos show there.

    Parameters
    ----------
    size : int
        Side of the atlas, texels.
    sources : list of K photos
    shares : (K, V) of each photo in each vertex
    """
    triangles, uv_triangles = generic.triangles()
    places = np.asarray(generic.uv, np.float64) * size
    texels, pixels = areas(places, uv_triangles), np.zeros(len(triangles))
    for source, share in zip(sources, shares, strict=True):
        own = (share[triangles] > OWN_SHARE).all(axis=1)
        pixels = np.maximum(pixels, np.where(own, areas(source.lookup_px, triangles), 0.0))
    fine, middle = pixels > HALF_GRAIN**2 * texels, places[uv_triangles].mean(axis=1)
    found = []
    for tile in tiles:
        low = np.array([tile.place[1].start, tile.place[0].start])
        high = np.array([tile.place[1].stop, tile.place[0].stop])
        own = ((middle >= low) & (middle < high)).all(axis=1) & (pixels > 0.0)
        found.append(bool(texels[own & fine].sum() <= FEW * texels[own].sum()))
    return found
