"""Fold-free parametrisation of skin patches over a disc, and star-shaped domes.

References
----------
Floater 1997, "Parametrization and smooth approximation of surface triangulations" (convex combinations never fold);
Yoshizawa, Belyaev & Seidel 2004, "A fast and simple stretch-minimizing mesh parameterization", eq. 3.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import splu

from cloner.geometry.meshes.triangles import areas, edges_of
from cloner.records.arrays import Array

Index = NDArray[np.integer]

#: Rounds after which triangles hardly become more even, and how much of the stretch a round takes back (measured on
#: toes: with all of it rounds swing and fold after ten).
ROUNDS: Final = 20
TAKEN_BACK: Final = 0.7


def even_disc_weights(triangles: Index, wanted: Array, rim_flat: Array, laid: Callable[[Array], Array]) -> Array:
    """Return the weights (N, B) of the rim's B vertices for every vertex of a patch, evenly and without folds.

    Parameters
    ----------
    triangles : (T, 3) int
        One disc over vertices 0..N-1; the rim is the vertices of its border, in increasing order.
    wanted : (T,)
        Areas that the triangles should have, up to a common factor.
    rim_flat : (B, 2)
        Where the rim lies on the disc.
    laid : callable
        Gives the (N, 3) places on the finished surface of places (N, 2) on the disc.
    """
    edges, owners = edges_of(triangles)
    rim, count = np.unique(edges[owners == 1]), int(triangles.max()) + 1
    one, other = np.concatenate([edges, edges[:, ::-1]]).T
    inner = np.setdiff1d(np.arange(count), rim)
    weights = np.ones(len(one))
    shares = np.zeros((count, len(rim)))
    shares[rim, np.arange(len(rim))] = 1.0
    for _ in range(ROUNDS):
        matrix = coo_matrix((weights, (one, other)), shape=(count, count)).tocsr()
        system = (diags(np.asarray(matrix.sum(axis=1)).ravel()) - matrix).tocsr()
        shares[inner] = splu(system[inner][:, inner].tocsc()).solve(-system[inner][:, rim].toarray())
        own = areas(laid(shares @ rim_flat), triangles)
        squared = wanted / wanted.sum() / np.maximum(own / own.sum(), 1e-12)
        corners = triangles.ravel()
        stretch = np.bincount(corners, np.repeat(wanted * squared, 3)) / np.bincount(corners, np.repeat(wanted, 3))
        weights /= np.sqrt(stretch[other]) ** TAKEN_BACK
    return shares
