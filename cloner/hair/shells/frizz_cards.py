"""Cards of single hairs that stand out of the hair's shell, as many and as long as photos show beyond its outline.

References
----------
Fins of fur after Lengyel, Praun, Finkelstein, Hoppe 2001 ("Real-time fur over arbitrary surfaces"), here as cards that
stand fast, as games build hair, because silhouettes from all sides shall have them without a shader of their own.
"""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.frames import m_from_mm, mm_from_m
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.shells.frizz import Frizz
from cloner.hair.volumes.cap import VOTE_MM, surface_mm
from cloner.records.arrays import Array
from cloner.records.heads import Shell
from cloner.vision.photographs.blending import Image

#: Hairs on a card, and how thick a tuft of them is, mm; taste.
TUFTS: Final = 10
TUFT_MM: Final = 0.7
#: Cards are so many mean lengths high: e**-3 of the hairs are longer. They begin this deep in the shell, mm.
LENGTHS: Final = 3.0
ROOT_MM: Final = 2.0
#: No card stands nearer to where hair ends than this, mm; taste: hairlines are painted soft already.
INSIDE_MM: Final = 11.0
#: How far cards lean off the normal, tangent of the usual angle; taste.
LEAN: Final = 0.45
#: The shell ends where frizz is so deep (nine tenths are hair); hair above skin stays this thick, mm.
DENSE: Final = 2.3
THINNEST_MM: Final = 3.0
#: Cards touch no skin: their upper halves stay so far from it, mm.
CLEAR_MM: Final = 4.0
#: Cards of one shape and colour share a tile; texels of a tile's side, shapes and colours.
TILE: Final = 128
SHAPES: Final = 4
COLOURS: Final = 4
FINER: Final = 3  # tufts are drawn so many times finer
WAVES, SWING = 1.5, 0.18  # a tuft's waves, and their width against its length; taste
MOST: Final = 1500
SEED: Final = 1


def frizz_shell(
    frizz: Frizz, hair: Shell, grown: tuple[Array, NDArray[np.int32], Array], skin: tuple[Array, Array]
) -> Shell | None:
    """Return the cards of a hair's shell, None where there is room for none.

    Parameters
    ----------
    frizz : Frizz
    hair : Shell
        Gives weights and colours.
    grown : vertices (N, 3) at rest, m, triangles (T, 3), and how far inside the hairline the vertices lie (N,), mm
        The part of the shell that hairs stand on.
    skin : vertices (M, 3) and their normals
    """
    vertices_m, triangles, inside_mm = grown
    rng = np.random.default_rng(SEED)
    high_mm = LENGTHS * frizz.length_mm
    roots_m, normals = _roots(frizz, vertices_m, triangles, inside_mm, rng)
    lean = normals + LEAN * rng.standard_normal(roots_m.shape)
    up = lean / np.linalg.norm(lean, axis=1, keepdims=True)
    across = np.cross(up, rng.standard_normal(roots_m.shape))
    across *= m_from_mm(0.5 * high_mm) / np.linalg.norm(across, axis=1, keepdims=True)
    low, top = roots_m - up * m_from_mm(ROOT_MM), roots_m + up * m_from_mm(high_mm)
    corners = np.stack([low - across, low + across, top + across, top - across], axis=1)
    above = np.concatenate([corners[:, 2:], 0.5 * (corners[:, :2] + corners[:, :1:-1])], axis=1)
    away_mm = surface_mm(*skin, above.reshape(-1, 3))[0].reshape(len(roots_m), -1)
    clear = (np.einsum("nk,nk->n", up, normals) > 0.0) & (away_mm > CLEAR_MM).all(axis=1)
    roots_m, corners = roots_m[clear], corners[clear]
    if not len(roots_m):
        return None
    nearest = np.asarray(cKDTree(hair.vertices_m).query(roots_m)[1], np.int64)
    colours, place = _palette(_texels(hair, nearest))
    shape = rng.integers(SHAPES, size=len(roots_m))
    count, first = len(roots_m), 4 * np.arange(len(roots_m), dtype=np.int32)[:, None]
    margin = 0.5 / TILE
    square = np.array([(margin, 1 - margin), (1 - margin, 1 - margin), (1 - margin, margin), (margin, margin)])
    uv = (np.stack([shape, place], axis=1)[:, None] + square) / (SHAPES, COLOURS)
    faces = np.concatenate([first + (0, 1, 2), first + (0, 2, 3)]).astype(np.int32)
    joints, weights = np.repeat(hair.skin_joints[nearest], 4, axis=0), np.repeat(hair.skin_weights[nearest], 4, axis=0)
    picture = tuft_tiles(high_mm, frizz.length_mm, colours, rng)
    return Shell(corners.reshape(4 * count, 3), faces, uv.reshape(-1, 2), joints, weights, picture, "frizz")


def make_room(
    frizz: Frizz, vertices_m: Array, triangles: NDArray[np.int32], inside_mm: Array, skin: tuple[Array, Array]
) -> tuple[Array, Frizz]:
    """Return a shell (N, 3) drawn in to where hair is dense, and the frizz that stands on it; arguments as above.

    An outline is where half of the pixels are hair: a wall there would be a helmet with wires on it.
    """
    dense = Frizz(max(DENSE, frizz.depth), frizz.length_mm)
    deep_mm = frizz.length_mm * float(np.log(dense.depth / frizz.depth))
    room_mm = np.maximum(surface_mm(*skin, vertices_m)[0] - THINNEST_MM, 0.0)
    sunk = np.minimum(deep_mm * np.clip(inside_mm / VOTE_MM, 0.0, 1.0), room_mm)
    return vertices_m - vertex_normals(vertices_m, triangles) * m_from_mm(1.0) * sunk[:, None], dense


def cards_a_mm2(frizz: Frizz, radius_mm: float) -> float:
    """Return how many cards a square millimetre of a round head make its outline as hairy as measured.

    A line of sight that touches a sphere of radius R passes n cards a mm2 of width w and cover c, hairs of mean length
    l, over a way of sqrt(2 pi R l): its depth is n w 2/pi c sqrt(2 pi R l).
    """
    way_mm = float(np.sqrt(2.0 * np.pi * radius_mm * frizz.length_mm))
    return float(frizz.depth / (TUFTS * TUFT_MM * (2.0 / np.pi) * way_mm))


def _roots(
    frizz: Frizz, vertices_m: Array, triangles: NDArray[np.int32], inside_mm: Array, rng: np.random.Generator
) -> tuple[Array, Array]:
    """Return places (K, 3) strewn evenly over the shell, where it is far enough from the hairline, and normals."""
    corners = vertices_m[triangles]
    areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    areas *= (inside_mm[triangles] >= INSIDE_MM).all(axis=1)
    total_mm2 = mm_from_m(mm_from_m(float(areas.sum())))
    radius_mm = 0.5 * mm_from_m(float(np.ptp(vertices_m[:, 0])))
    count = min(round(cards_a_mm2(frizz, radius_mm) * total_mm2), MOST) if total_mm2 > 0.0 else 0
    # Evenly along the running sum of areas: triangles of one neighbourhood follow each other.
    steps = (np.arange(count) + rng.random(count)) / max(count, 1) * areas.sum()
    row = np.minimum(np.searchsorted(np.cumsum(areas), steps), len(areas) - 1)
    share = np.sort(rng.random((count, 2)), axis=1)
    bary = np.stack([share[:, 0], share[:, 1] - share[:, 0], 1.0 - share[:, 1]], axis=1)
    normals = np.einsum("nk,nkc->nc", bary, vertex_normals(vertices_m, triangles)[triangles[row]])
    places = np.einsum("nk,nkc->nc", bary, corners[row])
    return places, unit(normals)


def _texels(hair: Shell, rows: NDArray[np.int64]) -> Array:
    """Return (N, 3) the shell's colours at some of its vertices, levels, over a few texels' neighbourhood."""
    height, width = hair.rgba.shape[:2]
    smooth = cv2.blur(hair.rgba[..., :3], (5, 5))
    column, line = ((hair.uv[rows] * (width, height)).astype(int).clip(0, (width - 1, height - 1))).T
    return np.asarray(smooth[line, column], np.float64)


def _palette(rgb: Array) -> tuple[Array, NDArray[np.int64]]:
    """Return (COLOURS, 3) colours by brightness, and which of them each of (N, 3) takes."""
    order = np.argsort(rgb.sum(axis=1), kind="stable")
    place = np.empty(len(rgb), np.int64)
    place[order] = np.arange(len(rgb)) * COLOURS // len(rgb)
    mean = rgb.mean(axis=0)
    return np.stack([rgb[place == k].mean(axis=0) if (place == k).any() else mean for k in range(COLOURS)]), place


def tuft_tiles(high_mm: float, length_mm: float, colours: Array, rng: np.random.Generator) -> NDArray[np.uint8]:
    """Return (COLOURS * TILE, SHAPES * TILE, 4) tufts of hair on cards as wide as high, roots at the lower edge.

    Lengths are exponential, as the share of hair falls with the distance from the outline.
    """
    big = TILE * FINER
    px = big / high_mm
    covers = []
    for _ in range(SHAPES):
        cover = np.zeros((big, big), np.uint8)
        for tuft in range(TUFTS):
            length = float(np.clip(rng.exponential(length_mm), 0.4 * length_mm, high_mm - 1.0)) * px
            along = np.linspace(0.0, 1.0, 24)
            start = (tuft + rng.uniform(0.2, 0.8)) / TUFTS * 0.8 * big + 0.1 * big
            bend, phase, swing = rng.normal(0.0, 0.25), rng.uniform(0.0, 2.0 * np.pi), SWING * rng.uniform(0.4, 1.2)
            wave = swing * np.sin(2.0 * np.pi * WAVES * along + phase) * along
            line = np.stack([start + length * (wave + bend * along**2), big - along * (length + ROOT_MM * px)], axis=1)
            for k in range(len(line) - 1):
                wide = max(round(TUFT_MM * px * (1.0 - 0.6 * along[k])), 1)
                ends = [tuple(int(value) for value in line[j]) for j in (k, k + 1)]
                cv2.line(cover, ends[0], ends[1], 255, wide, cv2.LINE_AA)
        covers.append(cv2.resize(cover, (TILE, TILE), interpolation=cv2.INTER_AREA))
    alpha = np.tile(np.concatenate(covers, axis=1), (COLOURS, 1))
    tiles = np.repeat(np.clip(np.rint(colours), 0, 255).astype(np.uint8), TILE, axis=0)[:, None]
    rgb: Image = np.broadcast_to(tiles, (*alpha.shape, 3))
    return np.dstack([rgb, alpha])
