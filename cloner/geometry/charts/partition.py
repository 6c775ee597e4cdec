"""Assignment of surface parts to photos, with blend bands between them.

References
----------
Method notes sections 9 (feature lines between front and side) and 10.2
(front/back border, alpha = (1 + d / L) / 2).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.records.arrays import Array

CRUMB_VERTICES = 40  # taste: a patch of some 6 cm on the body, 2 cm on the face
#: Mark of what belongs to nobody yet.
_UNDECIDED = -2


def partition_surface(scores: Array, graph: SurfaceGraph, *, smoothing: int) -> NDArray[np.int32]:
    """Return the photo (V,) that owns each vertex, -1 where none sees it.

    Parameters
    ----------
    scores : (K, V), >= 0; how well photo k shows vertex v, 0 = not at all
    graph : SurfaceGraph
    smoothing : int
        Rounds of averaging with neighbours, so that borders are lines, not crumbs.
    """
    soft = graph.smooth(scores.T.copy(), smoothing).T * (scores > 0.0)
    owner = soft.argmax(axis=0).astype(np.int32)
    owner[soft.max(axis=0) <= 0.0] = -1
    return without_small_islands(np.asarray(owner, np.int32), scores, graph)


def without_small_islands(owner: NDArray[np.int32], scores: Array, graph: SurfaceGraph) -> NDArray[np.int32]:
    """Return the owners (V,), islands of few vertices given to the surrounding photo that shows them, or to none.

    Beside an arm that hides it a flank shows in crumbs, and their light is that of the arm's shade.
    """
    link = graph.lengths.tocoo()
    alike = owner[link.row] == owner[link.col]
    kept = coo_matrix((link.data[alike], (link.row[alike], link.col[alike])), shape=link.shape)
    count, part = connected_components(kept, directed=False)
    crumb = (np.bincount(part, minlength=count) < CRUMB_VERTICES)[part] & (owner >= 0)
    found = np.where(crumb, _UNDECIDED, owner)
    while (edge := (found[link.row] == _UNDECIDED) & (found[link.col] >= 0)).any():  # ring by ring from outside in
        votes = np.zeros((len(scores), owner.size))
        np.add.at(votes, (found[link.col[edge]], link.row[edge]), 1.0)
        votes *= scores > 0.0
        ring = np.unique(link.row[edge])
        found[ring] = np.where(votes.max(axis=0) > 0.0, votes.argmax(axis=0), -1)[ring]
    return np.asarray(np.where(found == _UNDECIDED, -1, found), np.int32)


def blend_weights(owner: NDArray[np.int32], count: int, graph: SurfaceGraph, band_m: NDArray[np.floating]) -> Array:
    """Return the weights (K, V) alpha = (1 + d / L) / 2 of every photo.

    Parameters
    ----------
    owner : (V,) from :func:`partition_surface`
    count : int
        Number of photos K.
    graph : SurfaceGraph
        Distances d run along the surface, so a chart's seam changes nothing.
    band_m : (V,) half width L of the mixing band, metres
    """
    shares = np.zeros((count, owner.size))
    limit = float(np.max(band_m)) * 1.5
    for photo in range(count):
        own = owner == photo
        if not own.any():
            continue
        inward = graph.distance_from(~own, limit)
        outward = graph.distance_from(own, limit)
        shares[photo] = np.clip(0.5 * (1.0 + (inward - outward) / band_m), 0.0, 1.0)
    return shares
