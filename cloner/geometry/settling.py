"""A smooth displacement along the normals that lays a body's rim on the photos' outlines.

Beyond the paper (method §7): takes up what slices cannot reach - shoulders, crotch,
feet, hands - with all photos at once.
"""

from __future__ import annotations

import functools

import numpy as np
import scipy.sparse as sparse
from numpy.typing import NDArray
from scipy.sparse.linalg import splu

Array = NDArray[np.float64]


@functools.lru_cache(maxsize=4)
def _bending(triangles_bytes: bytes, count: int) -> sparse.csc_matrix:
    triangles = np.frombuffer(triangles_bytes, dtype=np.int32).reshape(-1, 3)
    rows = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    rows = np.concatenate([rows, rows[:, ::-1]])
    links = sparse.coo_matrix((np.ones(len(rows)), (rows[:, 0], rows[:, 1])), shape=(count, count)).tocsr()
    links.data[:] = 1.0
    degree = np.maximum(np.asarray(links.sum(axis=1)).ravel(), 1.0)
    laplacian = sparse.identity(count, format="csr") - sparse.diags(1.0 / degree) @ links
    return (laplacian.T @ laplacian).tocsc()


def bending_matrix(triangles: NDArray[np.int32], count: int) -> sparse.csc_matrix:
    """Return the (V, V) energy ``|L h|²`` of a field h on a mesh's vertices (uniform Laplacian)."""
    return _bending(np.ascontiguousarray(triangles, dtype=np.int32).tobytes(), count)


def settle(
    rows: NDArray[np.int64],
    slope: Array,
    gap: Array,
    weight: Array,
    bending: sparse.csc_matrix,
    *,
    stiffness: Array | float,
    anchor: Array,
) -> Array:
    """Return the (V,) heights h that minimise Σ w (slope·h − gap)² + stiffness |L h|² + Σ anchor h².

    Parameters
    ----------
    rows : (K,) vertex of each outline observation
    slope : (K,) change of the observed gap per metre of height
    gap : (K,) wanted change, same unit
    weight : (K,) weights of the squares
    bending : (V, V) from :func:`bending_matrix`
    stiffness : float
    anchor : (V,) pull towards zero
    """
    count = bending.shape[0]
    data = np.bincount(rows, weight * slope * slope, count)
    right = np.bincount(rows, weight * slope * gap, count)
    matrix = (stiffness * bending + sparse.diags(data + anchor)).tocsc()
    return np.asarray(splu(matrix, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}).solve(right))
