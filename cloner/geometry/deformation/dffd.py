"""Dirichlet free-form deformation: exact Sibson coordinates, then one sparse product.

References
----------
Sibson 1980, "A vector identity for the Dirichlet tessellation" (coordinates).
Watson 1992, "Contouring", ch. 2.6 (volumes as sums of signed simplices).
Lee, Gu, Magnenat-Thalmann 2000, section 2.1 (DFFD of heads).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.spatial import Delaunay, cKDTree

from cloner.records.arrays import Array

Indices = NDArray[np.int64]

#: Symmetric control points are cospherical, where Delaunay is not unique and circumcentres run to infinity. A
#: deterministic shift of this share of the span makes the tessellation general; linear precision is restored after.
GENERAL_POSITION = 1e-4
#: Queries nearer than this share of the span to a control point are that point.
SAME_POINT = 1e-6
#: A query in the plane of a face sends a circumcentre to infinity too; rows whose raw coordinates miss the query by
#: more than this share of the span lost their digits there and are taken again from a shifted place.
LOST_DIGITS = 1e-7
#: Pairs of query and tetrahedron tested at once; keeps memory near 100 MiB.
CHUNK = 2_000_000


def enclosing_points(points_m: Array, *, margin: float = 0.6) -> Array:
    """Return 26 points on a box around ``points_m``: corners, edge and face middles.

    Parameters
    ----------
    points_m : (N, 3) float64, metres
    margin : float
        Distance of the box from the points as a share of the largest extent (taste: far enough that the box's
        points, which never move, hold the mesh's rim softly).
    """
    low, high = points_m.min(0), points_m.max(0)
    gap = margin * float((high - low).max())
    axes = np.stack([low - gap, (low + high) / 2.0, high + gap])
    grid = np.stack(np.meshgrid([0, 1, 2], [0, 1, 2], [0, 1, 2], indexing="ij"), axis=-1).reshape(-1, 3)
    grid = grid[~(grid == 1).all(axis=1)]
    return np.asarray(axes[grid, np.arange(3)], dtype=np.float64)


def circumcentres(corners: Array) -> Array:
    """Return the (N, 3) circumcentres of (N, 4, 3) tetrahedra."""
    edges = corners[:, 1:] - corners[:, :1]
    right = 0.5 * (edges**2).sum(axis=2)
    crosses = np.stack(
        [np.cross(edges[:, 1], edges[:, 2]), np.cross(edges[:, 2], edges[:, 0]), np.cross(edges[:, 0], edges[:, 1])],
        axis=1,
    )
    determinant = np.einsum("na,na->n", edges[:, 0], crosses[:, 0])
    determinant = np.where(np.abs(determinant) < 1e-300, 1e-300, determinant)
    return np.asarray(corners[:, 0] + np.einsum("nk,nka->na", right, crosses) / determinant[:, None])


def sibson_weights(queries_m: Array, controls_m: Array) -> csr_matrix:
    """Return the (Q, C) natural-neighbour coordinates of queries among control points.

    The weight of control point i is the share of the query's Voronoi cell that i's cell loses when the query is
    inserted. Rows are non-negative, sum to one and reproduce the query's own position.

    Parameters
    ----------
    queries_m : (Q, 3) float64
        Must lie inside the convex hull of the control points.
    controls_m : (C, 3) float64

    Raises
    ------
    ValueError
        If a query lies outside the hull of the control points, or two control points coincide.
    """
    span = float(np.ptp(controls_m, axis=0).max())
    tree = cKDTree(controls_m)
    if len(tree.query_pairs(SAME_POINT * span)) > 0:
        raise ValueError("two control points coincide")
    noise = np.random.default_rng(1)
    general = controls_m + GENERAL_POSITION * span * noise.uniform(-1.0, 1.0, controls_m.shape)
    tessellation = Delaunay(general)
    if (tessellation.find_simplex(queries_m) < 0).any():
        raise ValueError("a query lies outside the hull of the control points")
    distance, nearest = tree.query(queries_m)
    on_control = distance < SAME_POINT * span
    weights = _general_weights(queries_m, general, tessellation.simplices.astype(np.int64), span, noise)
    weights = _restore_linear_precision(weights, queries_m, controls_m)
    free = csr_matrix((~on_control).astype(np.float64)[:, None])
    rows = np.flatnonzero(on_control)
    exact = csr_matrix((np.ones(len(rows)), (rows, nearest[rows])), shape=weights.shape)
    return csr_matrix(weights.multiply(free) + exact)


def _general_weights(
    queries: Array, controls: Array, simplices: Indices, span: float, noise: np.random.Generator
) -> csr_matrix:
    """Return weights of queries shifted into general position, retaken where digits were lost."""
    weights = csr_matrix((len(queries), len(controls)))
    left = np.arange(len(queries))
    for _ in range(6):
        moved = queries[left] + GENERAL_POSITION * span * noise.uniform(-0.5, 0.5, (len(left), 3))
        taken = _stolen_volumes(moved, controls, simplices)
        good = np.abs(taken @ controls - moved).max(axis=1) < LOST_DIGITS * span
        place = csr_matrix((np.ones(len(left)), (left, np.arange(len(left)))), shape=(len(queries), len(left)))
        keep = csr_matrix((~np.isin(np.arange(len(queries)), left)).astype(np.float64)[:, None])
        weights = csr_matrix(weights.multiply(keep) + place @ taken)
        left = left[~good]
        if len(left) == 0:
            break
    return weights


def _stolen_volumes(queries: Array, controls: Array, simplices: Indices) -> csr_matrix:
    """Return normalised volumes that each control's Voronoi cell loses to each query.

    In every tetrahedron T whose circumsphere holds the query, corner i loses the signed tetrahedron of T's
    circumcentre and the circumcentres of the query with the three faces of T that meet in i (Watson 1992); faces
    inside the cavity cancel, so the sum is the exact polyhedron.
    """
    corners = controls[simplices]
    centres = circumcentres(corners)
    radius2 = ((corners[:, 0] - centres) ** 2).sum(axis=1)
    rows: list[Indices] = []
    columns: list[Indices] = []
    volumes: list[Array] = []
    step = max(1, CHUNK // len(simplices))
    for start in range(0, len(queries), step):
        block = queries[start : start + step]
        offset = block[:, None, :] - centres[None]
        which, tetra = np.nonzero(np.einsum("qta,qta->qt", offset, offset) < radius2[None])
        lost = _lost_by_corners(block[which], corners[tetra], centres[tetra])
        rows.append(np.repeat(which + start, 4))
        columns.append(simplices[tetra].ravel())
        volumes.append(lost.ravel())
    stolen = csr_matrix(
        (np.concatenate(volumes), (np.concatenate(rows), np.concatenate(columns))),
        shape=(len(queries), len(controls)),
    )
    stolen.sum_duplicates()
    total = np.asarray(stolen.sum(axis=1)).ravel()
    stolen.data /= np.repeat(total, np.diff(stolen.indptr))
    return stolen


def _lost_by_corners(queries: Array, corners: Array, centres: Array) -> Array:
    """Return (N, 4) signed volumes lost by the corners of N tetrahedra, up to one common factor."""
    side = np.sign(np.einsum("na,na->n", corners[:, 1] - corners[:, 0],
                             np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 0])))  # fmt: skip
    new = np.empty_like(corners)
    for skipped in range(4):
        replaced = corners.copy()
        replaced[:, skipped] = queries
        new[:, skipped] = circumcentres(replaced) - centres
    lost = np.empty(corners.shape[:2])
    for corner, (first, second, third) in enumerate(((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))):
        lost[:, corner] = np.einsum("na,na->n", new[:, first], np.cross(new[:, second], new[:, third]))
    return np.asarray(lost * side[:, None])


def _restore_linear_precision(weights: csr_matrix, queries: Array, controls: Array) -> csr_matrix:
    """Return the nearest weights on the same neighbours that sum to one and reproduce the queries.

    Undoes the shift into general position (an error of about 1e-5 of the span): the smallest correction, weighted
    by the weights themselves so that none turns negative, from the 4x4 normal equations of each row.
    """
    weights = csr_matrix(weights)
    weights.data = np.maximum(weights.data, 0.0)
    row = np.repeat(np.arange(weights.shape[0]), np.diff(weights.indptr))
    for _ in range(2):
        relative = controls[weights.indices] - queries[row]
        span = np.sqrt(np.bincount(row, (relative**2).sum(1) * weights.data, minlength=weights.shape[0]))[row]
        laws = np.hstack([np.ones((len(row), 1)), relative / np.maximum(span, 1e-12)[:, None]])
        normal = np.zeros((weights.shape[0], 4, 4))
        missing = np.zeros((weights.shape[0], 4))
        for a in range(4):
            missing[:, a] = float(a == 0) - np.bincount(row, weights.data * laws[:, a], minlength=len(missing))
            for b in range(4):
                normal[:, a, b] = np.bincount(row, weights.data * laws[:, a] * laws[:, b], minlength=len(missing))
        factor = np.linalg.solve(normal + 1e-12 * np.eye(4), missing[..., None])[..., 0]
        weights.data = np.maximum(weights.data * (1.0 + np.einsum("na,na->n", laws, factor[row])), 0.0)
    weights.eliminate_zeros()
    return weights


def deform(weights: csr_matrix, displacements_m: Array) -> Array:
    """Return the (Q, 3) displacements of the queries when the control points move.

    Parameters
    ----------
    weights : (Q, C) sparse
    displacements_m : (C, 3) or fewer rows
        Rows of the control points; missing rows (the enclosing hull comes last) do not move.
    """
    moved = displacements_m.shape[0]
    return np.asarray(weights[:, :moved] @ displacements_m, dtype=np.float64)
