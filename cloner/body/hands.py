"""Hands scaled to the length and width that photos show; slices do not move hands."""

from __future__ import annotations

import functools
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.generic.load import load_generic
from cloner.geometry.articulation.joint_jacobians import is_below
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.hands")


USUAL = _CALIBRATED.pair("usual", "factor")
SPREAD = _CALIBRATED.pair("spread", "factor")


@functools.cache
def _hand(side: str) -> tuple[NDArray[np.int64], Array, NDArray[np.int64]]:
    """Return a hand's vertices, their weights, and the joints in it."""
    generic = load_generic()
    weight = generic.share({"l": "left_hand", "r": "right_hand"}[side])
    vertices = np.flatnonzero(weight > 0.001)
    return vertices, weight[vertices], np.flatnonzero(is_below(generic.joint_parents, generic.joint(f"{side}_wrist")))


def scale_hands(mesh: BodyMesh, size: Array) -> BodyMesh:
    """Return the body with both hands, and the joints in them, scaled about their wrists.

    Parameters
    ----------
    size : (2,) factors along the hand, and across it in width and thickness alike
    """
    generic = load_generic()
    vertices, joints = mesh.vertices_m.copy(), mesh.joints_m.copy()
    for side in "lr":
        rows, weight, inside = _hand(side)
        wrist = mesh.joints_m[generic.joint(f"{side}_wrist")]
        along = mesh.joints_m[generic.joint(f"{side}_middle1")] - wrist
        along = along / max(float(np.linalg.norm(along)), 1e-9)
        for points, chosen, share in ((vertices, rows, weight), (joints, inside, np.ones(len(inside)))):
            local = points[chosen] - wrist
            length = np.outer(local @ along, along)
            points[chosen] += share[:, None] * ((size[0] - 1.0) * length + (size[1] - 1.0) * (local - length))
    return BodyMesh(vertices, joints)
