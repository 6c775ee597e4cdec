"""The face of a frontal photo, also one that hair covers."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.nets import pose_rows as net
from cloner.detectors.nets.results import FaceResult
from cloner.detectors.table import DETECTORS
from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.labels import FACE, shows
from cloner.records.photos import Photo

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.frontal")

LEAST_PRESENCE: Final = _CALIBRATED.number("least_presence", "score")
LEAST_FACE: Final = _CALIBRATED.number("least_face", "share")
BETWEEN_EARS: Final = _CALIBRATED.pair("between_ears", "share")

#: (468, 2) points, (468,) depths, presence and (2, 2) irises.
Face = tuple[NDArray[np.float64], NDArray[np.float64], float, NDArray[np.float64]]


def frontal_face(photo: Photo) -> Face:
    """Return points (468, 2), depths (468,) (all px), presence, and irises (2, 2) of a face; zeros without one."""
    if photo.view.is_front:
        face: FaceResult | None = DETECTORS.get("face")(photo.rgb)
        if face is not None and face.presence >= LEAST_PRESENCE:
            return _with_refined_points(photo, face, float(face.presence))
    return np.zeros((468, 2)), np.zeros(468), 0.0, np.zeros((2, 2))


def frontal_face_behind_hair(photo: Photo, pose_px: Array, labels: NDArray[np.uint8]) -> Face | None:
    """Return the face of a frontal portrait in which hair covers so much that the mesh net sees none.

    Backs of heads have no skin where the net lays its mesh, profiles have the nose outside the ears. The mesh is a
    guess from what is seen, so its presence is the least that still counts.

    Parameters
    ----------
    photo : Photo
    pose_px : (33, 2) float64
    labels : (H, W) uint8
    """
    left, right = pose_px[list(net.EARS), 0]
    if photo.view is not ViewId.FACE_FRONT or left <= right:
        return None
    if not BETWEEN_EARS[0] < (pose_px[net.NOSE, 0] - right) / (left - right) < BETWEEN_EARS[1]:
        return None
    face: FaceResult | None = DETECTORS.get("guessed_face")(photo.rgb)
    if face is None or skin_share(face.points_px, labels) < LEAST_FACE:
        return None
    return _with_refined_points(photo, face, LEAST_PRESENCE)


def skin_share(face_px: Array, labels: NDArray[np.uint8]) -> float:
    """Return the share of a face mesh's area that is labelled face."""
    inside = np.zeros(labels.shape, np.uint8)
    cv2.fillConvexPoly(inside, cv2.convexHull(np.rint(face_px).astype(np.int32)), 1)
    covered = labels[inside > 0]
    return float(shows(covered, *FACE).mean()) if covered.size else 0.0


def _with_refined_points(photo: Photo, face: FaceResult, presence: float) -> Face:
    points = DETECTORS.get("refined_face")(photo.rgb, face.points_px, face.irises_px)
    return points, np.asarray(face.depth_px, dtype=np.float64), presence, face.irises_px
