"""Relief of a statue: cavities of its surface, and details of the photographs as shallow carving."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components

from cloner.geometry.charts.atlas import AtlasMap
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array

Values = NDArray[np.float32]

#: Rounds of averaging that say what lies around a vertex: folds of lids and lips, then sockets and armpits.
ROUNDS: Final = (3, 24)
#: A vertex that so many edge lengths below its neighbourhood is all hollow; read off noses and lids of the samples.
DEEP: Final = 0.30
#: What is finer than the first is grain, what is wider than the second is tone: texels at 2,048 a side.
FINE, WIDE = 0.8, 26.0
#: Differences of the logarithm of light beyond this count hardly more: a dark brow is no gorge; taste.
MOST: Final = 0.35
#: How deep the carving of one step of `MOST` is, metres; taste: seen in raking light, flat from the front.
DEPTH_M: Final = 0.0012
#: Where the light of the carving comes from: above, a little from the front and the person's right.
LIGHT: Final = np.array([-0.35, 0.85, 0.4])


def hollows(vertices_m: Array, triangles: NDArray[np.int32]) -> Array:
    """Return (V,) from -1 on ridges to 1 in hollows, of a mesh (V, 3), (T, 3) of any number of pieces.

    How far the mean of the neighbourhood lies outside the surface, in edge lengths, at two widths.
    """
    graph = surface_graph(vertices_m, triangles)
    count = np.maximum(np.diff(graph.lengths.indptr), 1)
    edge = np.asarray(graph.lengths.sum(axis=1)).ravel() / count
    normals, total = vertex_normals(vertices_m, triangles), np.zeros(len(vertices_m))
    for rounds in ROUNDS:
        off = np.einsum("va,va->v", graph.smooth(vertices_m, rounds) - vertices_m, normals)
        total += np.tanh(off / (DEEP * np.maximum(edge, 1e-6) * np.sqrt(rounds)))
    return np.asarray(np.clip(graph.smooth(total, 1), -1.0, 1.0))


def outwards(vertices_m: Array, triangles: NDArray[np.int32]) -> NDArray[np.int32]:
    """Return the triangles (T, 3) of a mesh, those of a piece turned over whose normals point to its inside."""
    count, piece = connected_components(surface_graph(vertices_m, triangles).lengths, directed=False)
    own = piece[triangles[:, 0]]
    each = np.bincount(piece, minlength=count)
    middle = np.stack([np.bincount(piece, vertices_m[:, k], count) / each for k in range(3)], axis=1)
    a, b, c = (vertices_m[triangles[:, k]] - middle[own] for k in range(3))
    volume = np.bincount(own, np.einsum("ta,ta->t", a, np.cross(b, c)), count)
    return np.where((volume < 0.0)[own, None], triangles[:, ::-1], triangles).astype(np.int32)


def detail(rgb: NDArray[np.uint8], covered: NDArray[np.bool_]) -> Values:
    """Return a texture's detail (S, S) between grain and tone, -1 dark to 1 light; tone is averaged inside charts."""
    scale = len(rgb) / 2048.0
    light = np.log(cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY).astype(np.float32) + 8.0)  # blacks of a photo are noise
    fine = cv2.GaussianBlur(light, (0, 0), max(FINE * scale, 0.3))
    inside = covered.astype(np.float32)
    tone = cv2.GaussianBlur(light * inside, (0, 0), max(WIDE * scale, 1.0))
    tone /= np.maximum(cv2.GaussianBlur(inside, (0, 0), max(WIDE * scale, 1.0)), 1e-3)
    return np.asarray(np.tanh((fine - tone) / MOST), np.float32)  # a padded texture has no rims at its charts' ends


def raked(height: Values, atlas: AtlasMap, uv: Array, uv_triangles: NDArray[np.int32], vertices_m: Array) -> Values:
    """Return the brightening (N,) of each texel of the atlas by carving that faces the light.

    Parameters
    ----------
    height : (S, S) in units of `DEPTH_M`
    atlas : AtlasMap
    uv : (U, 2) in 0..1, uv_triangles : (T, 3)
        Of ``atlas.triangles``, row by row.
    vertices_m : (V, 3)

    References
    ----------
    J. Blinn, Simulation of Wrinkled Surfaces, SIGGRAPH 1978: the normal of a surface that is lifted by h is n - grad h.
    """
    size = len(height)
    corners, flat = vertices_m[atlas.triangles], np.asarray(uv, np.float64)[uv_triangles] * size
    sides, across = corners[:, 1:] - corners[:, :1], flat[:, 1:] - flat[:, :1]  # (T, 2, 3) metres, (T, 2, 2) texels
    turn = across[:, 0, 0] * across[:, 1, 1] - across[:, 0, 1] * across[:, 1, 0]
    sound = np.abs(turn) > 1e-9
    per_texel = np.linalg.solve(np.where(sound[:, None, None], across, np.eye(2)), sides)
    square = per_texel @ per_texel.transpose(0, 2, 1)
    square += 1e-3 * np.trace(square, axis1=1, axis2=2)[:, None, None] * np.eye(2) + 1e-18 * np.eye(2)
    towards = np.linalg.solve(square, per_texel @ (LIGHT / np.linalg.norm(LIGHT))[:, None])[..., 0]
    towards[~sound] = 0.0
    slope_u = cv2.Sobel(height, cv2.CV_32F, 1, 0, scale=0.125).ravel()[atlas.texel]
    slope_v = cv2.Sobel(height, cv2.CV_32F, 0, 1, scale=0.125).ravel()[atlas.texel]
    of_texel = (DEPTH_M * towards).astype(np.float32)[atlas.triangle]
    return np.asarray(np.tanh(-(slope_u * of_texel[:, 0] + slope_v * of_texel[:, 1])), np.float32)
