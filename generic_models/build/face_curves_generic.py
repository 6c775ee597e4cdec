"""Curves of the generic face that photos show as edges: lids and the line between the lips, as rows of vertices."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from cloner.generic.load import GenericHuman

#: Stops of each curve, features or MPEG-4 points, and how many points it gets. The right lids mirror the left ones.
STOPS: Final = {
    "lid_upper_L": (("eye_inner_L", "eye_upper_L", "eye_outer_L"), 11),
    "lid_lower_L": (("eye_inner_L", "eye_lower_L", "eye_outer_L"), 11),
    "mouth": (("2.5", "stomion", "2.4"), 13),
}
#: A step back along x by more than this is a detour to a stop beside the mesh's ring, metres.
_BACK_M: Final = 2e-4


def face_curves(generic: GenericHuman) -> dict[str, list[int]]:
    """Return the vertices of each curve along the mesh's edges, spread evenly."""
    graph = _edges(generic)
    out = {}
    for name, (stops, count) in STOPS.items():
        path = _forward(generic, _path(graph, [generic.feature(stop) for stop in stops]))
        out[name] = _even(generic, path, count)
        if name.endswith("_L"):
            out[name[:-1] + "R"] = [int(generic.mirror[vertex]) for vertex in out[name]]
    return out


def _edges(generic: GenericHuman) -> csr_matrix:
    pairs = generic.quads[:, [0, 1, 1, 2, 2, 3, 3, 0]].reshape(-1, 2)
    body = (generic.vertex_part[pairs] == generic.part_names.index("body")).all(axis=1)
    pairs = np.unique(np.sort(pairs[body & (pairs[:, 0] != pairs[:, 1])], axis=1), axis=0)
    length = np.linalg.norm(generic.vertices_m[pairs[:, 0]] - generic.vertices_m[pairs[:, 1]], axis=1)
    rows, columns = np.concatenate([pairs, pairs[:, ::-1]]).T
    return csr_matrix((np.tile(length, 2), (rows, columns)), shape=(len(generic.vertices_m),) * 2)


def _path(graph: csr_matrix, stops: list[int]) -> list[int]:
    out = [stops[0]]
    for goal in stops[1:]:
        _, before = dijkstra(graph, indices=goal, return_predecessors=True)
        while out[-1] != goal:
            out.append(int(before[out[-1]]))
    return out


def _forward(generic: GenericHuman, path: list[int]) -> list[int]:
    out = path[:1]
    for vertex in path[1:]:
        if generic.vertices_m[vertex, 0] > generic.vertices_m[out, 0].max() - _BACK_M and vertex not in out:
            out.append(vertex)
    return out


def _even(generic: GenericHuman, path: list[int], count: int) -> list[int]:
    along: NDArray[np.float64] = np.concatenate(
        [[0.0], np.cumsum(np.linalg.norm(np.diff(generic.vertices_m[path], axis=0), axis=1))]
    )
    rows = {int(np.abs(along - at).argmin()) for at in np.linspace(0.0, along[-1], count)}
    return [path[row] for row in sorted(rows)]
