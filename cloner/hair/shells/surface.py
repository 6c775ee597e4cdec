"""The hair's outer surface: the scalp scanned, and the field of the photos' evidence made a mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.shells.mesh import extract_mesh, lowest_hair_m
from cloner.hair.volumes.cap import Scalp, measure_scalp
from cloner.hair.volumes.crowns import align_crowns
from cloner.hair.volumes.tail import find_tail
from cloner.hair.volumes.views import HairView
from cloner.hair.volumes.volume import hair_field
from cloner.records.arrays import Array
from cloner.records.clones import Joined


@dataclass(frozen=True, slots=True)
class MeshLimits:
    """Size of the hair's mesh.

    Attributes
    ----------
    triangles : int
        Most triangles of the shell.
    margin_m : float
        How far the volume reaches around the head, and below the lowest hair.
    smallest_piece : float
        Pieces below this share of the largest are dropped.
    """

    triangles: int = 8000
    margin_m: float = 0.14
    smallest_piece: float = 0.02


def head_rows(generic: GenericHuman) -> NDArray[np.int64]:
    """Return the skin vertices of head and neck, without the mouth's inside."""
    skin = generic.vertex_part[generic.head_vertices] == generic.part_names.index("body")
    inside = generic.region("mouth_interior")[generic.head_vertices]
    return np.asarray(generic.head_vertices[skin & ~inside], dtype=np.int64)


def median_plane_x(generic: GenericHuman, joined: Joined) -> float:
    """Return x of the head's median plane, metres."""
    return float(joined.joints_m[generic.joint_names.index("skullbase"), 0])


def scan_scalp(generic: GenericHuman, joined: Joined, views: list[HairView]) -> Scalp:
    """Return the hair measured at the head's vertices."""
    rows = head_rows(generic)
    triangles = body_triangles()
    normals = vertex_normals(joined.vertices_m, triangles)
    graph = surface_graph(joined.vertices_m, triangles)
    place = np.full(len(joined.vertices_m), -1, np.int32)
    place[rows] = np.arange(len(rows), dtype=np.int32)
    own = place[triangles]
    own = np.ascontiguousarray(own[(own >= 0).all(axis=1)])
    points, scalp = joined.vertices_m[rows], generic.region("scalp")[rows]
    ears = generic.region("ear_left")[rows] | generic.region("ear_right")[rows]
    tail = find_tail(views, points, own, median_plane_x(generic, joined))
    return measure_scalp(views, points, normals[rows], own, graph.part(rows), scalp, ears, tail)


def tucked_skin(generic: GenericHuman, joined: Joined, scalp: Scalp) -> tuple[Array, Array]:
    """Return vertices (M, 3) of the whole body's skin, the scalp tucked in, and their normals."""
    skin, tucked = generic.vertex_part == generic.part_names.index("body"), joined.vertices_m.copy()
    tucked[head_rows(generic)] = scalp.points_m
    return tucked[skin], vertex_normals(tucked, body_triangles())[skin]


def with_common_height(generic: GenericHuman, joined: Joined, views: list[HairView], scalp: Scalp) -> list[HairView]:
    """Return the views with one height of hair over the ears."""
    ears = generic.region("ear_left") | generic.region("ear_right")
    return align_crowns(views, scalp.points_m, float(joined.vertices_m[ears, 1].mean()))


def hair_mesh(
    generic: GenericHuman,
    joined: Joined,
    views: list[HairView],
    scalp: Scalp,
    skin: tuple[Array, Array],
    limits: MeshLimits,
) -> tuple[Array, NDArray[np.int32]] | None:
    """Return vertices (N, 3) and triangles (T, 3) of the hair's outer surface, None when empty.

    ``skin`` is what :func:`tucked_skin` gives.
    """
    reach = np.array([limits.margin_m, 0.0, limits.margin_m])
    low, high = scalp.points_m.min(axis=0) - reach, scalp.points_m.max(axis=0) + reach + (0.0, limits.margin_m, 0.0)
    low[1] = min(low[1], lowest_hair_m(views) - limits.margin_m)
    ear = generic.region("ear_left") | generic.region("ear_right")
    level = float(joined.vertices_m[ear, 1].mean())
    # Ears are folds: by the planes of their skin the hair above them would lie in the head, which left a hole.
    smooth = ~ear[generic.vertex_part == generic.part_names.index("body")]
    body = skin[0][smooth], skin[1][smooth]
    field, skin_mm = hair_field(views, scalp, body, low, high, median_plane_x(generic, joined), level)
    return extract_mesh(field, skin_mm, low, limits.triangles, limits.smallest_piece)
