"""The finished hair shell, moved until its outlines are those of the photos."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.frames import m_from_mm
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.volumes.cap import DEEPEST_MM, outline_gaps, surface_mm
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array

SHELL_ROUNDS = 5  # of the finished shell
WALL_MM = 6.0  # what lies so near to the skin and faces it is no outline: it came out through the hair over it
SHELL_STIFFNESS = 3.0  # of what it is moved by in all, against one outline point


def settle_shell(
    views: list[HairView],
    skin: tuple[Array, Array],
    vertices_m: Array,
    triangles: NDArray[np.int32],
    least_mm: float,
) -> Array:
    """Return the finished shell's vertices (N, 3) with its outlines on those of the photos.

    The cap met them with the head's coarse mesh; voxels, tails and what stands out over the hairline did not yet. What
    the shell is moved by in all is smooth, in its directions too: no outline tells how deep what faces its camera lies,
    and surfaces blown up along their own normals round by round became strings of pearls.

    Parameters
    ----------
    views : list of HairView
    skin : (M, 3) vertices of the skin below, m, and their normals
    vertices_m, triangles : the shell
    least_mm : float
        No vertex is pushed nearer to the skin than this.
    """
    graph, start_m = surface_graph(vertices_m, triangles), vertices_m
    clear_mm, outward = _skin_distance_mm(skin, start_m)
    moved_mm, floor_mm = np.zeros_like(start_m), np.minimum(clear_mm, least_mm)
    known = clear_mm > -DEEPEST_MM  # deeper: below the neck, beside what is known
    facing = np.einsum("nc,nc->n", outward, vertex_normals(start_m, triangles))
    outer = (facing > 0.0) | (clear_mm > WALL_MM)
    for _ in range(SHELL_ROUNDS):
        drive, trust = (outer * each for each in outline_forces_mm(views, vertices_m, triangles))
        gap = drive / np.maximum(trust, 1e-9)
        wanted_mm = moved_mm + gap[:, None] * vertex_normals(vertices_m, triangles)
        moved_mm = graph.fill(wanted_mm, np.clip(trust, 0.0, 1.0), SHELL_STIFFNESS)
        vertices_m = start_m + m_from_mm(1.0) * moved_mm
        clear_mm, outward = _skin_distance_mm(skin, vertices_m)
        inside = known & (clear_mm < floor_mm)
        vertices_m = vertices_m + np.where(inside, m_from_mm(1.0) * (floor_mm - clear_mm), 0.0)[:, None] * outward
    return vertices_m


def _skin_distance_mm(skin: tuple[Array, Array], points_m: Array) -> tuple[Array, Array]:
    """Return the distance (N,) of points from the skin, mm, and the direction away from it (N, 3)."""
    away, rows, weight = surface_mm(*skin, points_m)
    return away.astype(np.float64), np.einsum("nk,nkc->nc", weight, skin[1][rows])


def outline_forces_mm(views: list[HairView], surface_m: Array, triangles: NDArray[np.int32]) -> tuple[Array, Array]:
    """Return the sum (N,) of the displacements that photos ask of a surface, mm, and of their weights."""
    drive, trust = np.zeros(len(surface_m)), np.zeros(len(surface_m))
    for gap, weight in outline_gaps(views, surface_m, triangles):
        drive += weight * gap
        trust += weight
    return drive, trust
