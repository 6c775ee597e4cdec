"""The outline of a hair's shell from a viewpoint, from its crown down both sides."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from cloner.frames import m_from_mm, mm_from_m
from cloner.geometry.meshes.rasters import nearest_depth
from cloner.records.arrays import Array
from cloner.records.views import Camera

Mask = NDArray[np.bool_]
#: Vertices (N, 3) and triangles (T, 3).
Mesh = tuple[Array, NDArray[np.int32]]

#: Side of a pixel in which rims are followed, mm: as coarse as the shell's triangles.
PIXEL_MM: Final = 1.5
#: Rims are followed in steps of so many mm, and places and directions along them are smooth over so many, mm; taste.
STEP_MM, PLACE_MM, WAY_MM = 4.0, 4.0, 16.0
#: So deep inside its own outline the shell's depth is read, pixels of the rim's picture.
INSIDE_PX: Final = 3
#: Air around what is drawn, pixels.
MARGIN_PX: Final = 8


@dataclass(frozen=True, slots=True, eq=False)
class HalfOutline:
    """One half of an outline, from the crown down on one side.

    Attributes
    ----------
    place_px : (K, 2) pixels of the camera, `STEP_MM` apart
    outward : (K, 2) unit directions in the picture
    place_m : (K, 3) in the frame that the camera sees
    free : (K,) bool
        Whether it is the hair that ends there.
    """

    place_px: Array
    outward: Array
    place_m: Array
    free: Mask


def half_outlines(shell: Mesh, body: Mesh, camera: Camera, crown_m: Array) -> tuple[HalfOutline, HalfOutline] | None:
    """Return the outline's halves left and right of the crown, None where no hair is seen.

    Parameters
    ----------
    shell, body : vertices (N, 3) and triangles (T, 3), as the camera sees them
    camera : Camera
    crown_m : (3,)
        A point below the crown; the outline's highest point above it is the crown.
    """
    scale = mm_from_m(camera.metres_per_pixel(crown_m)) / PIXEL_MM
    pixel = camera.project(shell[0]) * scale
    first = np.floor(pixel.min(axis=0)) - MARGIN_PX
    width, height = (np.ceil(pixel.max(axis=0)) + MARGIN_PX - first).astype(int)

    def nearest(mesh: Mesh, depth_m: Array) -> NDArray[np.float32]:
        places = np.clip(camera.project(mesh[0]) * scale - first, -1e4, 1e4)
        return nearest_depth(places, depth_m, mesh[1], width, height)

    deep, bodily = (camera.to_camera(mesh[0])[:, 2] for mesh in (shell, body))
    turned = float(deep.max() + deep.min()) - deep  # as somebody beyond it sees it
    front, near = nearest(shell, deep), nearest(body, bodily)
    back = float(deep.max() + deep.min()) - nearest(shell, turned)  # minus infinity where there is none
    seen = np.isfinite(front) & (front < near)
    whole = np.isfinite(front) | np.isfinite(near)
    lines, _ = cv2.findContours(whole.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    if not seen.any() or not lines:
        return None
    line = max(lines, key=len)[:, 0].astype(np.float64)
    top = camera.project(crown_m[None])[0] * scale - first
    above = np.where(line[:, 1] < top[1], np.abs(line[:, 0] - top[0]), np.inf)
    start = int(np.argmin(above)) if np.isfinite(above).any() else int(np.argmin(line[:, 1]))
    ring = np.roll(line, -start, axis=0)
    outward = _outward_normals(ring)
    middle = np.where(np.isfinite(front), 0.5 * (front + np.where(np.isfinite(back), back, front)), np.nan)
    halves = []
    for way in (1, -1):
        order = np.arange(len(ring) // 2) * way
        place, out = ring[order], outward[order]
        inside = np.rint(place - INSIDE_PX * out).astype(int).clip(0, (width - 1, height - 1))
        here = seen[inside[:, 1], inside[:, 0]]
        depth = np.where(here, middle[inside[:, 1], inside[:, 0]], np.nan)
        halves.append(_resampled_half(place, out, here, depth, (camera, scale, first)))
    found = sorted(halves, key=lambda rim: float(rim.place_px[: len(rim.place_px) // 2 + 1, 0].mean()))
    return found[0], found[1]


def _outward_normals(ring: Array) -> Array:
    """Return unit outward normals (K, 2) of a closed outline, smoothed along it."""
    smooth = gaussian_filter1d(ring, WAY_MM / PIXEL_MM, axis=0, mode="wrap")
    along = np.roll(smooth, -1, axis=0) - np.roll(smooth, 1, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    across = np.stack([along[:, 1], -along[:, 0]], axis=1)
    turn = np.sum(ring[:, 0] * np.roll(ring[:, 1], -1) - np.roll(ring[:, 0], -1) * ring[:, 1])
    return across if turn > 0.0 else -across


def _resampled_half(
    place: Array, out: Array, here: Mask, depth: Array, frame: tuple[Camera, float, Array]
) -> HalfOutline:
    """Return one half in equal steps, with smooth depth where the hair ends and flat elsewhere."""
    camera, scale, first = frame
    place = gaussian_filter1d(place, PLACE_MM / PIXEL_MM, axis=0, mode="nearest")
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(place, axis=0), axis=1))]) * PIXEL_MM
    at = np.searchsorted(way, np.arange(0.0, way[-1], STEP_MM))
    known = np.flatnonzero(np.isfinite(depth))
    if known.size:
        depth = np.interp(np.arange(len(depth)), known, depth[known])
        depth = gaussian_filter1d(depth, WAY_MM / PIXEL_MM, mode="nearest")
    else:
        depth = np.zeros(len(depth))
    pixel = (place[at] + first) / scale
    position, forward = camera.position_m, camera.camera_from_model[2, :3]
    near = position + depth[at, None] * forward
    return HalfOutline(pixel, out[at], camera.back_project(pixel, near), here[at])


def points_beside(camera: Camera, rim: HalfOutline, away_mm: float) -> Array:
    """Return points (K, 3) beside an outline in its picture's plane, positive outwards."""
    size_m = np.array([camera.metres_per_pixel(point) for point in rim.place_m])
    pixel = rim.place_px + rim.outward * (m_from_mm(away_mm) / size_m)[:, None]
    return camera.back_project(pixel, rim.place_m)


def camera_around(middle_m: Array, azimuth_rad: float) -> Camera:
    """Return an orthographic camera that sees a head at rest from an azimuth (0 from the front)."""
    right = np.array([np.cos(azimuth_rad), 0.0, -np.sin(azimuth_rad)])
    toward = np.array([np.sin(azimuth_rad), 0.0, np.cos(azimuth_rad)])
    turn = np.stack([right, (0.0, -1.0, 0.0), -toward])
    matrix = np.eye(4)
    matrix[:3, :3] = turn
    matrix[:3, 3] = -turn @ (middle_m + 10.0 * toward)
    size = 2048
    return Camera(size, size, 1.0, matrix, pixels_per_m=1.0 / m_from_mm(PIXEL_MM))
