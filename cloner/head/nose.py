"""Points of the nose in the front photo at full resolution, with their correlated errors.

The face net sees a face at 192 px and draws wings of noses 5 % of the eye distance beside them; cascades find them in
the photo itself. How the points of one feature err together was measured on portraits that taught nothing: believed one
by one they would count far too much. A chin found alike is no evidence: it is smooth from the front, and the profile
tells it better (as evidence: visitors .70 to .72 mm, the worst .81 to .89; heads alike).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.face.cascade import FeaturePose, FoundFeature, load_cascades, side_names
from cloner.detectors.face.face_front_features import find_half
from cloner.records.arrays import Array
from cloner.records.photos import Photo
from cloner.records.points import ViewPoints
from cloner.records.proposals import Proposal

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.nose")

FEATURE: Final = "front_nose"
HARDER: Final = _CALIBRATED.number("harder", "factor")
ALONE_IOD: Final = _CALIBRATED.number("alone_iod", "iod")
#: Mean length of a normal error in the plane, in its root mean square.
MEAN_OF_TWO: Final = 0.886


@dataclass(frozen=True, slots=True, eq=False)
class CorrelatedPoints:
    """Points with correlated errors: vertices (N,), pixels (N, 2), whitening matrix (2N, 2N)."""

    vertices: NDArray[np.int64]
    points_px: Array
    whiten: Array


def nose_observations(photo: Photo, proposal: Proposal, points: ViewPoints) -> tuple[CorrelatedPoints, ...]:
    """Return the points of both halves of the nose in a front photo, none unless all its named points are known.

    Parameters
    ----------
    photo : Photo
    proposal : Proposal
        Mask of the same photo.
    points : ViewPoints
        Named points of the same photo; corrected ones teach the others of their feature.
    """
    out = []
    for side in "LR":
        if {*side_names(FEATURE, side), "pupil_L", "pupil_R"} <= set(points.names):
            found, pose = find_half(photo, proposal, points.names, points.points_px, FEATURE, side)
            out.append(_half_nose(side, found, pose, points))
    return tuple(out)


def _half_nose(side: str, found: FoundFeature, pose: FeaturePose, points: ViewPoints) -> CorrelatedPoints:
    """Return the points of half a nose with their joint errors, conditioned on those that an operator placed."""
    cascade = load_cascades()[FEATURE]
    usual = MEAN_OF_TWO * np.sqrt(np.diag(cascade.joint).reshape(-1, 2).sum(axis=1)).mean()
    joint = (HARDER * max(float(found.error_iod.mean() / usual), 1.0)) ** 2 * cascade.joint
    to_upright, places = pose.upright() / pose.iod_px, found.points_px
    named = [points.names.index(name) for name in side_names(FEATURE, side)]
    fixed = [k for k, row in enumerate(named) if points.corrected[row]]
    if fixed:
        away = (points.points_px[[named[k] for k in fixed]] - places[fixed]) @ to_upright.T
        rows = np.array([[2 * k, 2 * k + 1] for k in fixed]).ravel()
        gain = np.linalg.solve(joint[np.ix_(rows, rows)] + 1e-9 * np.eye(len(rows)), joint[rows]).T
        places = places + (gain @ away.ravel()).reshape(-1, 2) @ np.linalg.inv(to_upright).T
        joint = joint - gain @ joint[rows]
    root = np.linalg.cholesky(joint + ALONE_IOD**2 * np.eye(len(joint)))
    white = np.linalg.solve(root, np.kron(np.eye(len(places)), to_upright))
    return CorrelatedPoints(cascade.vertices["LR".index(side)], places, white)
