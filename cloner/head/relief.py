"""DFFD of the head's control points, which takes up the residuals that the shape basis leaves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from cloner.fit.controls import PhotoEvidence, solve_displacements
from cloner.generic.head_controls import HeadControls
from cloner.geometry.deformation.dffd import deform
from cloner.geometry.meshes.surface import SurfacePoints
from cloner.geometry.outlines.contour_match import match_contour
from cloner.head.evidence import FrontEvidence, Params, SideEvidence
from cloner.head.fit import (
    GATES_M,
    FittedHead,
    net_sigmas_m,
    predicted_net_errors_m,
    profile_candidates,
    silhouette_vertices,
)
from cloner.head.jaw import FRONT, SIDE
from cloner.head.model import HeadModel
from cloner.records.arrays import Array
from cloner.records.views import Camera


def _control_weights(
    weights: csr_matrix, model: HeadModel, surface: SurfacePoints, movable: NDArray[np.bool_]
) -> csr_matrix:
    """Return the weights (N, K) of surface points on the movable controls."""
    rows = model.row[surface.corners]
    point = np.repeat(np.arange(len(rows)), 3)
    place = csr_matrix((surface.weights.ravel(), (point, rows.ravel())), shape=(len(rows), weights.shape[0]))
    return csr_matrix((place @ weights)[:, np.flatnonzero(movable)])


def add_relief(
    model: HeadModel,
    fitted: FittedHead,
    front: FrontEvidence | None,
    side: SideEvidence | None,
    coefficients: Array,
    controls: HeadControls,
    params: Params,
) -> tuple[FittedHead, Array]:
    """Return the head after the DFFD step, and the displacements of all controls (K, 3).

    What the fit (its ``coefficients``) took for errors of the net is no shape: it is not followed.
    """
    left: list[PhotoEvidence] = []
    if front is not None and fitted.front is not None:
        whole = model.whole_in_photo(FRONT, coefficients)
        net_error_m = predicted_net_errors_m(model, coefficients, fitted.front, params)
        left += _front_evidence(model, whole, fitted.front, front, net_error_m, controls, params)
    if side is not None and fitted.side is not None:
        whole = model.whole_in_photo(SIDE, coefficients)
        left += _side_evidence(model, whole, fitted.side, side, controls, params)
    moved = np.zeros((len(controls.names), 3))
    if left:
        moved[controls.movable] = solve_displacements(
            controls.controls_m[controls.movable], left,
            sigma_m=params.relief_m, neighbour_sigma_m=params.bend_m, limit_m=params.limit_m,
        )  # fmt: skip
    return replace(fitted, head_m=fitted.head_m + deform(controls.weights, moved)), moved


def _front_evidence(model: HeadModel, whole: Array, camera: Camera, front: FrontEvidence, net_error_m: Array,
                     controls: HeadControls, params: Params) -> list[PhotoEvidence]:  # fmt: skip
    metres = camera.metres_per_pixel(whole[model.generic.feature("nasion")])
    weights = _control_weights(controls.weights, model, model.net.places, controls.movable)
    sigma = params.loose_net * net_sigmas_m(model, front, params) / metres
    target = front.net_px - net_error_m / metres
    out = [PhotoEvidence(camera, model.net.places.at(whole), weights, target, sigma)]
    if len(front.vertices):
        rows = csr_matrix(controls.weights[model.row[front.vertices]][:, np.flatnonzero(controls.movable)])
        sigma = np.full(len(front.vertices), 0.3 * params.corrected_m / metres)
        out.append(PhotoEvidence(camera, whole[front.vertices], rows, front.points_px, sigma))
    return out


def _side_evidence(model: HeadModel, whole: Array, camera: Camera, side: SideEvidence, controls: HeadControls,
                    params: Params) -> list[PhotoEvidence]:  # fmt: skip
    metres = camera.metres_per_pixel(whole[model.generic.feature("nasion")])
    movable = np.flatnonzero(controls.movable)
    vertices = silhouette_vertices(whole, profile_candidates(model), camera, side.facing)
    gate = GATES_M[1] / metres
    kept, target, normal = match_contour(
        camera.project(whole[vertices]), side.contour_px, side.normals_px, gate_px=gate
    )
    rows = csr_matrix(controls.weights[model.row[vertices[kept]]][:, movable])
    sigma = np.full(len(kept), 0.5 * params.contour_m / metres)
    out = [PhotoEvidence(camera, whole[vertices[kept]], rows, target, sigma, normal)]
    if side.matches is not None and len(side.matches.vertices):
        rows = csr_matrix(controls.weights[model.row[side.matches.vertices]][:, movable])
        sigma = np.full(rows.shape[0], params.loose_net * params.flank_m / metres)
        out.append(PhotoEvidence(camera, whole[side.matches.vertices], rows, side.matches.points_px, sigma))
    fixed = side.sigma_m <= params.corrected_m
    if fixed.any():
        rows = csr_matrix(controls.weights[model.row[side.vertices[fixed]]][:, movable])
        sigma = np.full(int(fixed.sum()), 0.3 * params.corrected_m / metres)
        out.append(PhotoEvidence(camera, whole[side.vertices[fixed]], rows, side.points_px[fixed], sigma))
    return out
