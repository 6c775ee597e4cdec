"""Visibility of a posed surface from one camera: projection, obliqueness, occlusion."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.geometry.meshes.rasters import nearest_depth
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.records.views import Camera

DEPTH_SCALE = 0.5  # depth picture's size relative to the photo: 4 times faster, 1 px is still 2-3 mm
#: Occluders grow by this many depth pixels: a limb 8 photo pixels (1 cm) off paints nothing behind it.
OCCLUDER_GROWTH_PX = 4
EDGE_WIDTH_PX = 2  # depth pixels beside an inner outline that are unsafe, as at the outer one
EDGE_JUMP_M = 0.04  # taste: a hand before the thigh counts, a nose before the cheek does not
DEPTH_TOLERANCE_M = 0.008  # taste: more than the mesh's coarseness, less than a finger
STEEPEST_TANGENT = 3.0  # steeper ones would let a limb 5 cm in front pass


@dataclass(frozen=True, slots=True, eq=False)
class Visibility:
    """A posed mesh as one camera sees it.

    Attributes
    ----------
    pixel_px : (V, 2) float64
        Projected vertices, photo pixels.
    depth_m : (V,) float64
    cosine : (V,) float64
        Of the angle between normal and direction to the camera; <= 0 is turned away.
    nearest_m : (h, w) float32
        Depth of the nearest surface at ``DEPTH_SCALE``, inf where there is none.
    guarded_m : (h, w) float32
        The same with occluders grown.
    behind_m : (h, w) float32
        Depth of the farthest surface close by, 0 where there is none.
    metres_per_pixel : float
        Size of a depth pixel at the mesh's mean depth.
    """

    pixel_px: Array
    depth_m: Array
    cosine: Array
    nearest_m: NDArray[np.float32]
    guarded_m: NDArray[np.float32]
    behind_m: NDArray[np.float32]
    metres_per_pixel: float

    def visible_vertices(self) -> NDArray[np.bool_]:
        """Return (V,) which vertices are visible."""
        return self.visible(self.pixel_px, self.depth_m, self.cosine)

    def mirrored(self, mirror: NDArray[np.integer]) -> Visibility:
        """Return the visibility with every vertex where its mirror twin is."""
        return Visibility(
            self.pixel_px[mirror],
            self.depth_m[mirror],
            self.cosine[mirror],
            self.nearest_m,
            self.guarded_m,
            self.behind_m,
            self.metres_per_pixel,
        )

    def visible(
        self, pixel_px: NDArray[np.floating], depth_m: NDArray[np.floating], cosine: NDArray[np.floating]
    ) -> NDArray[np.bool_]:
        """Return which surface points (N,) the camera sees.

        A point is seen when it faces the camera, lies in the picture and
        nothing lies nearer than it by more than the tolerance, which grows with the slope.
        """
        nearest = depth_at(self.guarded_m, pixel_px)
        slope = self._rise(cosine, OCCLUDER_GROWTH_PX + 1)
        # NaN outside the picture compares as not free.
        return (depth_m <= nearest + DEPTH_TOLERANCE_M + slope) & (cosine > 0.0)

    def before_edge(
        self, pixel_px: NDArray[np.floating], depth_m: NDArray[np.floating], cosine: NDArray[np.floating]
    ) -> NDArray[np.bool_]:
        """Return which points (N,) lie beside a surface well behind them, whose colour may have bled over."""
        behind = depth_at(self.behind_m, pixel_px)
        return behind > depth_m + EDGE_JUMP_M + self._rise(cosine, EDGE_WIDTH_PX + 1)

    def _rise(self, cosine: NDArray[np.floating], reach_px: int) -> NDArray[np.floating]:
        """Return the depth gain of a surface of this slope over some depth pixels, metres."""
        tangent = np.sqrt(np.clip(1.0 - cosine * cosine, 0.0, None)) / np.maximum(cosine, 1e-3)
        return np.asarray(np.minimum(tangent, STEEPEST_TANGENT) * reach_px * self.metres_per_pixel)


def depth_pixels(pixel_px: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return photo pixels, of any shape, in the depth picture's frame."""
    return (pixel_px + 0.5) * DEPTH_SCALE - 0.5


def depth_at(picture_m: NDArray[np.float32], pixel_px: NDArray[np.floating]) -> NDArray[np.float32]:
    """Return a depth picture's values at photo pixels (N, 2), nearest neighbour, NaN outside."""
    column, row = (np.rint(depth_pixels(pixel_px[:, axis])).astype(np.int32) for axis in (0, 1))
    height, width = picture_m.shape
    # what is left of the picture or above it counts as far beyond, without a sign
    inside = (column.view(np.uint32) < width) & (row.view(np.uint32) < height)
    values = picture_m.ravel().take(np.where(inside, row * width + column, 0))
    return np.where(inside, values, np.float32(np.nan))


def depth_picture(points_m: Array, triangles: NDArray[np.int32], camera: Camera) -> NDArray[np.float32]:
    """Return the depth picture (h, w) of a surface at ``DEPTH_SCALE``, metres, inf where there is none."""
    width, height = int(camera.width_px * DEPTH_SCALE), int(camera.height_px * DEPTH_SCALE)
    if len(points_m) == 0:
        return np.full((height, width), np.inf, np.float32)
    depth = camera.to_camera(points_m)[:, 2]
    pixel = np.asarray(depth_pixels(camera.project(points_m)), np.float64)
    return nearest_depth(pixel, depth, triangles, width, height)


def front_facing(posed_m: Array, triangles: NDArray[np.int32], camera: Camera) -> NDArray[np.int32]:
    """Return the triangles that face the camera."""
    corners = camera.project(posed_m)[triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.asarray(triangles[first[:, 0] * second[:, 1] < first[:, 1] * second[:, 0]])  # y runs down in photos


def compute_visibility(
    posed_m: Array, triangles: NDArray[np.int32], camera: Camera, occluders: NDArray[np.int32] | None = None
) -> Visibility:
    """Return the visibility of a posed mesh.

    Parameters
    ----------
    posed_m : (V, 3) model frame, metres
    triangles : (T, 3) int32
    camera : Camera
    occluders : (O, 3) int32, optional
        Triangles that can hide others, all by default; of a closed surface :func:`front_facing` is enough, in a
        third of the time.
    """
    towards = camera.position_m - posed_m
    if camera.pixels_per_m is not None:
        towards = np.broadcast_to(-camera.camera_from_model[2, :3], posed_m.shape)
    towards = towards / np.linalg.norm(towards, axis=1, keepdims=True)
    cosine = np.einsum("vk,vk->v", vertex_normals(posed_m, triangles), towards)
    nearest = depth_picture(posed_m, triangles if occluders is None else occluders, camera)
    reach = 2 * OCCLUDER_GROWTH_PX + 1
    guarded = cv2.erode(nearest, np.ones((reach, reach), np.uint8), borderValue=np.inf)
    width = 2 * EDGE_WIDTH_PX + 1
    behind = cv2.dilate(np.where(np.isfinite(nearest), nearest, np.float32(0.0)), np.ones((width, width), np.uint8))
    return Visibility(
        pixel_px=camera.project(posed_m),
        depth_m=camera.to_camera(posed_m)[:, 2],
        cosine=cosine,
        nearest_m=nearest,
        guarded_m=guarded,
        behind_m=behind,
        metres_per_pixel=camera.metres_per_pixel(posed_m.mean(axis=0)) / DEPTH_SCALE,
    )
