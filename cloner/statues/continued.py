"""A photograph as the texture of a whole mesh: visible texels from the photo, the rest extrapolated."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.bodies.bared import grain_by_example
from cloner.geometry.charts.atlas import AtlasMap, map_atlas
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.rasters import nearest_depth
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.records.meshes import Mesh
from cloner.records.views import Camera
from cloner.stages.textures import pad_charts
from cloner.vision.retouching.aligning import sample

Pixels = NDArray[np.uint8]
Values = NDArray[np.float32]

#: Surfaces are believed from the first cosine to the camera on, wholly from the second; as photos paint clones.
GRAZING: Final = (0.15, 0.45)
#: Depth pictures and outlines are found at this long side, pixels.
SMALL_PX: Final = 512
#: What lies so much behind the nearest surface is hidden, share of the seen depth; slanted surfaces may lie so many
#: small pixels' slopes deeper.
BEHIND, SLOPES = 0.02, 2.5
#: Around the markers the photo is believed wholly up to the first distance, beyond the second not at all: the mesh is
#: not fitted there; shares of the markers' extent.
TRUSTED: Final = (0.5, 0.9)
#: The tone of the nearest seen place pulls so much beside a seen vertex itself, and edges' stiffness: borders of what
#: meets behind are soft.
NEAREST, STIFF = 0.2, 3.0
#: So many rings at the rim of a kind say nothing of what goes on in it.
RIM: Final = 2
#: A vertex counts as seen from this weight on.
SEEN: Final = 0.5
#: Rounds of the cut between thing and background.
CUTS: Final = 3


@dataclass(frozen=True, slots=True, eq=False)
class ContinuedTexture:
    """A texture, and which part of it a photo shows.

    Attributes
    ----------
    rgb : (S, S, 3) uint8
    seen : (S, S) uint8
        255 where the photo was taken as it is, 0 where it was continued.
    """

    rgb: Pixels
    seen: Pixels


@dataclass(frozen=True, slots=True, eq=False)
class _PhotoVisibility:
    """The photo and what tells whether a place is seen in it."""

    photo: Pixels
    camera: Camera
    nearest_m: Values
    own: Values
    scale: float
    tolerance_m: float

    def weight(self, places_m: Array, normals: Array) -> tuple[Values, Array]:
        """Return the visibility (N,) of points (N, 3), 0..1, and their pixels (N, 2)."""
        pixel = self.camera.project(places_m)
        towards = self.camera.position_m - places_m
        towards /= np.linalg.norm(towards, axis=1, keepdims=True)
        cosine = np.einsum("na,na->n", towards, normals) / np.maximum(np.linalg.norm(normals, axis=1), 1e-9)
        weight = np.clip((cosine - GRAZING[0]) / (GRAZING[1] - GRAZING[0]), 0.0, 1.0)
        size = (self.photo.shape[1] - 1, self.photo.shape[0] - 1)
        weight *= ((pixel >= 0) & (pixel <= size)).all(axis=1)
        small = (pixel + 0.5) * self.scale - 0.5
        depth = self.camera.to_camera(places_m)[:, 2]
        slant = np.sqrt(1.0 - np.clip(cosine, GRAZING[0], 1.0) ** 2) / np.clip(cosine, GRAZING[0], 1.0)
        allowed = self.tolerance_m + SLOPES * slant * depth / (self.camera.focal_px * self.scale)
        weight *= depth < sample(self.nearest_m, small)[:, 0] + allowed
        return np.asarray(weight * sample(self.own, small)[:, 0], np.float32), pixel


def laid_photo(
    mesh: Mesh, vertices_m: Array, camera: Camera, photo: Pixels, size: int, near: Array
) -> ContinuedTexture:
    """Return the texture of a mesh that a photo shows.

    Texels take the photo where it shows them squarely, or their twins' where the mesh knows twins. From there the tone
    goes on harmonically over the surface, with grain by example of what is seen (Heitz and Neyret 2018).

    Parameters
    ----------
    mesh : Mesh
    vertices_m : (V, 3)
        Of the bent mesh.
    camera : Camera
    photo : (H, W, 3) uint8
    size : int
        Side, texels.
    near : (V,)
        How far the photo is to be believed at all, 0..1; :func:`photo_trust`.
    """
    atlas = map_atlas(mesh.uv, mesh.uv_triangles, mesh.triangles, size)
    normals = vertex_normals(vertices_m, mesh.triangles)
    sight = _sight(mesh, vertices_m, camera, photo)
    texels, weight = _from_photo(sight, atlas, vertices_m, normals, near)
    if len(mesh.mirror):
        twin, beside = _from_photo(sight, atlas, vertices_m[mesh.mirror], normals[mesh.mirror], near[mesh.mirror])
        left = ((1.0 - weight) * beside)[:, None]
        texels, weight = weight[:, None] * texels + left * twin, weight + left[:, 0]
        texels /= np.maximum(weight, 1e-6)[:, None]
    of_vertex, seen = _vertex_tones(sight, mesh, vertices_m, normals, near)
    tone = _carried(mesh, vertices_m, of_vertex, seen)
    rgb = np.zeros((size * size, 3), np.uint8)
    laid = weight[:, None] * texels + (1.0 - weight)[:, None] * atlas.interpolate(tone)
    rgb[atlas.texel] = np.clip(np.rint(laid), 0, 255)
    rows = np.flatnonzero(weight < 1.0)
    gain = grain_by_example(rgb.reshape(size, size, 3), atlas, rows, seen >= SEEN, np.random.default_rng(0))
    share = (1.0 - weight[rows])[:, None]
    rgb[atlas.texel[rows]] = np.clip(np.rint(laid[rows] * np.exp(share * gain)), 0, 255)
    shown = np.zeros(size * size, np.uint8)
    shown[atlas.texel] = np.rint(255.0 * weight)
    return ContinuedTexture(pad_charts(rgb.reshape(size, size, 3), atlas.covered()), shown.reshape(size, size))


def photo_trust(vertices_m: Array, markers_m: Array) -> Array:
    """Return the reliability (V,) of a photo at vertices (V, 3): 1 near the markers (K, 3)."""
    away = cKDTree(markers_m).query(vertices_m)[0] / float(np.ptp(markers_m, axis=0).max())
    return np.asarray(np.clip((TRUSTED[1] - away) / (TRUSTED[1] - TRUSTED[0]), 0.0, 1.0))


def _from_photo(
    sight: _PhotoVisibility, atlas: AtlasMap, vertices_m: Array, normals: Array, near: Array
) -> tuple[Values, Values]:
    """Return colours (N, 3) of the photo at all texels and how far they are to be believed (N,)."""
    places = atlas.interpolate(vertices_m).astype(np.float64)
    weight, pixel = sight.weight(places, atlas.interpolate(normals).astype(np.float64))
    return sample(sight.photo, pixel), weight * atlas.interpolate(near)


def _sight(mesh: Mesh, vertices_m: Array, camera: Camera, photo: Pixels) -> _PhotoVisibility:
    height, width = photo.shape[:2]
    scale = min(1.0, SMALL_PX / max(height, width))
    wide, high = max(8, round(scale * width)), max(8, round(scale * height))
    depth = camera.to_camera(vertices_m)[:, 2]
    pixel = (camera.project(vertices_m) + 0.5) * scale - 0.5
    nearest = nearest_depth(pixel, depth, mesh.triangles, wide, high)
    covered = np.isfinite(nearest)
    seen_m = nearest[covered]
    span = float(np.ptp(vertices_m, axis=0).min()) if not seen_m.size else float(seen_m.max() - seen_m.min())
    own = _thing(cv2.resize(photo, (wide, high), interpolation=cv2.INTER_AREA), covered)
    grown = cv2.erode(np.where(covered, nearest, np.float32(1e6)), np.ones((3, 3), np.uint8))
    return _PhotoVisibility(photo, camera, grown, own, scale, BEHIND * max(span, 1e-6))


def _thing(small: Pixels, covered: NDArray[np.bool_]) -> Values:
    """Return (h, w) 1 where the photo shows the thing and not what is behind it, by colours (GrabCut).

    References
    ----------
    Rother, Kolmogorov, Blake, "GrabCut", SIGGRAPH 2004.
    """
    reach = max(3, round(0.04 * max(small.shape[:2])))
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach + 1, 2 * reach + 1))
    solid = covered.astype(np.uint8)
    inner, outer = cv2.erode(solid, kernel) > 0, cv2.dilate(solid, kernel) > 0
    if not inner.any() or outer.all():
        return np.ones(covered.shape, np.float32)
    known = np.where(covered, cv2.GC_PR_FGD, cv2.GC_PR_BGD).astype(np.uint8)
    known[inner], known[~outer] = cv2.GC_FGD, cv2.GC_BGD
    cv2.setRNGSeed(0)  # the cut begins with random means: the same photo, the same cut
    cv2.grabCut(small, known, None, np.zeros((1, 65)), np.zeros((1, 65)), CUTS, cv2.GC_INIT_WITH_MASK)
    own = np.isin(known, (cv2.GC_FGD, cv2.GC_PR_FGD)).astype(np.uint8)
    inside = cv2.distanceTransform(own, cv2.DIST_L2, 3) - 1.0  # the rim is mixed with what is behind
    return np.asarray(np.clip(inside / 2.0, 0.0, 1.0), np.float32)


def _vertex_tones(
    sight: _PhotoVisibility, mesh: Mesh, vertices_m: Array, normals: Array, near: Array
) -> tuple[Array, Array]:
    """Return colours (V, 3) of the photo round every vertex and its twin, and how well either is seen (V,)."""
    soft = cv2.GaussianBlur(sight.photo, (0, 0), max(1.0, 1.5 / sight.scale))
    weight, pixel = sight.weight(vertices_m, normals)
    colours, total = sample(soft, pixel).astype(np.float64), weight * near
    if len(mesh.mirror):
        beside = (1.0 - total) * total[mesh.mirror]
        both = np.maximum(total + beside, 1e-9)[:, None]
        colours = (total[:, None] * colours + beside[:, None] * colours[mesh.mirror]) / both
        total = total + beside
    return colours, total


def _carried(mesh: Mesh, vertices_m: Array, colours: Array, seen: Array) -> Array:
    """Return (V, 3) levels: seen ones carried on from the nearest of their kind; other pieces get the usual one."""
    sure = seen >= SEEN
    usual = np.median(colours[sure], axis=0) if sure.any() else np.full(3, 128.0)
    graph, kind = surface_graph(vertices_m, mesh.triangles), np.resize(mesh.kind, len(vertices_m))
    values = np.tile(usual, (len(vertices_m), 1))
    for one in np.unique(kind):
        known = sure & (graph.smooth((kind == one).astype(np.float64), RIM) > 0.999)  # its rim is mixed with others
        nearest = graph.nearest(known if known.any() else sure)[kind == one]
        values[kind == one] = np.where(sure[nearest, None], colours[nearest], usual)
    return np.asarray(np.exp(graph.fill(np.log(values + 1.0), np.where(sure, seen, NEAREST), STIFF)) - 1.0)
