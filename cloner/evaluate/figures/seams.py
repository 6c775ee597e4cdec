"""Seams of a clone's texture: colour jumps across borders that the photos do not show."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.evaluate.measures.posing import pose_clone
from cloner.evaluate.measures.rulers import colour_jumps, seam_ratio
from cloner.frames import ViewId
from cloner.generic.charts import vertex_uv
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import surface_normals
from cloner.geometry.cameras.visibility import compute_visibility
from cloner.geometry.charts.atlas import colours_at
from cloner.geometry.meshes.triangles import edges_of
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.vision.retouching.aligning import sample

Mask = NDArray[np.bool_]
Edges = NDArray[np.int64]
Photos = Mapping[ViewId, NDArray[np.uint8]]

#: Share of a unit normal along z from which a surface counts as clearly front or back; taste.
_CLEARLY: Final = 0.35
#: Cosine from which a photo shows what the surface looks like.
_SEEN: Final = 0.3
_NO_PHOTOS: Final[Photos] = MappingProxyType({})


def seam_ratios(clone: Clone, generic: GenericHuman, photos: Photos = _NO_PHOTOS) -> dict[str, float | None]:
    """Return the colour jump across three borders relative to inside the surface.

    Parameters
    ----------
    clone : Clone
    generic : GenericHuman
    photos : mapping of ViewId to (H, W, 3) uint8
        Those the clone was made from. What jumps in them by itself, a collar's edge or the shade below it, is no seam:
        where there are photos, only edges that one of them shows count (on the far side their twins), and the ratio
        is divided by the photos' own.

    Returns
    -------
    dict
        ``front_back`` (where the rest pose's normals turn from front to back),
        ``head_body`` (neck) and ``face_front_side`` (normals 45° from the front); None where no edge is left.

    Notes
    -----
    Edges beside another region are left out on both sides of the ratio: a white collar on a neck is no seam.
    """
    edges = _edges(clone, generic)
    if not photos:
        jumps = colour_jumps(_vertex_colours(clone, generic), edges)
        return {where: seam_ratio(jumps, *border) for where, border in _border_edges(clone, generic, edges).items()}
    shown = _photo_jumps(clone, generic, photos, edges)
    edges, shown = edges[~np.isnan(shown)], shown[~np.isnan(shown)]
    jumps = colour_jumps(_vertex_colours(clone, generic), edges)
    found: dict[str, float | None] = {}
    for where, border in _border_edges(clone, generic, edges).items():
        own, true = seam_ratio(jumps, *border), seam_ratio(shown, *border)
        found[where] = None if own is None or true is None else own / max(true, 1e-6)
    return found


def _edges(clone: Clone, generic: GenericHuman) -> Edges:
    """Return (E, 2) the edges of the skin, those beside another region left out."""
    triangles = generic.triangles()[0]
    edges = edges_of(triangles)[0]
    skin = generic.skin
    skin &= ~generic.region("mouth_interior")
    edges = edges[skin[edges].all(axis=1)]
    if not len(clone.triangle_regions):
        return np.asarray(edges)
    region = _vertex_region(clone, triangles)
    return np.asarray(edges[(region[edges[:, 0]] == region[edges[:, 1]]) & (region[edges[:, 0]] >= 0)])


def _border_edges(clone: Clone, generic: GenericHuman, edges: Edges) -> Mapping[str, tuple[Mask, Mask]]:
    """Return by border which edges cross it and which lie beside it."""
    normals = surface_normals(clone.vertices_m)
    head = generic.head_blend > 0.5 if len(generic.head_blend) else np.zeros(len(normals), dtype=bool)
    face = generic.region("face") if "face" in generic.region_names else head
    ahead, aside = normals[:, 2], np.abs(normals[:, 0]) > np.abs(normals[:, 2])
    trunk: Mask = np.asarray(~head[edges].any(axis=1))
    on_face: Mask = np.asarray(face[edges].all(axis=1))
    clear: Mask = np.asarray((np.abs(ahead[edges]) > _CLEARLY).all(axis=1))
    return {
        "front_back": (trunk & _ends_differ(ahead > 0.0, edges), trunk & clear),
        "head_body": (_ends_differ(head, edges), _neck(generic)[edges].all(axis=1) & ~_ends_differ(head, edges)),
        "face_front_side": (on_face & _ends_differ(aside, edges), on_face & ~_ends_differ(aside, edges)),
    }


def _photo_jumps(clone: Clone, generic: GenericHuman, photos: Photos, edges: Edges) -> Array:
    """Return (E,) the jumps that the photo shows which sees both ends best; nan where none sees an edge or its twin."""
    triangles = generic.triangles()[0]
    skin = generic.skin[triangles[:, 0]]
    found, best = np.full(len(edges), np.nan), np.full(len(edges), _SEEN)
    for view, photo in photos.items():
        if view not in clone.views:
            continue
        seen = clone.views[view]
        visibility = compute_visibility(
            pose_clone(clone, generic, seen.rotations).vertices_m, triangles[skin].astype(np.int32), seen.camera
        )
        cosine = np.where(visibility.visible_vertices(), visibility.cosine, -1.0)
        both = cosine[edges].min(axis=1)
        jump = colour_jumps(sample(photo, visibility.pixel_px), edges)
        found, best = np.where(both > best, jump, found), np.maximum(both, best)
    return np.where(np.isnan(found), found[_mirrored_edges(generic, edges)], found)


def _mirrored_edges(generic: GenericHuman, edges: Edges) -> NDArray[np.intp]:
    """Return (E,) the number of every edge's mirror image, its own where there is none among them."""
    size = len(generic.vertex_part)
    key = edges[:, 0] * size + edges[:, 1]
    twin = np.sort(generic.mirror.astype(np.int64)[edges], axis=1)
    wanted = twin[:, 0] * size + twin[:, 1]
    place = np.clip(np.searchsorted(key, wanted), 0, len(key) - 1)
    return np.where(key[place] == wanted, place, np.arange(len(key)))


def _vertex_region(clone: Clone, triangles: NDArray[np.integer]) -> NDArray[np.int64]:
    """Return (V,) the region of all triangles around each vertex, -1 where they differ."""
    least, most = np.full(len(clone.vertices_m), 255), np.full(len(clone.vertices_m), -1)
    labels = clone.triangle_regions.astype(np.int64)
    for corner in triangles.T:
        np.minimum.at(least, corner, labels)
        np.maximum.at(most, corner, labels)
    return np.where(least == most, most, -1)


def _ends_differ(label: Mask, edges: Edges) -> Mask:
    return np.asarray(label[edges[:, 0]] != label[edges[:, 1]])


def _neck(generic: GenericHuman) -> Mask:
    """Return the vertices around the border of head and body."""
    if "neck" in generic.region_names:
        return np.asarray(generic.region("neck"))
    return np.asarray((generic.head_blend > 0.05) & (generic.head_blend < 0.95))


def _vertex_colours(clone: Clone, generic: GenericHuman) -> NDArray[np.uint8]:
    """Return (V, 3) atlas colours at one texture coordinate of each vertex."""
    return colours_at(clone.atlas.rgb, vertex_uv(generic))
