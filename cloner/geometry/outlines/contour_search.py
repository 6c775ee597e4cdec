"""Search on a posed body's occluding contour: nearest to a pixel, or on a line through one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.articulation.skin_bends import EdgePoint, SkinMetric
from cloner.geometry.meshes.surface import overlaps_triangles
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.outlines.silhouette import triangle_normals
from cloner.records.arrays import Array

Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

#: A probe so far outside an edge tells whether it bounds the whole body or lies before or behind another part, px.
PROBE_PX = 1.5
#: Edges probed, nearest first: a fold has no more of them before the outline comes.
PROBED = 48


@dataclass(frozen=True, slots=True, eq=False)
class OccludingContour:
    """The occluding contour of a body from one camera.

    Attributes
    ----------
    pixels : (V, 2) projected vertices
    edges : (N, 2) int64
        Edges between a triangle that faces the camera and one that does not.
    outward : (N, 2) unit normals in the picture, away from the body
    """

    pixels: Array
    edges: Ints
    outward: Array


@dataclass(frozen=True, slots=True, eq=False)
class ContourPoint:
    """A point of the occluding contour: on the mesh, in the photo, and its outward normal there."""

    place: EdgePoint
    pixel: Array
    outward: Array


def occluding_contour(metric: SkinMetric, posed_m: Array, pixels: Array, eye_m: Array) -> OccludingContour:
    """Return the occluding contour of a posed body.

    Parameters
    ----------
    metric : SkinMetric
    posed_m : (V, 3) model frame, metres
    pixels : (V, 2) the same vertices in the photo
    eye_m : (3,) camera centre; far away for an orthographic camera
    """
    corner = posed_m[metric.triangles]
    faces = np.einsum("ta,ta->t", triangle_normals(posed_m, metric.triangles), eye_m - corner[:, 0]) > 0
    turned = faces[metric.beside]
    rows = np.flatnonzero(turned[:, 0] != turned[:, 1])
    edges = metric.edges[rows]
    seen = np.where(turned[rows, 0], metric.beside[rows, 0], metric.beside[rows, 1])
    along = pixels[edges[:, 1]] - pixels[edges[:, 0]]
    normal = np.stack([along[:, 1], -along[:, 0]], axis=1)
    normal = unit(normal)
    inside = pixels[metric.triangles[seen]].mean(axis=1) - pixels[edges].mean(axis=1)
    return OccludingContour(
        pixels, edges, np.where(np.einsum("na,na->n", normal, inside)[:, None] > 0, -normal, normal)
    )


def nearest_contour_point(
    rim: OccludingContour, metric: SkinMetric, target_px: Array, allowed: Bools, penalty_px: float
) -> ContourPoint | None:
    """Return the contour point nearest to a pixel, None if no allowed part of the contour is there.

    Parameters
    ----------
    target_px : (2,) photo pixel
    allowed : (V,) bool
        Both ends of an edge must be allowed.
    penalty_px : float
        How much nearer a rim in front of or behind other parts must be than one that bounds the body.
    """
    rows = np.flatnonzero(allowed[rim.edges].all(axis=1))
    if len(rows) == 0:
        return None
    first, second = rim.pixels[rim.edges[rows, 0]], rim.pixels[rim.edges[rows, 1]]
    along = second - first
    share = np.einsum("na,na->n", target_px - first, along) / np.maximum((along**2).sum(axis=1), 1e-12)
    share = np.clip(share, 0.0, 1.0)
    points = first + share[:, None] * along
    distance = np.linalg.norm(points - target_px, axis=1)
    order = np.argsort(distance)[:PROBED]
    probes = points[order] + PROBE_PX * rim.outward[rows[order]]
    border = ~is_covered(probes, rim.pixels, metric.triangles)
    best = int(order[np.argmin(distance[order] + np.where(border, 0.0, penalty_px))])
    ends = rim.edges[rows[best]]
    place = EdgePoint(int(ends[0]), int(ends[1]), float(share[best]))
    return ContourPoint(place, points[best], rim.outward[rows[best]])


def outermost_point(edges: Ints, pixels: Array, target_px: Array, outward: Array) -> tuple[EdgePoint, float] | None:
    """Return the skin point farthest out on the line through a pixel, and its distance beyond the pixel, px.

    Parameters
    ----------
    edges : (N, 2)
        Edges of the skin that may make the outline there.
    pixels : (V, 2)
        Projected vertices.
    target_px : (2,)
    outward : (2,) unit direction away from the body

    Returns
    -------
    place, beyond or None
        None where no edge crosses the line; ``beyond`` is negative inside.
    """
    offset = pixels[edges] - target_px
    beside = offset @ np.array([-outward[1], outward[0]])
    rows = np.flatnonzero((beside[:, 0] > 0.0) != (beside[:, 1] > 0.0))
    if len(rows) == 0:
        return None
    share = beside[rows, 0] / (beside[rows, 0] - beside[rows, 1])
    height = offset[rows] @ outward
    height = height[:, 0] + share * (height[:, 1] - height[:, 0])
    best = int(np.argmax(height))
    ends = edges[rows[best]]
    return EdgePoint(int(ends[0]), int(ends[1]), float(share[best])), float(height[best])


def is_covered(points_px: Array, pixels: Array, triangles: NDArray[np.integer]) -> Bools:
    """Return whether any triangle of a picture covers each point, (N,).

    Parameters
    ----------
    points_px : (N, 2)
    pixels : (V, 2) projected vertices
    triangles : (T, 3)
    """
    low, high = points_px.min(axis=0), points_px.max(axis=0)
    outside = (pixels < low) * np.array([1, 2], dtype=np.int8) + (pixels > high) * np.array([4, 8], dtype=np.int8)
    code = outside.sum(axis=1).astype(np.int8)
    # Three corners beyond one and the same side of the box: the triangle misses it.
    near = np.bitwise_and.reduce(code[triangles], axis=1) == 0
    return np.asarray(overlaps_triangles(points_px, pixels[triangles[near]])[0].any(axis=1))
