"""Stage: paint the person with the photos, in the generic human's atlas.

References
----------
Method notes section 9 (head texture) and 10 (body texture).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.abreast import abreast
from cloner.baking.compose import PLAIN_RGB, bake, share_surface
from cloner.baking.evened import compare_photos, even_photos, evened_colours, fill_surface, vertex_colours
from cloner.baking.labelled import vet_labels
from cloner.baking.materials import doubt_grazing, find_materials
from cloner.baking.parts import paint_parts
from cloner.baking.posed import body_triangles
from cloner.baking.sources import Limits, gather_sources
from cloner.baking.tiles import Tile, cut_tiles
from cloner.baking.tucking import tuck_scalp
from cloner.generic.charts import generic_atlas, person_graph
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.atlas import AtlasMap
from cloner.geometry.wedges import vertex_normals
from cloner.records.clones import Clone, Joined, TextureAtlas
from cloner.records.heads import HeadFit, Shell
from cloner.records.photos import PhotoSet
from cloner.records.points import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet


@dataclass(frozen=True, slots=True)
class Params:
    """Settings of the texture stage.

    Attributes
    ----------
    size : int
        Side of the atlas, texels.
    levels : int
        Levels of the Laplacian pyramids. Light is evened on the surface: more levels only carry halos of what
        photos disagree about over 2**levels texels.
    band_m, head_band_m : float
        Half width L of the mixing band between two photos on body and head, metres (taste).
    limits : Limits
        When a photo may paint a surface.
    """

    size: int = 2048
    levels: int = 2
    band_m: float = 0.012
    head_band_m: float = 0.008
    limits: Limits = field(default_factory=Limits)


def run(
    *,
    photos: PhotoSet,
    proposals: Proposals,
    silhouettes: SilhouetteSet,
    joined: Joined,
    shells: tuple[Shell, ...],
    head: HeadFit,
    tick: Callable[[float], None],
    rng: np.random.Generator,
    params: Params | None = None,
) -> StageResult:
    """Return the textured clone; its regions are still to be said.

    Residuals: disagreement between photos that show the same surface, in grey
    levels, before and after evening; gap between mesh and photo outlines that
    was shifted away, px; share of the charts' texels that a photo saw.
    """
    params = params or Params()
    generic = load_generic()
    proposals = vet_labels(photos, proposals)
    joined = replace(joined, vertices_m=tuck_scalp(generic, joined.vertices_m, shells))
    tick(0.15)
    sources, residuals = gather_sources(generic, photos, proposals, silhouettes, joined, shells, params.limits)
    tick(0.4)
    if sources:
        graph = person_graph(generic, joined.vertices_m)
        normals = vertex_normals(joined.vertices_m, body_triangles(generic))
        colours = vertex_colours(sources)
        kinds = find_materials(generic, sources, graph)
        sources = doubt_grazing(generic, sources, colours, kinds, graph)
        light = even_photos(generic, sources, colours, normals, kinds, graph)
        residuals += compare_photos(sources, colours, light)
        base = fill_surface(generic, sources, evened_colours(colours, light), kinds, graph)
        shares = share_surface(generic, sources, graph, band_m=params.band_m, head_band_m=params.head_band_m)
        rgb, seen = bake(
            generic,
            params.size,
            sources,
            shares,
            light,
            base,
            kinds,
            params.limits,
            levels=params.levels,
            tick=lambda part: tick(0.4 + 0.5 * part),
        )
    else:
        rgb = np.tile(np.array(PLAIN_RGB, np.uint8), (params.size, params.size, 1))
        seen = np.zeros((params.size, params.size), dtype=bool)
    rgb = paint_parts(
        generic, parts_atlas(generic, params.size), rgb, joined.vertices_m, head.iris_rgb, head.iris_radius_m, rng
    )
    rgb, covered = pad_charts(generic, rgb)
    residuals.append(Residual("texels_seen", 100.0 * float(seen.sum()) / max(covered, 1), "percent"))
    clone = assemble(joined, shells, TextureAtlas(rgb, np.where(seen, 255, 0).astype(np.uint8)))
    tick(1.0)
    warnings = () if sources else ("No photo could be laid on the body: it keeps one plain colour",)
    return StageResult({"painted": clone}, tuple(residuals), warnings)


def parts_atlas(generic: GenericHuman, size: int) -> AtlasMap:
    """Return the atlas of what is painted and not photographed, and of the face, whose colour it takes."""
    triangles = generic.triangles()[0]
    body = generic.vertex_part[triangles[:, 0]] == generic.part_names.index("body")
    return generic_atlas(generic, size, wanted=~body | generic.region("face")[triangles].all(axis=1))


def pad_charts(generic: GenericHuman, rgb: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], int]:
    """Return the atlas with every texel near the charts showing its nearest chart's colour, and the charts' texels.

    A renderer's smaller mip levels average over chart borders; without the padding they would draw seams.
    """
    size = len(rgb)
    tiles = cut_tiles(size)

    def pad(tile: Tile) -> tuple[NDArray[np.uint8], int]:
        window = tile.outer
        part = rgb[window.top : window.top + window.height, window.left : window.left + window.width]
        covered = generic_atlas(generic, size, window=window).covered()
        padded = spread_nearest(part, covered) if covered.any() else part
        return padded[tile.inner], int(covered[tile.inner].sum())

    padded, count = np.empty_like(rgb), 0
    for tile, (part, found) in zip(tiles, abreast(pad, tiles), strict=True):
        padded[tile.place] = part
        count += found
    return padded, count


def spread_nearest(rgb: NDArray[np.uint8], known: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return the picture (H, W, 3) in which every unknown pixel shows the nearest known one's colour."""
    _, labels = cv2.distanceTransformWithLabels(
        (~known).astype(np.uint8), cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
    )
    colour_of = np.zeros((int(labels.max()) + 1, 3), np.uint8)
    colour_of[labels[known]] = rgb[known]
    return np.asarray(colour_of[labels], np.uint8)


def assemble(joined: Joined, shells: tuple[Shell, ...], atlas: TextureAtlas) -> Clone:
    """Return the finished clone: the joined person with texture and hair."""
    return Clone(
        vertices_m=joined.vertices_m,
        joints_m=joined.joints_m,
        morph_names=joined.morph_names,
        morph_index=joined.morph_index,
        morph_delta_m=joined.morph_delta_m,
        morph_start=joined.morph_start,
        atlas=atlas,
        shells=shells,
        features_m=joined.features_m,
        views=joined.views,
        stature_m=joined.stature_m,
        sole_m=joined.sole_m,
    )
