"""Joints under the clothes, observed by the label net in each body photo: evidence for poses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.generic.seen_points import NAMES, point_sigma
from cloner.records.arrays import Array
from cloner.records.bodies import Phenotype, PosedView
from cloner.records.points import ViewPoints
from cloner.records.proposals import Proposals

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.observed_joints")

#: Cauchy scale in sigmas: an observed joint that far away has lost half of its weight.
OUTLIER: Final = _CALIBRATED.number("outlier", "sigmas")


@dataclass(frozen=True, slots=True, eq=False)
class ObservedJoints:
    """Observed joints of one photo.

    Attributes
    ----------
    joints : (N,) int64
        Rows of the skeleton.
    places_px : (N, 2) float64
    sigma_px : (N,) float64
        Expected errors along one picture axis.
    """

    joints: NDArray[np.int64]
    places_px: Array
    sigma_px: Array


def observed_joints(
    phenotype: Phenotype, proposals: Proposals, points: Mapping[ViewId, ViewPoints]
) -> Mapping[ViewId, ObservedJoints]:
    """Return the joints observed by the label net in every photo, without those that an operator placed.

    Parameters
    ----------
    points : mapping
        The body's points, by photo.
    """
    generic = load_generic()
    found = {}
    for view, posed in phenotype.views.items():
        places, known = proposals.views[view].seen_px, points.get(view)
        placed = {name for name, fixed in zip(known.names, known.corrected, strict=True) if fixed} if known else set()
        rows = [row for row, name in enumerate(NAMES) if name in generic.joint_names and name not in placed]
        if len(places) and rows:
            shown = _visible_side(posed)
            sigma_m = phenotype.stature_m * np.array([point_sigma(NAMES[row], shown) for row in rows])
            middle = np.array([0.0, phenotype.stature_m / 2.0, 0.0])
            joints = np.array([generic.joint(NAMES[row]) for row in rows])
            found[view] = ObservedJoints(joints, places[rows], sigma_m / posed.camera.metres_per_pixel(middle))
    return found


def _visible_side(posed: PosedView) -> str:
    """Return the person's side that faces a body photo's camera."""
    if posed.view is ViewId.BODY_SIDE:
        return "left" if posed.camera.position_m[0] > 0.0 else "right"
    return "front" if posed.view is ViewId.BODY_FRONT else "back"
