"""Stage: the photos painted into the generic human's texture atlas.

References
----------
Method notes section 9 (head texture) and 10 (body texture).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.charts import generic_atlas, person_graph
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.charts.atlas import AtlasMap
from cloner.geometry.charts.iris import sclera_to_skin, skin_around_eyes
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.labels.glasses import wears_glasses
from cloner.memory import release_free_memory
from cloner.paint.composing.baked import AtlasInProgress, unpainted_atlas
from cloner.paint.composing.compose import bake, blend_levels, blend_shares
from cloner.paint.composing.shell_light import match_light_of_body
from cloner.paint.composing.tiles import Tile, cut_tiles
from cloner.paint.details.below_glasses import remove_glasses
from cloner.paint.details.hands import finish_hands, finish_soles
from cloner.paint.details.lid_skin import clean_lids
from cloner.paint.details.nostrils import darken_nostrils
from cloner.paint.details.parts import face_rgb, paint_parts
from cloner.paint.details.tucking import tuck_scalp
from cloner.paint.details.unseen_clothes import dress_unseen, extend_clothes, nearness_to_seen, shows_faces_only
from cloner.paint.lookups.feature_lines import align_feature_lines
from cloner.paint.lookups.materials import Materials, find_materials, with_surroundings
from cloner.paint.lookups.normalised import (
    compare_photos,
    fill_surface,
    match_borders,
    normalise_photos,
    normalised_colours,
    vertex_colours,
)
from cloner.paint.lookups.prepared import Limits
from cloner.paint.lookups.rejected import reject_grazing, reject_slanted, reject_wrong_parts
from cloner.paint.lookups.sources import Source, gather_sources
from cloner.parallel import parallel_map
from cloner.records.arrays import Array
from cloner.records.clones import Clone, Joined, TextureAtlas
from cloner.records.heads import HeadFit, Shell
from cloner.records.labels import SURFACES
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.vision.photographs.noise import denoised
from cloner.vision.retouching.repair import spread_nearest

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.textures")


@dataclass(frozen=True, slots=True)
class Params:
    """Settings of the texture stage.

    Its numbers: ``cloner/calibration/stages.toml``, ``[textures.*]``.

    Attributes
    ----------
    size : int
        Side of the atlas, texels.
    limits : Limits
        When a photo may paint a surface.
    """

    size: int = 2048
    band_m: float = _CALIBRATED.number("band_m", "m")
    head_band_m: float = _CALIBRATED.number("head_band_m", "m")
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
    """Return the textured clone without region labels.

    Residuals: disagreement between photos that show the same surface, in grey
    levels, before and after evening; gap between mesh and photo outlines that
    was shifted away, px; share of the charts' texels that a photo saw.
    """
    params = params or Params()
    generic = load_generic()
    photos, proposals, joined, hiding = before_painting(generic, photos, proposals, joined, shells)
    baked, surfaces, worn_rgb, residuals = paint_atlas(
        generic, photos, proposals, silhouettes, joined, hiding, params, tick
    )
    warnings = () if baked else ("No photo could be laid on the body: it keeps one plain colour",)
    baked = baked or unpainted_atlas(generic, params.size)
    seen, charts = int(baked.seen.sum()), int(baked.covered.sum())
    residuals.append(Residual("texels_seen", 100.0 * seen / max(charts, 1), "percent"))
    parts = parts_atlas(generic, params.size)
    skin_rgb = face_rgb(generic, baked.rgb)
    whites, iris_rgb = observed_eye_colours(photos, proposals, head, skin_rgb)
    paint_parts(generic, parts, baked.rgb, joined.vertices_m, skin_rgb, iris_rgb, head.iris_radius_m, whites, rng)
    baked = replace(baked, rgb=clean_lids(generic, baked.rgb, joined.vertices_m))
    atlas = TextureAtlas(pad_charts(baked.rgb, baked.covered), baked.seen * np.uint8(255))
    tick(1.0)
    lit = (match_light_of_body(s, joined.vertices_m, worn_rgb, surfaces) if s.kind == "cloth" else s for s in shells)
    painted = assemble(joined, tuple(lit), atlas)
    return StageResult({"painted": painted, "surfaces": surfaces}, tuple(residuals), warnings)


def before_painting(
    generic: GenericHuman, photos: PhotoSet, proposals: Proposals, joined: Joined, shells: tuple[Shell, ...]
) -> tuple[PhotoSet, Proposals, Joined, tuple[Shell, ...]]:
    """Return photos without noise and, as their proposals, without glasses, the person tucked in below the shells that
    hide it, and those shells.
    """
    photos = denoised(photos)
    if wears_glasses(proposals):
        glasses = next((shell for shell in shells if shell.kind == "glasses"), None)
        photos, proposals = remove_glasses(generic, joined, photos, proposals, glasses)
    hiding = tuple(shell for shell in shells if shell.kind in ("hair", "cloth", "beard"))  # lenses are clear
    tucked = replace(joined, vertices_m=tuck_scalp(generic, joined.vertices_m, hiding))
    return photos, proposals, tucked, hiding


def observed_eye_colours(
    photos: PhotoSet, proposals: Proposals, head: HeadFit, skin_rgb: Array
) -> tuple[Array | None, Array]:
    """Return how much lighter the whites are than the skin in the face's front photo, None without one, and the irises'
    colour (3,) relative to the atlas's skin.
    """
    proposal = proposals.views.get(ViewId.FACE_FRONT)
    if proposal is None or proposal.face_presence == 0.0 or ViewId.FACE_FRONT not in photos.photos:
        return None, head.iris_rgb
    seen = photos.photos[ViewId.FACE_FRONT].rgb, proposal.labels, proposal.face_px, proposal.irises_px
    shown_rgb = skin_around_eyes(*seen)
    iris_rgb = head.iris_rgb if shown_rgb is None else np.minimum(head.iris_rgb * skin_rgb / shown_rgb, 255.0)
    return sclera_to_skin(*seen), iris_rgb


@dataclass(frozen=True, slots=True, eq=False)
class PaintSources:
    """Photos prepared for painting, and where each may paint.

    Attributes
    ----------
    sources : list of Source
    shares : (K, V) float64
        Of every source in every vertex.
    light : (K, V, 3) float64, log gains
    base : (3, V, 3) float32, levels
        The fill of skin, hair and cloth.
    kinds : Materials
    """

    sources: list[Source]
    shares: NDArray[np.float64]
    light: NDArray[np.float64]
    base: NDArray[np.float32]
    kinds: Materials


def paint_atlas(
    generic: GenericHuman,
    photos: PhotoSet,
    proposals: Proposals,
    silhouettes: SilhouetteSet,
    joined: Joined,
    shells: tuple[Shell, ...],
    params: Params,
    tick: Callable[[float], None],
) -> tuple[AtlasInProgress | None, Array, Array, list[Residual]]:
    """Return the atlas painted with the photos, None where no photo shows the body.

    Returned beside it: (V, 6) shares of ``SURFACES`` that the photos show, (V, 3) levels of what is worn, and the
    residuals of painting.
    """
    shared, residuals = prepare_sources(generic, photos, proposals, silhouettes, joined, shells, params, tick)
    if shared is None:
        return None, np.zeros((len(joined.vertices_m), len(SURFACES))), np.zeros_like(joined.vertices_m), residuals
    baked = bake(
        generic, params.size, shared.sources, shared.shares, shared.light, shared.base, shared.kinds, params.limits,
        levels=blend_levels(params.size), tick=lambda part: tick(0.4 + 0.5 * part),
    )  # fmt: skip
    claim = np.max([np.where(source.mirrored, 0.0, source.score) for source in shared.sources], axis=0)
    kinds, worn_rgb = shared.kinds, shared.base[2].astype(np.float64)
    del shared  # its pictures would be the larger part of the memory from here on
    release_free_memory()
    baked = replace(baked, rgb=finish_hands(baked.rgb, claim, kinds))
    return (
        replace(baked, rgb=darken_nostrils(finish_soles(baked.rgb, joined.vertices_m))),
        kinds.surfaces,
        worn_rgb,
        residuals,
    )


def prepare_sources(
    generic: GenericHuman,
    photos: PhotoSet,
    proposals: Proposals,
    silhouettes: SilhouetteSet,
    joined: Joined,
    shells: tuple[Shell, ...],
    params: Params,
    tick: Callable[[float], None],
) -> tuple[PaintSources | None, list[Residual]]:
    """Return the photos prepared for painting, None where no photo shows the body, and residuals of their alignment."""
    tick(0.15)
    sources, residuals = gather_sources(generic, photos, proposals, silhouettes, joined, shells, params.limits)
    if not sources:
        return None, residuals
    sources = align_feature_lines(generic, sources)
    tick(0.4)
    graph = person_graph(generic, joined.vertices_m)
    normals = vertex_normals(joined.vertices_m, body_triangles())
    colours = vertex_colours(sources)
    kinds = find_materials(generic, sources, graph)
    if shows_faces_only(sources):
        kinds = dress_unseen(generic, sources, kinds, joined.vertices_m, graph)
    sources = reject_wrong_parts(generic, sources, kinds)
    kinds = with_surroundings(sources, colours, kinds, graph)
    sources = reject_grazing(generic, sources, colours, kinds)
    light = normalise_photos(generic, sources, colours, normals, kinds, graph)
    sources = reject_slanted(generic, sources, normalised_colours(colours, light), graph)
    light = match_borders(generic, sources, colours, light, kinds, graph)
    residuals += compare_photos(sources, colours, light)
    base = fill_surface(generic, sources, normalised_colours(colours, light), kinds, graph)
    if shows_faces_only(sources):
        base = extend_clothes(generic, sources, base, kinds, joined.vertices_m, graph)
        kinds = replace(kinds, surfaces=kinds.surfaces * nearness_to_seen(sources, graph)[:, None])
    shares = blend_shares(generic, sources, graph, band_m=params.band_m, head_band_m=params.head_band_m)
    return PaintSources(sources, shares, light, base, kinds), residuals


def parts_atlas(generic: GenericHuman, size: int) -> AtlasMap:
    """Return the atlas of parts that are painted without photos: eyes, mouth and lashes."""
    body = generic.skin[generic.triangles()[0][:, 0]]
    return generic_atlas(generic, size, wanted=~body)


def pad_charts(rgb: NDArray[np.uint8], covered: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return the atlas with every texel near the charts filled from its nearest chart.

    A renderer's smaller mip levels average over chart borders; without the padding they would draw seams.
    """
    tiles = cut_tiles(len(rgb))

    def pad(tile: Tile) -> NDArray[np.uint8]:
        window = tile.outer
        part = np.s_[window.top : window.top + window.height, window.left : window.left + window.width]
        return (spread_nearest(rgb[part], covered[part]) if covered[part].any() else rgb[part])[tile.inner]

    padded = np.empty_like(rgb)
    for tile, part in zip(tiles, parallel_map(pad, tiles), strict=True):
        padded[tile.place] = part
    return padded


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
