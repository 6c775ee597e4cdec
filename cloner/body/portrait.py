"""A build from a portrait: what face and shoulders say about a body that no photo shows.

The generic human's shape coefficients move faces and bodies together, as its own
data does: a broad jaw goes with broad shoulders. So the coefficients that explain
the face net's points and the shoulders' breadth also choose a likely body. It is a
guess; the coefficients' prior keeps it near the mean adult, and what faces have of their own, the modes of the head's
fit, is told apart from it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import load_face_net
from cloner.frames import ViewId, focal_px_from_35mm
from cloner.generic.load import GenericHuman
from cloner.head.modes import load_head_modes
from cloner.records.arrays import Array
from cloner.records.points import Proposal, Proposals

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.portrait")

# BlazePose's shoulders; Google's face mesh's outer eye corners
_SHOULDERS: Final = (11, 12)
_EYES: Final = (33, 263)


@dataclass(frozen=True, slots=True)
class Params:
    """Weights of the evidence.

    Its numbers: ``cloner/calibration/body.toml``, ``[portrait.*]``.

    Attributes
    ----------
    shapes : int
        Number of coefficients; more say nothing about the build.
    turns : int
        Gauss-Newton steps.
    """

    shapes: int = 20
    focal_35mm: float = _CALIBRATED.number("focal_35mm", "mm")
    face_m: float = _CALIBRATED.number("face_m", "m")
    drift: float = _CALIBRATED.number("drift", "factor")
    own: float = _CALIBRATED.number("own", "factor")
    shoulder_m: float = _CALIBRATED.number("shoulder_m", "m")
    most_sigmas: float = _CALIBRATED.number("most_sigmas", "spreads")
    turns: int = 4


def portrait_shape(generic: GenericHuman, proposals: Proposals) -> Array:
    """Return the shape coefficients (C,) that the front photo of the face suggests; zeros without one."""
    params = Params()
    proposal = proposals.views.get(ViewId.FACE_FRONT)
    coefficients = np.zeros(params.shapes)
    if proposal is None or proposal.face_presence == 0.0:
        return coefficients
    mean, basis, drift, sigma = _model(generic, params)
    seen = np.vstack([proposal.face_px, proposal.pose_px[list(_SHOULDERS)]]) * (1.0, -1.0)  # y up, as the model has it
    for _ in range(params.turns):
        coefficients = _step(coefficients, mean, basis, drift, seen, sigma, _focal_px(proposal, params))
        coefficients = np.clip(coefficients, -params.most_sigmas, params.most_sigmas)
    return coefficients


def _model(generic: GenericHuman, params: Params) -> tuple[Array, Array, Array, Array]:
    """Return mean (N, 3), basis (C, N, 3), others' share (M, N, 2) and spread (N,) of face and shoulders, metres.

    Others are the errors that the net's points make together, and what faces have of their own.
    """
    net = load_face_net()
    shoulders = [generic.joint("l_shoulder"), generic.joint("r_shoulder")]
    corners = generic.shape_basis[: params.shapes, net.places.corners].astype(np.float64)
    modes = load_head_modes()
    row = np.zeros(len(generic.vertices_m), np.intp)
    row[generic.head_vertices] = np.arange(len(generic.head_vertices))
    heads = np.concatenate([modes.mean_m[None], params.own * modes.basis_m])[:, row[net.places.corners]]
    own = np.einsum("nk,cnka->cna", net.places.weights, heads)
    face = net.places.at(generic.vertices_m.astype(np.float64)) + own[0]
    mean = np.vstack([face, generic.joints_m[shoulders]])
    moves = np.einsum("nk,cnka->cna", net.places.weights, corners)
    basis = np.concatenate([moves, generic.joint_basis[: params.shapes, shoulders]], axis=1)
    sigma = np.append(np.hypot(net.alone_m, params.face_m), [params.shoulder_m] * 2)
    drift = np.concatenate([net.drift_m * (params.drift, -params.drift), own[1:, :, :2]])
    drift = np.pad(drift, ((0, 0), (0, 2), (0, 0)))  # shoulders have neither
    return mean, basis, drift, sigma


def _step(
    coefficients: Array, mean: Array, basis: Array, drift: Array, seen: Array, sigma: Array, focal_px: float
) -> Array:
    """Return better coefficients: one linear solution for shape, the net's common errors, and the head's place."""
    points = mean + np.tensordot(coefficients, basis, axes=1)
    points = points - points[:-2].mean(axis=0)
    eyes_m = np.linalg.norm(points[_EYES[0]] - points[_EYES[1]])
    distance_m = focal_px * eyes_m / np.linalg.norm(seen[_EYES[0]] - seen[_EYES[1]])
    nearer = (distance_m / (distance_m - points[:, 2]))[:, None]
    drawn = points[:, :2] * nearer
    moves = basis[:, :, :2] * nearer + basis[:, :, 2:] * drawn / (distance_m - points[:, 2])[:, None]
    still = np.zeros(len(points))
    freedoms = [
        np.stack([still + 1.0, still], axis=1),
        np.stack([still, still + 1.0], axis=1),
        drawn,
        np.stack([-drawn[:, 1], drawn[:, 0]], axis=1),
        np.stack([points[:, 2], still], axis=1),
        np.stack([still, points[:, 2]], axis=1),
    ]
    certain = len(basis) + len(drift)
    design = np.concatenate([moves, drift, np.array(freedoms)]).reshape(certain + len(freedoms), -1).T
    wanted = _laid_on(seen, drawn) - drawn + np.tensordot(coefficients, moves, axes=1)
    weights = np.repeat(sigma, 2) ** -2.0
    prior = np.append(np.ones(certain), np.full(len(freedoms), 1e-6))
    normal = design.T @ (design * weights[:, None]) + np.diag(prior)
    return np.asarray(np.linalg.solve(normal, design.T @ (wanted.ravel() * weights))[: len(basis)])


def _laid_on(seen: Array, drawn: Array) -> Array:
    """Return the seen points moved, turned and scaled on to the drawn ones, fitted to the face alone."""
    source, target = (each @ (1.0, 1.0j) for each in (seen, drawn))
    middle, wanted = source[:-2].mean(), target[:-2].mean()
    from_middle = source - middle
    factor = np.vdot(from_middle[:-2], target[:-2] - wanted) / np.vdot(from_middle[:-2], from_middle[:-2])
    moved = factor * from_middle + wanted
    return np.stack([moved.real, moved.imag], axis=1)


def _focal_px(proposal: Proposal, params: Params) -> float:
    height, width = proposal.mask.shape
    return focal_px_from_35mm(params.focal_35mm, width, height)
