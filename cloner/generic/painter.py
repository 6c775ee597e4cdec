"""Software renderer in NumPy for machines without EGL: slower, same picture but for its edges.

One sample a pixel and no mipmaps; everything else is as in ``cloner.render``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.generic.layers import Layer
from cloner.geometry.meshes.rasters import fragments
from cloner.geometry.meshes.vectors import unit
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: The renderer's near plane, metres; nothing of a person comes nearer to a lens.
NEAR_M: Final = 0.05
#: Surfaces this much nearer win, share of the depth; float32 depth is good to 1e-7.
_TIE: Final = 1e-5
_DEEPEST: Final = 24  # taste: blended surfaces behind one another in one pixel; more cannot be told apart


@dataclass(slots=True)
class _Canvas:
    """The picture under construction: flat pixels, nearest opaque 1/depth."""

    colour: NDArray[np.float32]
    nearness: NDArray[np.float32]


def paint(
    layers: Sequence[Layer],
    camera: Camera,
    *,
    background: tuple[int, int, int],
    lights: Sequence[tuple[Array, float]] = (),
    ambient: float = 1.0,
) -> NDArray[np.uint8]:
    """Return the (H, W, 3) uint8 sRGB picture of some meshes.

    Parameters
    ----------
    layers : sequence of Layer
    camera : Camera
    background : 3 ints, 0..255 sRGB
    lights : sequence of (direction (3,) towards the light in camera axes, strength)
        Empty shows the textures as they are.
    ambient : float
        Share of the texture that shows without any light.
    """
    count = camera.width_px * camera.height_px
    canvas = _Canvas(np.tile(np.array(background, np.float32), (count, 1)), np.zeros(count, np.float32))
    blended = [layer for layer in layers if layer.texture is not None and layer.texture.shape[2] == 4]
    for layer in layers:
        if not any(layer is other for other in blended):
            _paint_opaque(canvas, layer, camera, lights, ambient)
    for layer in sorted(blended, key=lambda each: -float(camera.to_camera(each.vertices_m)[:, 2].mean())):
        _paint_blended(canvas, layer, camera, lights, ambient)
    picture = np.clip(np.round(canvas.colour), 0, 255).astype(np.uint8)
    return picture.reshape(camera.height_px, camera.width_px, 3)


def _paint_opaque(
    canvas: _Canvas, layer: Layer, camera: Camera, lights: Sequence[tuple[Array, float]], ambient: float
) -> None:
    """Paint a closed mesh; the nearest surface of every pixel wins."""
    points_px, nearness, triangles = _project_front_facing(layer, camera)
    winner = np.full(len(canvas.nearness), -1, dtype=np.int64)
    weights = np.zeros((len(canvas.nearness), 3), dtype=np.float32)
    for pixel, triangle, share in fragments(points_px, triangles, camera.width_px, camera.height_px):
        near = np.einsum("nk,nk->n", nearness[triangles[triangle]], share)
        np.maximum.at(canvas.nearness, pixel, near)
        won = near >= canvas.nearness[pixel] * (1.0 - _TIE)
        winner[pixel[won]], weights[pixel[won]] = triangle[won], share[won]
    # a later chunk may have covered a winner of an earlier one; it is then in winner itself
    hit = np.flatnonzero(winner >= 0)
    corners = triangles[winner[hit]]
    near = np.einsum("nk,nk->n", nearness[corners], weights[hit])
    real = near >= canvas.nearness[hit] * (1.0 - 10 * _TIE)
    hit, corners = hit[real], corners[real]
    canvas.colour[hit] = _shade(layer, camera, corners, weights[hit], nearness, lights, ambient)[:, :3]


def _paint_blended(
    canvas: _Canvas, layer: Layer, camera: Camera, lights: Sequence[tuple[Array, float]], ambient: float
) -> None:
    """Composite a mesh with alpha over the picture, back to front in every pixel."""
    points_px, nearness, triangles = _project_front_facing(layer, camera)
    pixels, nears, colours = [], [], []
    for pixel, triangle, share in fragments(points_px, triangles, camera.width_px, camera.height_px):
        corners = triangles[triangle]
        near = np.einsum("nk,nk->n", nearness[corners], share)
        free = near >= canvas.nearness[pixel] * (1.0 - _TIE)
        rgba = _shade(layer, camera, corners[free], share[free], nearness, lights, ambient)
        some = rgba[:, 3] > 0.0
        pixels.append(pixel[free][some])
        nears.append(near[free][some])
        colours.append(rgba[some])
    if not pixels:
        return
    pixel, near, rgba = np.concatenate(pixels), np.concatenate(nears), np.concatenate(colours)
    order = np.lexsort((near, pixel))
    pixel, rgba = pixel[order], rgba[order]
    first = np.concatenate([[True], pixel[1:] != pixel[:-1]]) if len(pixel) else np.zeros(0, bool)
    start = np.maximum.accumulate(np.where(first, np.arange(len(pixel)), 0))
    rank = np.arange(len(pixel)) - start
    for depth in range(min(int(rank.max(initial=-1)) + 1, _DEEPEST)):
        now = rank == depth
        alpha = rgba[now, 3:] / 255.0
        canvas.colour[pixel[now]] = alpha * rgba[now, :3] + (1.0 - alpha) * canvas.colour[pixel[now]]


def _project_front_facing(layer: Layer, camera: Camera) -> tuple[Array, NDArray[np.float32], NDArray[np.int32]]:
    """Return projected points, 1/depth of every vertex, and the triangles that face the camera or are two-sided."""
    depth = camera.to_camera(layer.vertices_m)[:, 2]
    points_px = camera.project(layer.vertices_m)
    triangles = layer.triangles[(depth[layer.triangles] > NEAR_M).all(axis=1)]
    if not layer.two_sided:
        a, b, c = (points_px[triangles[:, k]] for k in range(3))
        ahead, aside = b - a, c - a
        # y points down in pixels, so faces that look at the camera turn clockwise in numbers
        triangles = triangles[ahead[:, 0] * aside[:, 1] - ahead[:, 1] * aside[:, 0] < 0.0]
    nearness = (1.0 / np.maximum(depth, NEAR_M)).astype(np.float32)
    return points_px, nearness, triangles


def _shade(
    layer: Layer,
    camera: Camera,
    corners: NDArray[np.int32],
    weights: NDArray[np.float32],
    nearness: NDArray[np.float32],
    lights: Sequence[tuple[Array, float]],
    ambient: float,
) -> NDArray[np.float32]:
    """Return the (N, 4) colours 0..255 of some surface points."""
    share = weights if camera.pixels_per_m is not None else weights * nearness[corners]
    share = share / np.maximum(share.sum(axis=1, keepdims=True), 1e-20)
    rgba = np.empty((len(corners), 4), dtype=np.float32)
    rgba[:] = (*(255.0 * value for value in layer.colour), 255.0)
    if layer.texture is not None and layer.uv is not None:
        uv = np.einsum("nk,nkc->nc", share, layer.uv[corners])
        rgba[:, : layer.texture.shape[2]] = _texels(layer.texture, uv)
    if layer.white:
        rgba[:, :3] = 255.0
    if lights:
        normal = np.einsum("nk,nkc->nc", share, layer.normals[corners]) @ camera.camera_from_model[:3, :3].T
        normal = unit(normal)
        light = np.full(len(corners), ambient)
        for direction, strength in lights:
            turned = normal @ (direction / np.linalg.norm(direction))
            light += strength * np.maximum(np.abs(turned) if layer.two_sided else turned, 0.0)
        linear = (rgba[:, :3] / 255.0) ** 2.2 * light[:, None]  # light adds up in linear colour
        rgba[:, :3] = 255.0 * np.clip(linear, 0.0, 1.0) ** (1.0 / 2.2)
    return rgba


def _texels(texture: NDArray[np.uint8], uv: Array) -> NDArray[np.float32]:
    """Return bilinear samples (N, C) of a texture that repeats."""
    height, width = texture.shape[:2]
    place = uv * [width, height] - 0.5
    low = np.floor(place).astype(np.int64)
    part = (place - low).astype(np.float32)
    total = np.zeros((len(uv), texture.shape[2]), dtype=np.float32)
    for dx in (0, 1):
        for dy in (0, 1):
            share = (part[:, 0] if dx else 1 - part[:, 0]) * (part[:, 1] if dy else 1 - part[:, 1])
            total += share[:, None] * texture[(low[:, 1] + dy) % height, (low[:, 0] + dx) % width]
    return total


def downsample_samples(large: NDArray[np.uint8], factor: int) -> NDArray[np.uint8]:
    """Return the picture at 1/factor size, each pixel the mean of its samples."""
    if factor == 1:
        return np.ascontiguousarray(large)
    size = (large.shape[1] // factor, large.shape[0] // factor)
    return np.asarray(cv2.resize(large, size, interpolation=cv2.INTER_AREA), np.uint8)
