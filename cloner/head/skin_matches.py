"""Correspondences between front and side photo, on skin that both show: outer eye, brow, wing of the nose, mouth
corner.

The side photo's outline tells the depths of the midline alone; how far eyes, cheeks and mouth corners lie behind it, no
net tells at 90 degrees. Skin that both photos see is therefore looked up: its brightness in the front photo is laid on
the fitted head and searched in the side photo, mostly along the line of depth.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates

from cloner.calibration.loader import calibrated
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.meshes.surface import SurfacePoints
from cloner.geometry.meshes.triangles import areas
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.skin_matches")

#: Places looked up, feature or FDP names of the person's left and right.
PLACES: Final = (
    ("eye_outer_L", "eye_outer_R"), ("ala_L", "ala_R"), ("mouth_corner_L", "mouth_corner_R"), ("4.5", "4.6"),
)  # fmt: skip
PATCH_M = _CALIBRATED.number("patch_m", "m")
#: Samples spread over a patch (taste).
SAMPLES = 300
ALONG_M = _CALIBRATED.number("along_m", "m")
ACROSS_M = _CALIBRATED.number("across_m", "m")
STEP_M = _CALIBRATED.number("step_m", "m")
TURNED = _CALIBRATED.number("turned", "cosine")
BAND_M = _CALIBRATED.pair("band_m", "m")
#: Least samples that are believed (taste).
FEWEST = 40
ALIKE = _CALIBRATED.number("alike", "factor")
APART_M = _CALIBRATED.number("apart_m", "m")
RIVAL = _CALIBRATED.number("rival", "share")
AGREE_M = _CALIBRATED.number("agree_m", "m")


@dataclass(frozen=True, slots=True, eq=False)
class SkinMatches:
    """Vertices (N,) matched in the side photo, their pixels (N, 2) and correlations (N,)."""

    vertices: NDArray[np.int64]
    points_px: Array
    alike: Array


def _detail(rgb: NDArray[np.uint8], camera: Camera, points: Array) -> tuple[Array, Array]:
    """Return a photo's band-passed brightness around the points and the crop's corner (x, y)."""
    seen = camera.project(points)
    metres = camera.metres_per_pixel(points.mean(axis=0))
    room = (ALONG_M + 2.0 * BAND_M[1]) / metres
    low = np.clip(np.floor(seen.min(axis=0) - room), 0, [camera.width_px - 2, camera.height_px - 2]).astype(int)
    high = np.clip(np.ceil(seen.max(axis=0) + room), low + 2, [camera.width_px, camera.height_px]).astype(int)
    grey = rgb[low[1] : high[1], low[0] : high[0]].astype(np.float32).mean(axis=2)
    fine, wide = (cv2.GaussianBlur(grey, (0, 0), band / metres, borderType=cv2.BORDER_REPLICATE) for band in BAND_M)
    return np.asarray(fine - wide, dtype=np.float64), low.astype(np.float64)


def _patch(generic: GenericHuman, triangles: NDArray[np.integer], vertex: int) -> SurfacePoints:
    """Return sample points over the skin around a vertex of the mean head (the same ones every time)."""
    mean = generic.vertices_m.astype(np.float64)
    near = triangles[(np.linalg.norm(mean[triangles].mean(axis=1) - mean[vertex], axis=1) < PATCH_M)]
    area = areas(mean, near)
    rng = np.random.default_rng(vertex)
    which = rng.choice(len(near), size=SAMPLES, p=area / area.sum())
    weights = rng.dirichlet(np.ones(3), size=SAMPLES)
    return SurfacePoints(near[which].astype(np.int32), weights)


def _sample(detail: Array, corner: Array, points_px: Array) -> Array:
    x, y = points_px[..., 0] - corner[0], points_px[..., 1] - corner[1]
    return np.asarray(map_coordinates(detail, [y, x], order=1, mode="nearest"))


def _correlation(front: Array, beside: Array) -> Array:
    """Return the correlation of values (N,) with each row of (S, N)."""
    a = front - front.mean()
    b = beside - beside.mean(axis=1, keepdims=True)
    return np.asarray(b @ a / np.maximum(np.sqrt((a**2).sum() * (b**2).sum(axis=1)), 1e-9))


@functools.cache
def _skin() -> NDArray[np.integer]:
    """Return the triangles of the outer skin of face and ears."""
    generic = load_generic()
    shown = generic.region("face") | generic.region("ear_left") | generic.region("ear_right")
    kept = generic.skin & shown
    kept &= ~generic.region("mouth_interior")
    triangles, _ = generic.triangles()
    return np.asarray(triangles[kept[triangles].all(axis=1)])


def match_front_to_side(
    generic: GenericHuman,
    wholes: tuple[Array, Array],
    cameras: tuple[Camera, Camera],
    pictures: tuple[NDArray[np.uint8], NDArray[np.uint8]],
    *,
    side: int,
) -> SkinMatches:
    """Return ``PLACES`` of the front photo matched in the side photo; side 0 is the person's left."""
    places = np.array([generic.feature(pair[side]) for pair in PLACES])
    return match_vertices(places, wholes, cameras, pictures)


def match_vertices(
    places: NDArray[np.int64],
    wholes: tuple[Array, Array],
    cameras: tuple[Camera, Camera],
    pictures: tuple[NDArray[np.uint8], NDArray[np.uint8]],
) -> SkinMatches:
    """Return matches in the second photo for vertices (N,), by their appearance in the first (template matching).

    Parameters
    ----------
    places : (N,)
    wholes : vertices (V, 3) of the fitted person, as the first and as the second photo shows them
    cameras, pictures : first and second photo
    """
    skin = _skin()
    normals = [vertex_normals(whole, skin) for whole in wholes]
    patches = [_patch(load_generic(), skin, row) for row in places]
    everything = [np.vstack([patch.at(whole) for patch in patches]) for whole in wholes]
    front, beside = (_detail(*one) for one in zip(pictures, cameras, everything, strict=True))
    metres = cameras[1].metres_per_pixel(everything[1].mean(axis=0))
    steps = np.stack(np.meshgrid(np.arange(-ALONG_M, ALONG_M + 1e-9, STEP_M),
                                 np.arange(-ACROSS_M, ACROSS_M + 1e-9, STEP_M)), axis=-1).reshape(-1, 2)  # fmt: skip
    maps: dict[int, Array] = {}
    for row, patch in zip(places, patches, strict=True):
        points = [patch.at(whole) for whole in wholes]
        towards = [_facing_cosines(*one) for one in zip(cameras, points, map(patch.at, normals), strict=True)]
        seen = (towards[0] > TURNED) & (towards[1] > TURNED)
        if seen.sum() >= FEWEST:
            first, second = (camera.project(own[seen]) for camera, own in zip(cameras, points, strict=True))
            spots = second[None] + (steps / metres)[:, None]
            maps[int(row)] = _correlation(_sample(*front, first), _sample(*beside, spots))
    found = _best_displacements(maps, steps)
    return SkinMatches(
        np.array([row for row, _, _ in found], dtype=np.int64),
        np.array([cameras[1].project(wholes[1][[row]])[0] + step / metres for row, step, _ in found]).reshape(-1, 2),
        np.array([share for _, _, share in found]),
    )


def _facing_cosines(camera: Camera, points: Array, normals: Array) -> Array:
    """Return the cosines (N,) between normals and the directions to the camera."""
    way = camera.position_m - points
    return np.asarray((way * normals).sum(axis=1) / np.linalg.norm(way, axis=1))


def _best_displacements(maps: dict[int, Array], steps: Array) -> list[tuple[int, Array, float]]:
    """Return vertex, displacement and correlation of the matches that agree, as most of the error is common to all."""
    if len(maps) < 2:
        return []
    together = steps[int(np.mean(list(maps.values()), axis=0).argmax())]
    near = np.linalg.norm(steps - together, axis=1) < AGREE_M
    found = []
    for row, alike in maps.items():
        best = int(np.where(near, alike, -1.0).argmax())
        rivals = alike[near & (np.linalg.norm(steps - steps[best], axis=1) > APART_M)]
        if alike[best] > ALIKE and rivals.max() < RIVAL * alike[best]:
            found.append((row, steps[best], float(alike[best])))
    return found
