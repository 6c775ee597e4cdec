"""Hair cards along the outlines of a hair's shell, with what photos show beyond it: tufts, strands, curls.

Around the head every meridian of the shell carries a ribbon from the crown down. Those of ear to ear and of forehead to
nape show what the front and side photos show there, in place; those between show the nearest of both.

References
----------
Fins of fur after Lengyel, Praun, Finkelstein, Hoppe 2001 ("Real-time fur over arbitrary surfaces"), here textured from
photographs, as cards that stand fast, because outlines from all sides shall have them without a shader of their own.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, gaussian_filter1d
from scipy.spatial import cKDTree

from cloner.frames import m_from_mm
from cloner.hair.shells.rim_strips import LEAST_MM, LEFT, RIGHT, ROOT_MM, TEXEL_MM, RimStrip, hair_beyond_mm
from cloner.hair.shells.rims import STEP_MM, HalfOutline, Mesh, camera_around, half_outlines, points_beside
from cloner.records.arrays import Array
from cloner.records.heads import Shell
from cloner.records.views import Camera

#: Meridians around the head, each half an outline; taste: no view is farther than 23 degrees from one.
MERIDIANS: Final = 8
#: Cards are so long along a rim, rims' steps.
STATION: Final = 2
#: Outer edges sway across their card's plane by so much of its height and so many mm: edge-on it is no wire; taste.
SWAY, SWAY_MM = 0.5, 6.0
SEED: Final = 1
#: A rim lies so near to a vertex of the shell: where two locks hide each other it would float between them, mm.
NEAR_MM: Final = 12.0
#: Cards stand also where hair stands out within so many mm along the rim.
NEIGHBOURS_MM: Final = 12.0
#: Colours are the shell's over such a length of rim, mm, and single hairs so much darker or brighter at most; taste.
EVEN_MM: Final = 30.0
BRIGHTER: Final = (0.4, 1.8)


@dataclass(frozen=True, slots=True, eq=False)
class MeridianCards:
    """The cards of one meridian.

    Attributes
    ----------
    side : int
        The strip it shows.
    corners_m : (4 K, 3)
        Roots at the card's begin and end, then its outer edge at end and begin.
    along_mm : (K, 2)
        Where the cards begin and end along the strip.
    """

    side: int
    corners_m: Array
    along_mm: Array


def rim_shell(
    shell: Shell, grown: Mesh, body: Mesh, strips: Mapping[int, RimStrip], reach_mm: float, bare: NDArray[np.bool_]
) -> Shell | None:
    """Return the cards of a hair's shell, None where there is no room for any.

    Parameters
    ----------
    shell : Shell
        Gives weights and colours.
    grown : vertices (N, 3) at rest, m, and triangles (T, 3) of the hair without what is worn over it
    body : vertices (V, 3) at rest and triangles of the whole body
    strips : mapping of int to Strip
        What they show (:func:`cloner.hair.shells.rim_strips.make_strips`).
    reach_mm : float
        How far hair stands out.
    bare : (N,) bool
        Vertices without cards: hats.
    """
    meridians = find_meridians(grown, body) if strips else {}
    ribbons = list(_meridian_cards(grown, meridians, strips, reach_mm, bare))
    if not ribbons:
        return None
    order = sorted(strips)
    height, width = (max(strip.rgba.shape[axis] for strip in strips.values()) for axis in (0, 1))
    vertex = cKDTree(shell.vertices_m)
    picture = np.zeros((height * len(order), width, 4), np.float32)
    for row, side in enumerate(order):
        places = meridians[side][1].place_m if side in meridians else crown_centre(grown[0])[None]
        rgba = _matched_to_shell(strips[side], shell, vertex, places)
        picture[row * height : row * height + rgba.shape[0], : rgba.shape[1]] = rgba
    corners = np.concatenate([ribbon.corners_m for ribbon in ribbons])
    uv = []
    for ribbon in ribbons:
        across = (ribbon.along_mm / TEXEL_MM + 0.5) / width
        top, bottom = ((order.index(ribbon.side) + share) / len(order) for share in (0.5 / height, 1.0 - 0.5 / height))
        down = np.tile([bottom, bottom, top, top], len(across))
        uv.append(np.stack([np.concatenate([across, across[:, ::-1]], axis=1).ravel(), down], axis=1))
    first = np.arange(0, len(corners), 4, dtype=np.int32)[:, None]
    nearest = np.repeat(vertex.query(corners.reshape(-1, 4, 3)[:, :2].mean(axis=1))[1], 4)
    return Shell(
        corners,
        np.concatenate([first + (0, 1, 2), first + (0, 2, 3)]).astype(np.int32),
        np.concatenate(uv),
        shell.skin_joints[nearest],
        shell.skin_weights[nearest],
        np.clip(np.rint(picture), 0, 255).astype(np.uint8),
        "frizz",
    )


def crown_centre(vertices_m: Array) -> Array:
    """Return the centre (3,) of a hair's upper 10 cm, around which meridians lie."""
    return np.asarray(vertices_m[vertices_m[:, 1] > vertices_m[:, 1].max() - 0.1].mean(axis=0))


def find_meridians(grown: Mesh, body: Mesh) -> dict[int, tuple[Camera, HalfOutline]]:
    """Return the meridians of a hair at rest by azimuth, degrees, and the views that see them edge-on."""
    crown_m, found = crown_centre(grown[0]), dict[int, tuple[Camera, HalfOutline]]()
    for turn in range(0, 180, 360 // MERIDIANS):
        camera = camera_around(crown_m, np.radians(turn))
        for azimuth, rim in zip(
            (turn - 90, turn + 90), half_outlines(grown, body, camera, crown_m) or (), strict=False
        ):
            found[azimuth % 360] = camera, rim
    return found


def _meridian_cards(
    grown: Mesh,
    meridians: Mapping[int, tuple[Camera, HalfOutline]],
    strips: Mapping[int, RimStrip],
    reach_mm: float,
    bare: NDArray[np.bool_],
) -> Iterator[MeridianCards]:
    """Yield the meridians that carry cards."""
    tree, rng = cKDTree(grown[0]), np.random.default_rng(SEED)
    for azimuth, (camera, rim) in meridians.items():
        side = _nearest(sorted(strips), azimuth)
        away_m, vertex = tree.query(rim.place_m)
        carries = _hair_columns(rim, strips[side], reach_mm) & ~bare[vertex] & (away_m < m_from_mm(NEAR_MM))
        low, high = points_beside(camera, rim, -ROOT_MM), points_beside(camera, rim, reach_mm)
        sway_m = m_from_mm(SWAY * reach_mm + SWAY_MM) * rng.uniform(-1.0, 1.0, (len(high), 1))
        high += sway_m * camera.camera_from_model[2, :3]
        first = STATION * np.flatnonzero(carries[:-STATION:STATION] | carries[STATION::STATION])
        end = first + STATION
        if len(first):
            corners = np.stack([low[first], low[end], high[end], high[first]], axis=1).reshape(-1, 3)
            yield MeridianCards(side, corners, np.asarray(STEP_MM * np.stack([first, end], axis=1), np.float64))


def _nearest(sides: list[int], azimuth_deg: float) -> int:
    """Return the strip nearest to an azimuth; of two the one on the side, where hair is longer than
    over the forehead.
    """
    away = [np.cos(np.radians(azimuth_deg - side)) + (1e-3 if side in (LEFT, RIGHT) else 0.0) for side in sides]
    return sides[int(np.argmax(away))]


def _hair_columns(rim: HalfOutline, strip: RimStrip, reach_mm: float) -> NDArray[np.bool_]:
    """Return where (K,) a card may begin or end: hair stands out nearby, and the strip continues."""
    beyond = hair_beyond_mm(strip, reach_mm, NEIGHBOURS_MM)
    at = (np.arange(len(rim.free)) * STEP_MM / TEXEL_MM).astype(int)
    hairy = beyond[np.minimum(at, len(beyond) - 1)] > LEAST_MM
    near = binary_dilation(hairy, iterations=round(NEIGHBOURS_MM / STEP_MM))
    return np.asarray(rim.free & near & (at + STATION * STEP_MM / TEXEL_MM < len(beyond)), np.bool_)


def _matched_to_shell(strip: RimStrip, shell: Shell, vertex: cKDTree, places_m: Array) -> NDArray[np.float32]:
    """Return a strip (h, w, 4) with the colours of the shell's own texture and the photo's contrast."""
    height, width = shell.rgba.shape[:2]
    uv = shell.uv[vertex.query(places_m)[1]]
    column, line = ((uv * (width, height)).astype(int).clip(0, (width - 1, height - 1))).T
    near = cv2.blur(shell.rgba[..., :3], (9, 9))[line, column].astype(np.float64)
    at = np.arange(strip.rgba.shape[1]) * TEXEL_MM / STEP_MM
    wanted = np.stack([np.interp(at, np.arange(len(near)), near[:, k]) for k in range(3)], axis=1)
    wanted = gaussian_filter1d(wanted, EVEN_MM / TEXEL_MM, axis=0, mode="nearest")
    light, alpha = strip.rgba[..., :3].mean(axis=2), strip.rgba[..., 3] / 255.0
    total, weight = (gaussian_filter1d(each.sum(axis=0), EVEN_MM / TEXEL_MM) for each in (light * alpha, alpha))
    brighter = np.clip(light / np.maximum(total / np.maximum(weight, 1e-6), 1.0), *BRIGHTER)
    rgb = np.clip(brighter[..., None] * wanted, 0.0, 255.0)
    return np.dstack([rgb, strip.rgba[..., 3]]).astype(np.float32)
