"""The hair as a volume: a cap of measured thickness, free tails and draped hair in one field."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, gaussian_filter
from scipy.spatial import cKDTree

from cloner.baking.hair_tail import tail_mm
from cloner.baking.hair_views import FAR_MM, HairView, hull_mm
from cloner.frames import m_from_mm, mm_from_m
from cloner.geometry.graphs import SurfaceGraph

Array = NDArray[np.float64]

LONGEST_MARCH_MM, MARCH_STEP_MM = 90.0, 2.0
GRAZING_POWER = 6  # thickness is measured on outlines: trust falls with cos**6 away from them
THICKEST_SHARE, THICKEST_EXTRA_MM = 1.8, 4.0  # a cap is no thicker than this against its median; more is a tail
INNER_MM = 6.0  # the volume reaches this far into the head, so that the hairline is a clean cut
DRAPE_MM = 25.0  # taste: hair on shoulders and cheeks lies this thick at most
VOXEL_M = 0.004
SMOOTH_VOXELS = 0.8
COARSE = 4  # voxels a side of a trial cell
PLANE_REACH_M = 0.03
THINNEST_CAP_MM = 0.5
DRAPE_DOUBT_MM = 4.0
LIFT_MM = 2.5  # labels are read this far above the skin: clear of the mesh, below the hair's surface
CUT_SLACK_MM = 0.5
CLIP_MM = 15.0  # the field is cut off here, so that smoothing stays local


@dataclass(frozen=True, slots=True, eq=False)
class Scalp:
    """Hair measured on the skin's vertices.

    Attributes
    ----------
    points_m, normals : (N, 3)
    hairy : (N,) float64 in 0..1, smooth over the surface
    thickness_mm : (N,) float64
        Of the cap; zero where there is no hair.
    """

    points_m: Array
    normals: Array
    hairy: Array
    thickness_mm: Array


def measure_scalp(views: list[HairView], points_m: Array, normals: Array, graph: SurfaceGraph) -> Scalp:
    """Return where hair grows and how far it stands off the skin.

    Thickness is the length of the hull along the normal. It is exact where
    the normal is square to a photo's line of sight, that is on an outline;
    between outlines the hull of few photos bulges, so thickness spreads from the outlines there.

    Parameters
    ----------
    views : list of HairView
    points_m, normals : (N, 3) skin vertices of head and neck
    graph : SurfaceGraph of those vertices
    """
    steps = np.arange(MARCH_STEP_MM, LONGEST_MARCH_MM, MARCH_STEP_MM)
    reach = np.zeros(len(points_m))
    alive = np.ones(len(points_m), bool)
    for step in steps:
        rows = np.flatnonzero(alive)
        if rows.size == 0:
            break
        depth = hull_mm(views, points_m[rows] + normals[rows] * m_from_mm(step))
        alive[rows[depth <= 0.0]] = False
        reach[rows[depth > 0.0]] = step
    hairy = graph.smooth((reach > 0.0).astype(float), 2)
    trust = np.zeros(len(points_m))
    for view in views:
        towards = view.posed.camera.position_m - view.to_view(points_m)
        towards /= np.linalg.norm(towards, axis=1, keepdims=True)
        turned = normals * ((-1.0, 1.0, 1.0) if view.flip_m is not None else 1.0) @ view.view_from_rest[:3, :3].T
        across = 1.0 - np.abs(np.einsum("nk,nk->n", turned, towards))
        trust = np.maximum(trust, np.clip(across, 0.0, 1.0) ** GRAZING_POWER)
    trust = np.where(reach > 0.0, trust, 0.0)
    if not np.any(trust > 0.0):
        return Scalp(points_m, normals, hairy, np.zeros(len(points_m)))
    median = float(np.median(reach[trust > 0.5])) if np.any(trust > 0.5) else float(np.median(reach[reach > 0.0]))
    thickest = THICKEST_SHARE * median + THICKEST_EXTRA_MM
    trust = np.where(reach > thickest, 0.0, trust)  # a tail's root says nothing about the cap
    bounded = np.minimum(reach, thickest)
    smooth = graph.fill(bounded[:, None], trust, 0.05)[:, 0]
    thickness = graph.smooth(np.minimum(smooth, np.maximum(bounded, 0.0)), 2)
    # Half a smooth step: hair thins towards the hairline instead of ending in a wall.
    return Scalp(points_m, normals, hairy, thickness * np.clip(2.0 * hairy - 0.6, 0.0, 1.0))


@dataclass(frozen=True, slots=True, eq=False)
class Near:
    """Grid points against the skin.

    Attributes
    ----------
    points_m : (N, 3)
    skin_mm : (N,) float32, signed distance to the skin, positive outside
    outward : (N, 3) float32, the skin's normal nearby
    thickness_mm, hairy : (N,) float32, of the skin nearby
    """

    points_m: Array
    skin_mm: NDArray[np.float32]
    outward: NDArray[np.float32]
    thickness_mm: NDArray[np.float32]
    hairy: NDArray[np.float32]


def near_skin(scalp: Scalp, points_m: Array) -> Near:
    """Return points with what the nearest four skin vertices say, weighted by closeness."""
    gap, rows = cKDTree(scalp.points_m).query(points_m, k=4)
    weight = 1.0 / (gap + 1e-4) ** 2
    weight /= weight.sum(axis=1, keepdims=True)
    along = np.einsum("nkc,nkc->nk", points_m[:, None] - scalp.points_m[rows], scalp.normals[rows])
    skin = mm_from_m(1.0) * (weight * along).sum(axis=1)
    # Plane distances mean nothing far away, where the Euclidean one takes over.
    skin = np.where(gap[:, 0] > PLANE_REACH_M, np.sign(skin) * mm_from_m(1.0) * gap[:, 0], skin)
    return Near(
        points_m,
        skin.astype(np.float32),
        np.einsum("nk,nkc->nc", weight, scalp.normals[rows]).astype(np.float32),
        (weight * scalp.thickness_mm[rows]).sum(axis=1).astype(np.float32),
        (weight * scalp.hairy[rows]).sum(axis=1).astype(np.float32),
    )


def cap_mm(views: list[HairView], near: Near) -> NDArray[np.float32]:
    """Return (N,) the field of the hair that follows the head, mm.

    Thickness bounds it outwards. Along the skin the labels cut it: they are
    read a little above the skin, also for points below it, so that the
    hairline is one wall through the skin and never a film on it.
    """
    thickness = np.where(near.thickness_mm > THINNEST_CAP_MM, near.thickness_mm, -INNER_MM)
    field = np.minimum(thickness - near.skin_mm, near.skin_mm + INNER_MM)
    rows = np.flatnonzero(field > -CLIP_MM)
    lift = m_from_mm(1.0) * np.maximum(LIFT_MM - near.skin_mm[rows], 0.0)
    cut = hull_mm(views, near.points_m[rows] + near.outward[rows] * lift[:, None])
    field[rows] = np.minimum(field[rows], cut + CUT_SLACK_MM)
    return np.asarray(field, np.float32)


def draped_mm(hull: NDArray[np.float32], near: Near, below_m: float) -> NDArray[np.float32]:
    """Return (N,) the field of hair that lies on neck, shoulders or cheeks below a height, mm."""
    hanging = (near.hairy < 0.5) & (near.points_m[:, 1] < below_m)
    on_bare_skin = np.where(hanging, DRAPE_MM - near.skin_mm, -FAR_MM)
    # Hair thinner than the labels' doubt is none.
    hull = hull - DRAPE_DOUBT_MM
    return np.asarray(np.minimum(np.minimum(hull, on_bare_skin), near.skin_mm + INNER_MM), np.float32)


def hair_field(
    views: list[HairView], scalp: Scalp, low_m: Array, high_m: Array, middle_m: float, drape_below_m: float
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the hair's field and the distance to the skin on a grid.

    Parameters
    ----------
    views : list of HairView
    scalp : Scalp
    low_m, high_m : (3,) corners of the grid, rest frame
    middle_m : float
        x of the head's middle.
    drape_below_m : float
        Height below which hair may lie on bare skin.

    Returns
    -------
    field_mm : (X, Y, Z) float32, positive inside the hair, clipped to +-CLIP_MM
    skin_mm : (X, Y, Z) float32, positive outside the body, FAR_MM where no hair is near
    """
    points, rows, shape = _worthwhile(views, scalp, low_m, high_m)
    field = np.full(int(np.prod(shape)), -CLIP_MM, np.float32)
    skin = np.full(field.shape, np.float32(FAR_MM))
    near = near_skin(scalp, points)
    hull = hull_mm(views, points)
    cap = cap_mm(views, near)
    tail = np.minimum(tail_mm(views, points[(cap > 0.0) & (near.skin_mm > 0.0)], points, middle_m), hull)
    field[rows] = np.clip(np.maximum(np.maximum(cap, tail), draped_mm(hull, near, drape_below_m)), -CLIP_MM, CLIP_MM)
    skin[rows] = near.skin_mm
    return gaussian_filter(field.reshape(shape), SMOOTH_VOXELS), skin.reshape(shape)


def _worthwhile(
    views: list[HairView], scalp: Scalp, low_m: Array, high_m: Array
) -> tuple[Array, NDArray[np.int64], tuple[int, ...]]:
    """Return grid points near possible hair (N, 3), their flat rows, and the grid's shape.

    A coarse grid is tried first; nine tenths of the box hold nothing.
    """
    cells = np.ceil((high_m - low_m) / (COARSE * VOXEL_M)).astype(int)
    shape = tuple(int(n) for n in cells * COARSE)
    middle = [low_m[k] + (np.arange(cells[k]) * COARSE + 0.5 * (COARSE - 1)) * VOXEL_M for k in range(3)]
    coarse = np.stack(np.meshgrid(*middle, indexing="ij"), axis=-1).reshape(-1, 3)
    radius_mm = mm_from_m(COARSE * VOXEL_M)
    hairy = scalp.thickness_mm > 0.0
    wanted = hull_mm(views, coarse) > -radius_mm
    if hairy.any():
        reach = m_from_mm(float(scalp.thickness_mm.max()) + INNER_MM + radius_mm)
        wanted |= cKDTree(scalp.points_m[hairy]).query(coarse, distance_upper_bound=reach)[0] < reach
    grid = binary_dilation(wanted.reshape(tuple(cells)))
    fine = np.argwhere(grid.repeat(COARSE, 0).repeat(COARSE, 1).repeat(COARSE, 2))
    rows = np.asarray(np.ravel_multi_index(tuple(fine.T), shape), np.int64)
    return low_m + fine * VOXEL_M, rows, shape
