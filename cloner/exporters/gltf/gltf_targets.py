"""Morph targets of a glTF, with the normals' changes.

Without the second the light stays where it lay on the resting face: a smile lifts no cheek. Only what turns by more
than is seen is stored, of the face's own targets; correctives keep the flesh of limbs, whose normals the bones turn:
those of the resting shape with a corrective are farther from the bent surface's (by 7-35 degrees in the mean of twelve
bends of anna) than those without (5-16).

References
----------
Khronos Group 2021, glTF 2.0 specification, section 3.7.2.2 (morph targets).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.caching import cached_per_object
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.generic.load import load_generic
from cloner.generic.morphs import wedge_offsets
from cloner.generic.surfaces import load_triangles
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.motion.flesh.correctives import CORRECTIVE
from cloner.records.clones import Clone

#: Smaller offsets of a morph target cannot be seen, metres; taste.
SMALLEST_OFFSET_M: Final = 2e-5
#: Normals that turn less keep the resting one, length of the difference (3 degrees); taste.
SMALLEST_TURN: Final = 0.05

Turns = list[tuple[NDArray[np.int32], NDArray[np.float32]]]


def targets_of(
    buffer: GltfBuffer, clone: Clone, vertex: NDArray[np.int32], *, turns_of: Clone | None = None
) -> list[dict[str, int]]:
    """Return the attributes of every morph target of a surface; what belongs to one vertex of the skin moves alike.

    Parameters
    ----------
    buffer : GltfBuffer
    clone : Clone
    vertex : (N,) int32
        The generic human's vertex of every vertex of the surface.
    turns_of : Clone or None
        Store how normals turn too, as those of this clone do: it or what it was before its irises were laid flat.
    """
    found = [{"POSITION": number} for number in _sparse(buffer, len(vertex), _moved(clone, vertex))]
    if turns_of is not None:
        turned = _sparse(buffer, len(vertex), turned_normals(turns_of, vertex), plain=True)
        for target, number in zip(found, turned, strict=True):
            target["NORMAL"] = number
    return found


def _moved(clone: Clone, vertex: NDArray[np.int32]) -> Iterator[tuple[NDArray[np.int64], NDArray[np.float32]]]:
    for _, moved, own in wedge_offsets(clone, vertex, SMALLEST_OFFSET_M):
        yield moved, own


def turned_normals(
    clone: Clone, vertex: NDArray[np.integer]
) -> Iterator[tuple[NDArray[np.int64], NDArray[np.float32]]]:
    """Yield for every morph target the wedges (M,) whose normals it turns, ascending, and the differences (M, 3).

    ``vertex`` (N,) is the generic human's vertex of every wedge.
    """
    row = np.full(len(clone.vertices_m) + 1, -1, np.int32)
    for turned, difference in normal_turns(clone):
        row[turned] = np.arange(len(turned), dtype=np.int32)
        own = row[vertex]
        wedges = np.flatnonzero(own >= 0)
        yield wedges, difference[own[wedges]]
        row[turned] = -1


def _sparse(
    buffer: GltfBuffer,
    count: int,
    changes: Iterator[tuple[NDArray[np.int64], NDArray[np.float32]]],
    *,
    plain: bool = False,
) -> list[int]:
    """Return an accessor for every target; those that leave this surface alone share one of zeros."""
    accessors, still = [], -1
    for rows, values in changes:
        if len(rows) == 0 and still >= 0:
            accessors.append(still)
            continue
        accessors.append(buffer.sparse(count, rows, values) if plain else buffer.offsets(count, rows, values))
        still = accessors[-1] if len(rows) == 0 else still
    return accessors


@cached_per_object
def normal_turns(clone: Clone) -> Turns:
    """Return for every morph target the vertices (M,) whose normals turn, and the differences (M, 3) of unit normals.

    Teeth keep theirs, which are not those of their surface; so does everything under corrective targets.
    """
    triangles, found = load_triangles(), []
    count = len(clone.vertices_m)
    corners = np.argsort(triangles.ravel(), kind="stable") // 3  # the triangles around each vertex, one after the other
    start = np.searchsorted(np.sort(triangles.ravel()), np.arange(count + 1))
    generic = load_generic()
    teeth = np.isin(generic.vertex_part, [generic.part_names.index(f"teeth_{jaw}") for jaw in ("upper", "lower")])
    rest = vertex_normals(clone.vertices_m, triangles)
    for k, name in enumerate(clone.morph_names):
        if name.startswith(CORRECTIVE):
            found.append((np.zeros(0, np.int32), np.zeros((0, 3), np.float32)))
            continue
        rows = slice(int(clone.morph_start[k]), int(clone.morph_start[k + 1]))
        moved = np.zeros(count, bool)
        moved[clone.morph_index[rows]] = True
        touched = np.unique(triangles[_around(corners, start, np.flatnonzero(moved))])
        near, local = np.unique(triangles[_around(corners, start, touched)], return_inverse=True)
        points = clone.vertices_m.copy()
        points[clone.morph_index[rows]] += clone.morph_delta_m[rows]
        difference = vertex_normals(points[near], local.reshape(-1, 3).astype(np.int32)) - rest[near]
        seen = np.isin(near, touched) & (np.linalg.norm(difference, axis=1) > SMALLEST_TURN) & ~teeth[near]
        found.append((near[seen].astype(np.int32), difference[seen].astype(np.float32)))
    return found


def _around(corners: NDArray[np.int64], start: NDArray[np.int64], vertices: NDArray[np.integer]) -> NDArray[np.int64]:
    """Return the triangles that touch vertices, each once."""
    size = start[vertices + 1] - start[vertices]
    ahead = np.cumsum(size) - size
    return np.unique(corners[np.arange(int(size.sum())) + np.repeat(start[vertices] - ahead, size)])
