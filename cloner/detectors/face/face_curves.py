"""Snakes that pull the face net's points on to lid margins and the line between the lips."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import FaceNet, load_face_net
from cloner.geometry.deformation.completion import move_neighbours
from cloner.records.arrays import Array
from cloner.vision.contours.snake import Curve, Sign, SnakeParams, run_snake, snake_picture

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.face_curves")


UNIT_PX: Final = _CALIBRATED.number("unit_px", "px")
LEAST_IOD_PX: Final = _CALIBRATED.number("least_iod_px", "px")
#: What an edge is like outwards (lids' normals point down in the picture on the left side, up on the right, as both
#: run from the inner corner outwards) and how far it is looked for, shares of the eye distance. Lips, brows and jaw are
#: not pulled: it made them worse (docs/decisions/).
SIGNS: Final[dict[str, Sign]] = {
    "lid_upper_L": "line",
    "lid_upper_R": "line",
    "lid_lower_L": "falling",
    "lid_lower_R": "rising",
    "mouth": "line",
}
REACH_IOD: Final = _CALIBRATED.number("reach_iod", "iod")
SPRING: Final = _CALIBRATED.number("spring", "factor")
_END: Final = _CALIBRATED.number("end", "factor")
_FOLLOW_IOD: Final = _CALIBRATED.number("follow_iod", "iod")


@dataclass(frozen=True, slots=True, eq=False)
class PulledCurve:
    """A curve before and after: (N, 2) px, and the confidence of each edge, (N,) 0..1."""

    start_px: Array
    points_px: Array
    trust: Array


def pull_curves(rgb: NDArray[np.uint8], face_px: Array, irises_px: Array, net: FaceNet) -> dict[str, PulledCurve]:
    """Return the curves of a frontal face, pulled on to image edges.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    face_px : (468, 2) float64
    irises_px : (2, 2) float64
    net : FaceNet
    """
    iod = float(np.linalg.norm(irises_px[0] - irises_px[1]))
    out = {}
    for name, sign in SIGNS.items():
        start = net.curves[name] @ face_px
        picture, small_from_photo = snake_picture(rgb, start, unit_px=iod, unit=UNIT_PX)
        linear, shift = small_from_photo[:, :2], small_from_photo[:, 2]
        anchors = np.zeros(len(start))
        anchors[[0, -1]] = _END
        reach = REACH_IOD * iod * float(linear[0, 0])
        small, trust = run_snake(
            picture, Curve(start @ linear.T + shift, False, anchors, sign), SnakeParams(reach, SPRING)
        )
        out[name] = PulledCurve(start, (small - shift) @ np.linalg.inv(linear).T, trust)
    return out


def refine_face(rgb: NDArray[np.uint8], face_px: Array, irises_px: Array) -> Array:
    """Return the net's points (468, 2), those near lids and mouth moved along with the pulled curves.

    Small faces and faces without irises come back as they are.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    face_px : (468, 2) float64
    irises_px : (2, 2) float64
        Centres of the left and the right iris.
    """
    iod = float(np.linalg.norm(irises_px[0] - irises_px[1]))
    if iod < LEAST_IOD_PX:
        return face_px
    pulled = pull_curves(rgb, face_px, irises_px, load_face_net()).values()
    starts = np.vstack([curve.start_px for curve in pulled])
    goals = np.vstack([curve.points_px for curve in pulled])
    _, first = np.unique(np.round(starts, 6), axis=0, return_index=True)  # lids share their corners
    starts, goals = starts[first], goals[first]
    moved = np.arange(len(starts) + len(face_px)) < len(starts)
    return move_neighbours(np.vstack([starts, face_px]), moved, goals, reach_px=_FOLLOW_IOD * iod)[len(starts) :]
