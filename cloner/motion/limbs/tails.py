"""Free-hanging hair as swinging joint chains: tails and plaits of a finished clone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components, dijkstra
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.geometry.meshes.triangles import edges_of
from cloner.geometry.meshes.vectors import arc_lengths, places_along
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.heads import Shell

Ints = NDArray[np.int64]

#: Hair farther from the scalp than this hangs, metres: the cap is at most 25 mm thick there (`hair.volumes.volume`).
FREE_M: Final = 0.03
#: Wider hair is no tail but hangs loose around the neck, metres (`hair.volumes.tail.WIDEST_TAIL_MM`).
WIDEST_M: Final = 0.11
#: Shorter ends do not swing, metres; taste.
SHORTEST_M: Final = 0.08
#: Length of one bone, metres, and the most bones of a tail: more look no softer (taste).
BONE_M: Final = 0.07
MOST_BONES: Final = 5
#: Height of the slices in which a tail's middle and breadth are told, metres.
_SLICE_M: Final = 0.01


@dataclass(frozen=True, slots=True, eq=False)
class Tail:
    """A chain of bones along hair that hangs free.

    Attributes
    ----------
    shell : int
        Place among the clone's shells.
    points_m : (B + 1, 3) float64
        Where its bones begin, from the head down, and the last one's end; model frame, metres.
    radius_m : (B + 1,) float64
        Half its thickness at each.
    share : (N, B) float64
        Share of every vertex of the shell that each bone carries; what is left stays with the joints before.
    joint : str
        The joint that it hangs on.
    """

    shell: int
    points_m: Array
    radius_m: Array
    share: Array
    joint: str = "skullbase"


def tails(clone: Clone) -> tuple[Tail, ...]:
    """Return the tails of a clone; none where hair is short or hangs loose."""
    return search_shells(clone, "hair", _tails)


def search_shells(clone: Clone, kind: str, find: Callable[[Clone, Shell, int], list[Tail]]) -> tuple[Tail, ...]:
    """Return the results of a search on a clone's shells of one kind; it takes the clone, the shell and its index."""
    shells = [(number, shell) for number, shell in enumerate(clone.shells) if shell.kind == kind]
    return tuple(tail for number, shell in shells for tail in find(clone, shell, number))


def _tails(clone: Clone, shell: Shell, number: int) -> list[Tail]:
    scalp = clone.vertices_m[load_generic().region("scalp")]
    places, welded = np.unique(np.round(shell.vertices_m, 6), axis=0, return_inverse=True)
    edges = edges_of(welded.reshape(-1)[shell.triangles])[0]
    free = np.asarray(cKDTree(scalp).query(places)[0]) > FREE_M
    own = edges[free[edges].all(axis=1)]
    _, piece = connected_components(_graph(places, own), directed=False)
    found = []
    for name in np.unique(piece[free]):
        rows = np.flatnonzero(free & (piece == name))
        if _is_narrow(places[rows]):
            rest = np.setdiff1d(np.unique(edges[free[edges].any(axis=1)]), np.flatnonzero(free))
            tail = _chain(places, edges, rows, rest)
            if tail is not None:
                points, radius = tail
                share = np.zeros((len(places), len(points) - 1))
                share[rows] = _shares(places[rows], points)
                found.append(Tail(number, points, radius, share[welded.reshape(-1)]))
    return found


def _graph(places: Array, edges: NDArray[np.integer]) -> coo_matrix:
    lengths = np.linalg.norm(places[edges[:, 0]] - places[edges[:, 1]], axis=1)
    return coo_matrix((np.maximum(lengths, 1e-9), tuple(edges.T)), shape=(len(places), len(places)))


def _is_narrow(points_m: Array) -> bool:
    """Return whether a piece of hair is long enough to swing and nowhere as wide as loose hair."""
    if np.linalg.norm(np.ptp(points_m, axis=0)) < SHORTEST_M:
        return False
    level = np.floor(points_m[:, 1] / _SLICE_M).astype(np.int64)
    widths = [np.linalg.norm(np.ptp(points_m[level == one][:, [0, 2]], axis=0)) for one in np.unique(level)]
    return bool(np.percentile(widths, 90) < WIDEST_M)


def _chain(places: Array, edges: NDArray[np.integer], rows: Ints, rest: Ints) -> tuple[Array, Array] | None:
    """Return the ends (B + 1, 3) of a tail's bones and half its thickness there, None where it is too short.

    Distances over the hair from where it leaves the head cut it into slices; their middles are its course.
    """
    touching = np.intersect1d(rest, np.unique(edges[np.isin(edges, rows).any(axis=1)]))
    if not len(touching):
        return None
    graph = _graph(places, edges[np.isin(edges, np.concatenate([rows, touching])).all(axis=1)])
    along = dijkstra(graph, directed=False, indices=touching, min_only=True)[rows]
    rows, along = rows[np.isfinite(along)], along[np.isfinite(along)]
    if not len(rows) or along.max() < SHORTEST_M:
        return None
    slices = np.minimum((along / _SLICE_M).astype(np.int64), int(np.percentile(along, 95) / _SLICE_M))
    course = np.array([places[rows][slices == one].mean(axis=0) for one in np.unique(slices)])
    spread = np.array([np.median(_from_axis(places[rows][slices == one])) for one in np.unique(slices)])
    length = arc_lengths(course)
    if length[-1] < SHORTEST_M:
        return None
    bones = int(np.clip(round(length[-1] / BONE_M), 2, MOST_BONES))
    ends = np.linspace(0.0, length[-1], bones + 1)
    points = places_along(course, length, ends)
    return points, np.interp(ends, length, spread)


def _from_axis(points_m: Array) -> Array:
    """Return (N,) horizontal distances from the middle, metres."""
    return np.asarray(np.linalg.norm((points_m - points_m.mean(axis=0))[:, [0, 2]], axis=1))


def _shares(points_m: Array, ends_m: Array) -> Array:
    """Return the weights (N, B) of the bones: each carries its own middle alone and blends into the next.

    At the chain's start nothing is carried by it, so that the seam to the head's hair stays closed.
    """
    first, way = ends_m[:-1], np.diff(ends_m, axis=0)
    share = np.einsum("nba,ba->nb", points_m[:, None] - first, way) / np.einsum("ba,ba->b", way, way)
    share = np.clip(share, 0.0, 1.0)
    away = np.linalg.norm(points_m[:, None] - first - share[..., None] * way, axis=2)
    nearest = away.argmin(axis=1)
    return chain_weights(nearest + share[np.arange(len(points_m)), nearest], len(way))


def chain_weights(place: Array, bones: int) -> Array:
    """Return the weights (N, B) of a chain's bones at positions (N,), in bones from its start: 1 at middles, less
    between.
    """
    middles = np.arange(bones) + 0.5
    found = np.clip(1.0 - np.abs(place[:, None] - middles), 0.0, 1.0)
    found[:, 0] = np.clip(np.minimum(2.0 * place, 1.5 - place), 0.0, 1.0)
    found[:, -1] = np.where(place > middles[-1], 1.0, found[:, -1])
    return np.asarray(found)
