"""Ears as modes of the head's shape, and observed points of the ears and inside the side photo's outline.

Ears move, grow and tip as a whole, nearly alike on both sides.

The generic's face targets hardly touch the ears. In both face photos they lie some 90 mm behind the face, so that they
also tell how far the head nods in front and turns at the side, once the shape may put them where they are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.calibration.loader import calibrated
from cloner.generic.load import GenericHuman
from cloner.records.arrays import Array
from cloner.records.points import ViewPoints, expected_face_error

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.ears")

ALIKE: Final = _CALIBRATED.numbers("alike", "m, rad")
APART: Final = _CALIBRATED.numbers("apart", "m, rad")
FADE_M: Final = _CALIBRATED.number("fade_m", "m")
TOGETHER: Final = _CALIBRATED.number("together", "factor")
INSIDE_ERROR: Final = _CALIBRATED.number("inside_error", "factor")
#: Points inside the outline of a side photo that tell the head's turn; in front photos the net tells them.
INSIDE: Final = ("eye_outer", "ala", "mouth_corner")
IOD_M: Final = _CALIBRATED.number("iod_m", "m")


@dataclass(frozen=True, slots=True, eq=False)
class PointObservations:
    """Points observed in one photo: vertices (N,), pixels (N, 2), standard deviations (N,) in metres."""

    vertices: NDArray[np.int64]
    points_px: Array
    sigma_m: Array


def ear_modes(generic: GenericHuman) -> Array:
    """Return the ears' modes (10, H, 3), metres per standard deviation: five symmetric ones, five antisymmetric."""
    head = generic.vertices_m[generic.head_vertices].astype(np.float64)
    out = np.zeros((2, len(ALIKE), len(head), 3))
    for name, sign in (("ear_left", 1.0), ("ear_right", -1.0)):
        ear = generic.vertices_m[generic.region(name)].astype(np.float64)
        away, _ = cKDTree(ear).query(head)
        share = np.exp(-((away / FADE_M) ** 2))[:, None]
        arm = head - ear.mean(axis=0)
        tip = np.column_stack([np.zeros(len(head)), -arm[:, 2], arm[:, 1]])
        moves = [np.broadcast_to(axis * [sign, 1.0, 1.0], head.shape) for axis in np.eye(3)] + [arm, tip]
        for row, move in enumerate(moves):
            out[0, row] += ALIKE[row] * share * move
            out[1, row] += sign * APART[row] * share * move
    return out.reshape(-1, len(head), 3)


def ear_observations(generic: GenericHuman, points: ViewPoints | None, corrected_m: float) -> PointObservations:
    """Return the ear points of a photo; points that an operator placed get the sigma ``corrected_m``."""
    return _observations(generic, points, ("ear",), TOGETHER, corrected_m)


def inner_observations(generic: GenericHuman, points: ViewPoints, corrected_m: float) -> PointObservations:
    """Return the points of a side photo that lie inside its outline (``INSIDE``)."""
    return _observations(generic, points, INSIDE, INSIDE_ERROR, corrected_m)


def _observations(
    generic: GenericHuman, points: ViewPoints | None, wanted: tuple[str, ...], together: float, corrected_m: float
) -> PointObservations:
    names = () if points is None else points.names
    rows = [k for k, name in enumerate(names) if name.startswith(wanted) and name in generic.feature_names]
    if points is None or not rows:
        return PointObservations(np.zeros(0, dtype=np.int64), np.zeros((0, 2)), np.zeros(0))
    error = together * IOD_M * expected_face_error(points.confidence[rows])
    vertices = np.array([generic.feature(names[k]) for k in rows], dtype=np.int64)
    sigma = np.where(points.corrected[rows], corrected_m, np.maximum(error, corrected_m))
    return PointObservations(vertices, np.array(points.points_px[rows]), sigma)
