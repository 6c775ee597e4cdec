"""Displacements of DFFD control points that reduce what residuals a shape basis leaves in the photos."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from scipy.sparse import csr_matrix, identity, kron
from scipy.spatial import cKDTree

from cloner.fit.evidence import Residuals, cauchy_weights
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.geometry.cameras.motions import projection_derivatives
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: Errors beyond this many sigmas lose their weight (Cauchy).
OUTLIER: Final = 2.5
#: Iterations of reweighting: the residuals are linear.
ITERATIONS: Final = 5
#: Neighbours of a control in the smoothness prior.
NEIGHBOURS: Final = 8


@dataclass(frozen=True, slots=True, eq=False)
class PhotoEvidence:
    """Target pixels of model points in one photo.

    Attributes
    ----------
    camera : Camera
    points_m : (N, 3)
        The points before the deformation.
    weights : (N, K) sparse
        Their Sibson weights on the movable controls.
    target_px : (N, 2)
    sigma_px : (N,)
    normal_px : (N, 2) or None
        When given, only the error along this unit direction counts.
    """

    camera: Camera
    points_m: Array
    weights: csr_matrix
    target_px: Array
    sigma_px: Array
    normal_px: Array | None = None


def solve_displacements(
    controls_m: Array,
    evidence: Sequence[PhotoEvidence],
    *,
    sigma_m: float,
    neighbour_sigma_m: float,
    limit_m: float,
) -> Array:
    """Return the (K, 3) displacements of the controls, metres.

    Parameters
    ----------
    controls_m : (K, 3)
    evidence : sequence of PhotoEvidence
    sigma_m : float
        Standard deviation of a displacement.
    neighbour_sigma_m : float
        Standard deviation of neighbours' differences: one wrong point cannot pull a control away alone.
    limit_m : float
        Longest displacement.
    """
    smoothness, linear = (
        _neighbour_differences(controls_m) / neighbour_sigma_m,
        [_whitened_rows(item) for item in evidence],
    )

    def linearise(values: Values, iteration: int) -> Iterator[Residuals]:
        moved = values["controls"]
        yield Residuals(("controls",), smoothness @ moved, smoothness)
        for jacobian, error, group in linear:
            value = jacobian @ moved - error
            weight = cauchy_weights((value.reshape(-1, group) ** 2).sum(axis=1), OUTLIER)
            yield Residuals(("controls",), value, jacobian, np.repeat(weight, group))

    problem = Problem({"controls": ParameterBlock(np.zeros(controls_m.size), sigma=sigma_m)})
    out = problem.solve(linearise, iterations=ITERATIONS).values["controls"].reshape(-1, 3)
    length = np.linalg.norm(out, axis=1, keepdims=True)
    # Smooth limit: small displacements pass unchanged, none exceeds the limit.
    return out * np.where(length > 1e-12, limit_m * np.tanh(length / limit_m) / np.maximum(length, 1e-12), 1.0)


def _neighbour_differences(controls_m: Array) -> csr_matrix:
    """Return the (3K, 3K) operator from displacements to their differences from the mean of their neighbours."""
    count = len(controls_m)
    _, near = cKDTree(controls_m).query(controls_m, k=min(NEIGHBOURS + 1, count))
    others = near[:, 1:]
    rows = np.repeat(np.arange(count), others.shape[1])
    mean = csr_matrix((np.full(len(rows), 1.0 / others.shape[1]), (rows, others.ravel())), shape=(count, count))
    return kron(identity(count) - mean, identity(3), format="csr")


def _whitened_rows(item: PhotoEvidence) -> tuple[csr_matrix, Array, int]:
    """Return whitened rows (M, 3K), errors (M,), and rows per point."""
    seen, by_point, _ = projection_derivatives(item.camera, item.points_m)
    error = (item.target_px - seen) / item.sigma_px[:, None]
    change = by_point / item.sigma_px[:, None, None]
    if item.normal_px is not None:
        error = (error * item.normal_px).sum(1, keepdims=True)
        change = np.einsum("ni,nia->na", item.normal_px, change)[:, None]
    weights = csr_matrix(item.weights)
    group = change.shape[1]
    point = np.repeat(np.arange(weights.shape[0]), np.diff(weights.indptr))
    data = weights.data[:, None, None] * change[point]
    rows = np.broadcast_to((point * group)[:, None, None] + np.arange(group)[None, :, None], data.shape)
    columns = np.broadcast_to((weights.indices * 3)[:, None, None] + np.arange(3)[None, None], data.shape)
    shape = (weights.shape[0] * group, 3 * weights.shape[1])
    return csr_matrix((data.ravel(), (rows.ravel(), columns.ravel())), shape=shape), error.ravel(), group
