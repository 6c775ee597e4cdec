"""Skin painted where clothes were: the person's own skin tone, with synthesised grain."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.bodies.bare import HEAD, NAPE, usual_skin, vertex_rgb
from cloner.bodies.skin import draw_underwear, grain
from cloner.generic.charts import generic_atlas, person_graph
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.charts.atlas import AtlasMap
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.records.arrays import Array
from cloner.records.clones import Clone, TextureAtlas
from cloner.stages.textures import pad_charts

Flags = NDArray[np.bool_]

#: The own skin fades into what is painted over this, metres.
FADE_M: Final = 0.025
#: Far from seen skin all has the usual tone: its weight beside a seen vertex, and edges' stiffness.
USUAL, STIFF = 0.004, 3.0
#: The patch that grain is taken from: side and what is coarser than grain, at 2,048 texels a side.
PATCH, COARSE = 48, 3.0
#: Uneven tone beside the grain, a share of the light; taste.
UNEVEN: Final = 0.006
#: Grain is no stronger than so many of its spreads: a hair or a crease is none.
STRONGEST: Final = 2.0


def paint_bare_skin(clone: Clone, bare: Flags, sex: str, rng: np.random.Generator) -> TextureAtlas:
    """Return the clone's texture with skin where it was dressed, and underwear.

    Parameters
    ----------
    clone : Clone
    bare : (V,) bool
        As :func:`cloner.bodies.bare.bare_skin` gives it.
    sex : str
        Women wear two pieces, men one.
    rng : numpy.random.Generator
    """
    generic, rgb = load_generic(), clone.atlas.rgb.copy()
    atlas = generic_atlas(generic, len(rgb))
    graph = person_graph(generic, clone.vertices_m)
    body = generic.skin
    kept = np.where(body, np.clip(graph.distance_from(body & ~bare, FADE_M) / FADE_M, 0.0, 1.0), 1.0)
    share = atlas.interpolate(kept)[:, None]
    rows = np.flatnonzero(share[:, 0] < 1.0)
    texels = rgb.reshape(-1, 3)[atlas.texel].astype(np.float32)
    places = atlas.interpolate(generic.vertices_m.astype(np.float64), rows)
    gain = (
        grain_by_example(rgb, atlas, rows, bare & (generic.head_blend < NAPE), rng)
        + UNEVEN * grain(places, rng)[:, None]
    )
    painted = atlas.interpolate(_tone(generic, clone, graph, bare), rows) * np.exp(gain)
    texels[rows] = share[rows] * texels[rows] + (1.0 - share[rows]) * painted
    draw_underwear(texels, generic, sex, atlas)
    rgb.reshape(-1, 3)[atlas.texel] = np.clip(np.rint(texels), 0, 255).astype(np.uint8)
    coverage = clone.atlas.coverage.copy()
    coverage.reshape(-1)[atlas.texel[share[:, 0] < 0.5]] = 0
    return TextureAtlas(pad_charts(rgb, atlas.covered()), coverage)


def _tone(generic: GenericHuman, clone: Clone, graph: SurfaceGraph, bare: Flags) -> Array:
    """Return (V, 3) levels: seen skin carried on, and the person's usual tone far from it."""
    colours = vertex_rgb(generic, clone.atlas.rgb)
    seen = bare & (generic.head_blend < HEAD)  # a face is redder than a body, and a chin's shade no chest's
    usual = usual_skin(generic, colours, bare)
    weight = np.where(seen, 1.0, USUAL)
    values = np.where(seen[:, None], colours, usual)
    carried = graph.fill(np.log(values + 1.0), weight, STIFF)
    return np.asarray(np.exp(carried) - 1.0)


def grain_by_example(
    rgb: NDArray[np.uint8], atlas: AtlasMap, rows: NDArray[np.int64], bare: Flags, rng: np.random.Generator
) -> NDArray[np.float32]:
    """Return (N, 3) logarithmic gains of N rows of the atlas, made by example of a patch of what is bare, (V,).

    Three random cuts of the patch overlap at every texel, weighted so that their spread stays the patch's.

    References
    ----------
    E. Heitz, F. Neyret, High-Performance By-Example Noise, HPG 2018.
    """
    patch = _patch(rgb, atlas, bare)
    if patch is None:
        return np.zeros((len(rows), 3), np.float32)
    side = len(patch)
    cell = side / 3.0
    row, column = np.divmod(atlas.texel[rows], atlas.shape[1])
    skewed = np.stack([row / cell - column / (cell * np.sqrt(3.0)), column * 2.0 / (cell * np.sqrt(3.0))], axis=1)
    whole = np.floor(skewed).astype(np.int64)
    part = skewed - whole
    lower = part.sum(axis=1) < 1.0
    corners = [np.where(lower[:, None], (0, 0), (1, 1)), np.array([[1, 0]]), np.array([[0, 1]])]
    first = np.where(lower, 1.0 - part.sum(axis=1), part.sum(axis=1) - 1.0)
    others = [np.where(lower, part[:, k], 1.0 - part[:, 1 - k]) for k in (0, 1)]
    jump = rng.integers(0, side, (64, 64, 2))
    total = np.zeros((len(row), 3))
    for corner, weight in zip(corners, (first, *others), strict=True):
        at = whole + corner
        off = jump[at[:, 0] % 64, at[:, 1] % 64]
        total += weight[:, None] * patch[(row + off[:, 0]) % side, (column + off[:, 1]) % side]
    spread = np.sqrt(first**2 + others[0] ** 2 + others[1] ** 2)
    return np.asarray(total / spread[:, None], np.float32)


def _patch(rgb: NDArray[np.uint8], atlas: AtlasMap, bare: Flags) -> Array | None:
    """Return (P, P, 3) logarithmic grain of a patch of the body's bare skin that is as grainy as most,"""
    size = len(rgb)
    side, coarse = max(8, PATCH * size // 2048), max(1.0, COARSE * size / 2048.0)
    own = np.zeros((size, size), np.float32)
    own.reshape(-1)[atlas.texel] = atlas.interpolate(bare.astype(np.float64)) > 0.999
    light = np.log(rgb.astype(np.float32) + 1.0)
    fine = light - cv2.GaussianBlur(light, (0, 0), coarse)
    whole = cv2.boxFilter(own, -1, (side, side)) > 0.999
    strength = cv2.boxFilter((fine**2).mean(axis=2), -1, (side, side))
    if not whole.any():
        return None
    rows, columns = np.nonzero(whole)
    usual = np.argsort(strength[rows, columns], kind="stable")[len(rows) // 2]
    top, left = rows[usual] - side // 2, columns[usual] - side // 2
    found = fine[top : top + side, left : left + side].astype(np.float64)
    found -= found.mean(axis=(0, 1))
    most = STRONGEST * found.std(axis=(0, 1))
    return np.asarray(np.clip(found, -most, most))
