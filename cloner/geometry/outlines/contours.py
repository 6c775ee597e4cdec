"""Photo outlines prepared for fitting: samples with normals, and a signed distance field."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates
from scipy.spatial import cKDTree

from cloner.geometry.meshes.vectors import arc_lengths, places_along, unit
from cloner.records.arrays import Array


@dataclass(frozen=True, slots=True, eq=False)
class OutlineField:
    """One photo's outline.

    Attributes
    ----------
    samples_px : (M, 2) evenly spaced points on the contours, photo pixels
    normals : (M, 2) unit outward normals
    step_px : float
        Distance between samples along the contour.
    distance : (h, w) float32
        Signed distance to the outline in photo pixels, positive outside, on a reduced grid.
    reduction : float
        Photo pixels per grid cell.
    veiled : (M,) bool
        Samples where hair or loose clothing, not the body, makes the outline.
    draped : (M,) bool
        Those of loose clothing: the body is inside them.
    """

    samples_px: Array
    normals: Array
    step_px: float
    distance: NDArray[np.float32]
    reduction: float
    veiled: NDArray[np.bool_]
    draped: NDArray[np.bool_]

    def signed_distance(self, points_px: Array) -> Array:
        """Return the signed distances (N,) of photo points from the outline, positive outside."""
        grid = (points_px + 0.5) / self.reduction - 0.5
        height, width = self.distance.shape
        inside = np.clip(grid, 0, [width - 1, height - 1])
        value = map_coordinates(self.distance, [inside[:, 1], inside[:, 0]], order=1)
        beyond = np.linalg.norm(grid - inside, axis=1) * self.reduction
        return np.asarray(value + beyond, dtype=np.float64)

    def is_veiled(self, points_px: Array) -> NDArray[np.bool_]:
        """Return whether the outline nearest to each point (N,) is hair's or loose clothing's."""
        if not self.veiled.any() or len(points_px) == 0:
            return np.zeros(len(points_px), dtype=bool)
        return np.asarray(self.veiled[cKDTree(self.samples_px).query(points_px)[1]])

    def nearest_rim(self, points_px: Array, normals: Array, turn_px: float) -> tuple[NDArray[np.int64], Array]:
        """Return for every sample the nearest of N points with a similar normal.

        Parameters
        ----------
        points_px : (N, 2), normals : (N, 2)
        turn_px : float
            Distance that a normal turned by 60° counts for.

        Returns
        -------
        index : (M,), distance : (M,) in pixels, normals included
        """
        tree = cKDTree(np.hstack([points_px, normals * turn_px]))
        distance, index = tree.query(np.hstack([self.samples_px, self.normals * turn_px]))
        return index, distance


def outline_field(
    contours_px: tuple[Array, ...],
    mask: NDArray[np.bool_],
    hair: NDArray[np.bool_],
    *,
    cloth: NDArray[np.bool_] | None = None,
    step_px: float,
    reduction: float,
) -> OutlineField:
    """Return samples, normals and the distance field of an outline.

    Parameters
    ----------
    contours_px : closed polygons of any orientation, photo pixels
    mask : (H, W) filled outline
    hair : (H, W) pixels that show hair
    cloth : (H, W) pixels that show loose clothing, or None
    step_px : spacing of samples
    reduction : photo pixels per cell of the distance field, at least 1
    """
    small = cv2.resize(
        mask.astype(np.uint8) * 255, None, fx=1 / reduction, fy=1 / reduction, interpolation=cv2.INTER_AREA
    )
    inside = small > 127
    outside_px = cv2.distanceTransform((~inside).astype(np.uint8), cv2.DIST_L2, 5)
    inside_px = cv2.distanceTransform(inside.astype(np.uint8), cv2.DIST_L2, 5)
    distance = np.where(inside, 0.5 - inside_px, outside_px - 0.5).astype(np.float32) * np.float32(reduction)
    points, normals = [], []
    for contour in contours_px:
        closed = np.vstack([contour, contour[:1]])
        length = arc_lengths(closed)
        count = int(length[-1] // step_px)
        if count < 8:
            continue
        at = np.linspace(0.0, length[-1], count, endpoint=False)
        sample = places_along(closed, length, at)
        ahead = np.roll(sample, -2, axis=0) - np.roll(sample, 2, axis=0)
        normal = np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
        normal = unit(normal)
        points.append(sample)
        normals.append(normal)
    samples, outward = np.vstack(points), np.vstack(normals)
    clear = np.zeros(len(samples), dtype=bool)
    field = OutlineField(samples, outward, step_px, distance, reduction, clear, clear)
    probe = 2 * reduction * outward
    outward[field.signed_distance(samples + probe) < field.signed_distance(samples - probe)] *= -1
    inner = np.round(samples - 4 * reduction * outward).astype(int)
    height, width = hair.shape
    row, column = np.clip(inner[:, 1], 0, height - 1), np.clip(inner[:, 0], 0, width - 1)
    draped = clear if cloth is None else cloth[row, column]
    return OutlineField(samples, outward, step_px, distance, reduction, hair[row, column] | draped, draped)
