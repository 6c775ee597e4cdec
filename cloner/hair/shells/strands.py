"""Hair where no photo shows it: extended colours with synthetic strands of the same roughness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.easing import smoothstep
from cloner.geometry.charts.atlas import AtlasMap
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.records.arrays import Array
from cloner.vision.segmentation.pieces import box_around

Picture = NDArray[np.float32]

SEEN_CLAIM: Final = 0.15  # photos that claim less show stretched pixels
FILL_TRUST: Final = (0.25, 0.5)  # colours spread from where a photo claims so much: farther out the wall shines in
FILL_STIFFNESS: Final = 0.05  # taste: pull of known colours against smooth filling
MEMORY_M: Final = 0.05  # taste: a lock's own colour fades into the whole hair's over this way
SMALLEST_M: Final = 0.015  # half the width of gaps that the photos' own neighbours fill well enough
REACH_M, CLAIM = 0.05, 0.7  # the made strands' claim, and how far it fades into what photos show
CROWN: Final = (0.0, 0.85, -0.53)  # anatomy: hair grows from a whorl behind the top
SEED: Final = 1
#: Strands: cells around and down the head, and their part of the roughness: locks, tufts and single strands. Curls are
#: as long as wide.
OCTAVES: Final = ((90, 5, 0.45), (260, 8, 0.6), (720, 12, 0.65))
TURN: Final = 0.03  # radians by which locks swing; more and strands would fold
FINEST_M: Final = 0.0008  # narrower strands are no texels any more
ROUGH_SHARE: Final = 0.02  # of the hair's size: what counts as surroundings of a strand
#: Coherence of curls, and from which on hair is straight (front photos of two generated curly heads and of two crops in
#: public portraits: .16 to .24; of 22 others, waves and spikes among them, .45 and more), by a window of so large a
#: share of the hair, in a picture in which that is so many pixels.
CURLS, STRAIGHT = 0.25, 0.45
WINDOW_SHARE, WINDOW_PX = 0.03, 5.0


@dataclass(frozen=True, slots=True, eq=False)
class Strands:
    """Synthetic hair, as a layer below the photos.

    Attributes
    ----------
    rgb : (N, 3) float32
        Levels of the atlas's texels.
    claim : (V,) float64
        Against the photos' claims, of the shell's vertices.
    """

    rgb: Picture
    claim: Array


def grow_strands(
    atlas: AtlasMap,
    vertices_m: Array,
    graph: SurfaceGraph,
    seen_rgb: Array,
    claim: Array,
    rough_rgb: Array,
    curls: float = 0.0,
) -> Strands:
    """Return strands for a whole shell.

    Parameters
    ----------
    atlas : AtlasMap of the shell
    vertices_m : (V, 3); graph : SurfaceGraph of it
    seen_rgb : (V, 3) levels, mean of the photos
    claim : (V,) of the photo that shows each vertex best, 0..1
    rough_rgb : (3,) levels
        How much the seen hair varies from strand to strand; see :func:`roughness`.
    curls : float in 0..1
        How far from straight the hair is; see :func:`curliness`.
    """
    trust = np.clip((claim - FILL_TRUST[0]) / (FILL_TRUST[1] - FILL_TRUST[0]), 0.0, 1.0)
    mean = (trust[:, None] * seen_rgb).sum(axis=0) / max(float(trust.sum()), 1e-9)
    away = graph.distance_from(trust > 0.5, 10.0 * MEMORY_M)
    near = graph.fill(seen_rgb, trust, FILL_STIFFNESS)
    smooth = mean + (near - mean) * np.exp(-away / MEMORY_M)[:, None]
    noise = strand_noise(atlas.interpolate(vertices_m - _hair_centre(vertices_m)), curls)
    rgb = atlas.interpolate(smooth) + noise[:, None] * rough_rgb.astype(np.float32)
    gap = graph.distance_from(claim >= SEEN_CLAIM, 2.0 * SMALLEST_M) >= SMALLEST_M
    beside = graph.distance_from(gap, SMALLEST_M + REACH_M) - SMALLEST_M
    return Strands(np.clip(rgb, 0.0, 255.0), CLAIM * np.clip(1.0 - beside / REACH_M, 0.0, 1.0))


def roughness(rgb: NDArray[np.uint8], hair: NDArray[np.bool_]) -> Array:
    """Return the standard deviation (3,) of a photo's hair (H, W) from its local mean, levels."""
    box = box_around(hair)
    inner = hair[box].astype(np.float32)
    radius = max(ROUGH_SHARE * float(np.sqrt(inner.sum())), 2.0)
    part = rgb[box].astype(np.float32)
    share = np.maximum(cv2.GaussianBlur(inner, (0, 0), radius), 1e-3)
    around = cv2.GaussianBlur(part * inner[..., None], (0, 0), radius) / share[..., None]
    deep = (share > 0.95) & (inner > 0.5)
    if not deep.any():
        return np.zeros(3)
    return np.asarray((part - around)[deep].std(axis=0), np.float64)


def curliness(rgb: NDArray[np.uint8], hair: NDArray[np.bool_]) -> float:
    """Return 0..1 how curly a photo's hair (H, W) is: curls run in all directions, straight strands in one.

    By the coherence of the structure tensor (J. Bigun, G. Granlund, 1987), on hair of one size in pixels.
    """
    if not hair.any():
        return 0.0
    box = box_around(hair)
    scale = min(WINDOW_PX / (WINDOW_SHARE * float(np.sqrt(hair.sum()))), 1.0)
    rows, columns = (np.count_nonzero(hair.any(axis=axis)) for axis in (1, 0))
    size = max(round(columns * scale), 1), max(round(rows * scale), 1)
    grey = cv2.resize(cv2.cvtColor(rgb[box], cv2.COLOR_RGB2GRAY).astype(np.float32), size, interpolation=cv2.INTER_AREA)
    own = cv2.resize(hair[box].astype(np.uint8), size, interpolation=cv2.INTER_NEAREST)
    inner = cv2.erode(own, np.ones((7, 7), np.uint8), borderValue=0).astype(np.float32)  # not the outline
    right, down = cv2.Sobel(grey, cv2.CV_32F, 1, 0), cv2.Sobel(grey, cv2.CV_32F, 0, 1)
    rr, dd, rd = (cv2.GaussianBlur(e * inner, (0, 0), WINDOW_PX) for e in (right * right, down * down, right * down))
    strength = float(((rr + dd) * inner).sum())
    if strength <= 0.0:
        return 0.0
    coherence = float((np.hypot(rr - dd, 2.0 * rd) * inner).sum()) / strength
    return float(np.clip((STRAIGHT - coherence) / (STRAIGHT - CURLS), 0.0, 1.0))


def strand_noise(points_m: NDArray[np.floating], curls: float = 0.0) -> Picture:
    """Return noise (N,) of about unit deviation, elongated along strands that run from the crown down.

    Parameters
    ----------
    points_m : (N, 3) from the hair's middle, rest frame
    curls : float in 0..1
        At 1 nothing is alike farther down than around.
    """
    up = np.array(CROWN) / np.linalg.norm(CROWN)
    across = np.array([1.0, 0.0, 0.0])
    back = np.cross(across, up)
    along, side, rear = points_m @ up, points_m @ across, points_m @ back
    ring = np.hypot(side, rear)
    down = np.arctan2(ring, along) / np.pi
    around = np.arctan2(rear, side) / (2.0 * np.pi)
    rng = np.random.default_rng(SEED)
    around = around + TURN / (2.0 * np.pi) * _stretched_noise(rng, 14, 5, around, down)
    total = np.zeros(len(points_m))
    for cells, rows, part in OCTAVES:
        wide = np.clip(2.0 * np.pi * ring / cells / FINEST_M, 0.0, 1.0)  # at the crown strands end in each other
        short = round(rows * (cells / (2.0 * rows)) ** curls)  # half a turn down, a whole one around
        total += part * wide * _stretched_noise(rng, cells, short, around, down)
    return total.astype(np.float32)


def _stretched_noise(rng: np.random.Generator, cells: int, rows: int, around: Array, down: Array) -> Array:
    """Return smooth noise (N,) of unit deviation, periodic around and stretched down the head."""
    table = rng.standard_normal((rows + 2, cells))
    x, y = (around % 1.0) * cells, np.clip(down, 0.0, 1.0) * rows
    left, top = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    across, below = smoothstep(x - left), smoothstep(y - top)
    corner = [table[top + k, (left + j) % cells] for k in (0, 1) for j in (0, 1)]
    upper = corner[0] + (corner[1] - corner[0]) * across
    lower = corner[2] + (corner[3] - corner[2]) * across
    return np.asarray(1.5 * (upper + (lower - upper) * below))


def _hair_centre(vertices_m: Array) -> Array:
    """Return the centre (3,) of the hair's upper part, as wide as it is high: tails hang below the head."""
    top = float(vertices_m[:, 1].max())
    width = float(np.ptp(vertices_m[:, 0]))
    head = vertices_m[vertices_m[:, 1] > top - width]
    return np.asarray((head.min(axis=0) + head.max(axis=0)) / 2.0)
