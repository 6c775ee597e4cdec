"""Body shape from a portrait: what face and shoulders suggest where there is no body photo.

The generic human's shape coefficients move faces and bodies together, as its own
data does: a broad jaw goes with broad shoulders. So the coefficients that explain
the face net's points and the shoulders' breadth also choose a likely body. It is a
guess; the coefficients' prior keeps it near the mean adult, and what faces have of their own, the modes of the head's
fit, is told apart from it. Who tells the sex in ``person.toml`` gets a body of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import load_face_net
from cloner.fit.shapes import Evidence, ShapeFit, fit_shape
from cloner.frames import ViewId, focal_px_from_35mm
from cloner.generic.load import GenericHuman
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.head.modes import load_head_modes
from cloner.records.arrays import Array
from cloner.records.proposals import Proposals

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.portrait")

# the phenotype's number for women and men
_SEX: Final = {"f": 0.0, "m": 1.0}
# BlazePose's shoulders
_SHOULDERS: Final = (11, 12)


@dataclass(frozen=True, slots=True)
class Params:
    """Weights of the evidence.

    Its numbers: ``cloner/calibration/body.toml``, ``[portrait.*]``.

    Attributes
    ----------
    shapes : int
        Number of coefficients; more say nothing about the build.
    iterations : int
        Gauss-Newton steps.
    """

    shapes: int = 20
    focal_35mm: float = _CALIBRATED.number("focal_35mm", "mm")
    face_m: float = _CALIBRATED.number("face_m", "m")
    drift: float = _CALIBRATED.number("drift", "factor")
    own: float = _CALIBRATED.number("own", "factor")
    shoulder_m: float = _CALIBRATED.number("shoulder_m", "m")
    max_sigmas: float = _CALIBRATED.number("max_sigmas", "sigmas")
    iterations: int = 4


def portrait_shape(generic: GenericHuman, proposals: Proposals) -> Array:
    """Return the shape coefficients (C,) that the front photo of the face suggests; zeros without one."""
    params = Params()
    proposal = proposals.views.get(ViewId.FACE_FRONT)
    coefficients = np.zeros(params.shapes)
    if proposal is None or proposal.face_presence == 0.0:
        return coefficients
    mean, basis, drift, sigma = _model(generic, params)
    seen = np.vstack([proposal.face_px, proposal.pose_px[list(_SHOULDERS)]])
    height, width = proposal.mask.shape
    focal = focal_px_from_35mm(params.focal_35mm, width, height)
    camera = facing_camera(mean[:-2], seen[:-2], azimuth=0.0, focal_px=focal, width_px=width, height_px=height)
    metres = camera.metres_per_pixel(mean[:-2].mean(axis=0))
    evidence = Evidence(0, mean, basis, seen, sigma / metres, outlier=np.inf, common_error_px=drift / metres)
    start = ShapeFit(np.zeros(len(basis) + len(drift)), (camera,), np.zeros((1, 3)))
    found = fit_shape(start, lambda fit, turn: [evidence], iterations=params.iterations).coefficients[: len(basis)]
    return np.clip(found, -params.max_sigmas, params.max_sigmas)


def nearest_of_sex(generic: GenericHuman, coefficients: Array, sex: str) -> Array:
    """Return the nearest coefficients (C,) of a phenotype of the given sex, "f" or "m"; the same ones for ""."""
    if not sex:
        return coefficients
    row = generic.phenotype_names.index("sex")
    share = generic.phenotype_from_shape[row, : len(coefficients)].astype(np.float64)
    now = float(generic.phenotype_mean[row] + share @ coefficients)
    return np.asarray(coefficients + share * (_SEX[sex] - now) / (share @ share))


def _model(generic: GenericHuman, params: Params) -> tuple[Array, Array, Array, Array]:
    """Return mean (N, 3), basis (C, N, 3), common errors (M, N, 2) and sigmas (N,) of face and shoulders, metres.

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
    drift = np.concatenate([params.drift * net.drift_m, own[1:, :, :2] * (1.0, -1.0)])  # down in the picture
    drift = np.pad(drift, ((0, 0), (0, 2), (0, 0)))  # shoulders have neither
    return mean, basis, drift, sigma
