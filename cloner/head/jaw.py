"""Opening of the jaw in each face photo: one rotation of the jaw joint a photo, an unknown of the fit beside the shape.

People are photographed with parted lips, and the net draws them so. A fit without this unknown makes longer chins of
open mouths, and paints teeth on lips.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from scipy.spatial.transform import Rotation

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.jaw")

JOINT: Final = "temporomandibular"
#: The photos that have an opening each, in the order of the fit's unknowns.
PHOTOS: Final = (ViewId.FACE_FRONT, ViewId.FACE_SIDE)
FRONT, SIDE = range(len(PHOTOS))
USUAL_RAD: Final = float(np.radians(_CALIBRATED.number("usual_rad", "deg")))
RARITY: Final = USUAL_RAD / float(np.radians(_CALIBRATED.number("mean_rad", "deg")))


def jaw_opening_mode(generic: GenericHuman, vertices_m: Array, joints_m: Array) -> Array:
    """Return the displacements of vertices (V, 3) for a usual opening, metres: the fit is linear in it."""
    return with_open_jaw(generic, vertices_m, joints_m, USUAL_RAD) - vertices_m


def with_open_jaw(generic: GenericHuman, vertices_m: Array, joints_m: Array, open_rad: float) -> Array:
    """Return the vertices (V, 3) of a person at rest after a rotation of the jaw joint.

    Parameters
    ----------
    vertices_m, joints_m : (V, 3), (J, 3) metres, rest frame
    open_rad : float
    """
    pivot = joints_m[generic.joint(JOINT)]
    turn = Rotation.from_rotvec(jaw_rotations(generic, open_rad)[generic.joint(JOINT)])
    moved = turn.apply(vertices_m - pivot) + pivot - vertices_m
    return np.asarray(vertices_m + generic.carried_by(JOINT)[:, None] * moved)


def jaw_opening_rad(generic: GenericHuman, rotations: Array) -> float:
    """Return the jaw's opening in a pose (J, 3), radians."""
    return float(rotations[generic.joint(JOINT), 0])


def with_closed_jaw(generic: GenericHuman, rotations: Array) -> Array:
    """Return a pose (J, 3) with the jaw closed, as clones rest."""
    out = rotations.copy()
    out[generic.joint(JOINT)] = 0.0
    return out


def jaw_rotations(generic: GenericHuman, open_rad: float) -> Array:
    """Return the rotation vectors (J, 3) of a pose that only opens the jaw, radians in model axes."""
    out = np.zeros((len(generic.joint_names), 3))
    out[generic.joint(JOINT), 0] = open_rad
    return out
