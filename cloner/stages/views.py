"""Stage: first cameras, with focal length from the photo and distance from the stature (method §1).

The photos' body heights are normalised here: one stature, three distances. The
fit of the phenotype refines heading, tilt and distance afterwards.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId, focal_px_from_35mm
from cloner.records.arrays import Array
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.points import BodyPoints, ViewPoints
from cloner.records.results import StageResult
from cloner.records.views import Camera, View, ViewSet

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.views")


#: camera_from_model rotation of a level camera in front of the person.
FRONT = np.diag([1.0, -1.0, -1.0])


@dataclass(frozen=True, slots=True)
class Params:
    """Assumptions about cameras that photos do not tell.

    Its numbers: ``cloner/calibration/stages.toml``, ``[views.*]``.
    """

    body_focal_35mm: float = _CALIBRATED.number("body_focal_35mm", "mm")
    face_focal_35mm: float = _CALIBRATED.number("face_focal_35mm", "mm")
    camera_height_m: float = _CALIBRATED.number("camera_height_m", "m")
    hair_m: float = _CALIBRATED.number("hair_m", "m")
    sole_m: float = _CALIBRATED.number("sole_m", "m")


def level_rotation(azimuth: float) -> Array:
    """Return the (3, 3) camera_from_model rotation of a level camera.

    Parameters
    ----------
    azimuth : float
        Direction of the camera around the person, radians: 0 front, +90° the person's left.
    """
    cosine, sine = math.cos(azimuth), math.sin(azimuth)
    turn = np.array([[cosine, 0.0, -sine], [0.0, 1.0, 0.0], [sine, 0.0, cosine]])
    return np.asarray(FRONT @ turn)


def pitch_rotation(rotation: Array, pitch: float) -> Array:
    """Return ``rotation`` with the camera pitched down by ``pitch`` radians."""
    cosine, sine = math.cos(pitch), math.sin(pitch)
    return np.array([[1.0, 0.0, 0.0], [0.0, cosine, sine], [0.0, -sine, cosine]]).T @ rotation


def focal_px(photo: Photo, default_35mm: float) -> tuple[float, bool]:
    """Return the focal length in pixels, and whether the photo itself told it."""
    own = photo.focal_35mm
    if own is not None and own > 0:
        return focal_px_from_35mm(own, photo.width_px, photo.height_px), True
    return focal_px_from_35mm(default_35mm, photo.width_px, photo.height_px), False


def face_focal_px(photos: PhotoSet, view: ViewId) -> float:
    """Return the focal length of a photo of the face in pixels, that of usual portraits unless the photo tells it; 0
    without the photo.
    """
    photo = photos.photos.get(view)
    return 0.0 if photo is None else focal_px(photo, Params().face_focal_35mm)[0]


def level_camera(
    photo: Photo,
    focal: float,
    azimuth: float,
    top_px: Array,
    bottom_px: Array,
    span_m: tuple[float, float],
    height_m: float,
) -> Camera:
    """Return the camera at ``height_m`` that sees the span between two pixels.

    Parameters
    ----------
    top_px, bottom_px : (2,) pixels of the highest and lowest point of the person
    span_m : (bottom, top) heights of those points in the model frame, metres
    """
    middle_px = (top_px + bottom_px) / 2
    middle_m = np.array([0.0, sum(span_m) / 2, 0.0])
    depth = focal * (span_m[1] - span_m[0]) / max(float(bottom_px[1] - top_px[1]), 1.0)
    centre = np.array([(photo.width_px - 1) / 2, (photo.height_px - 1) / 2])
    pitch = 0.0
    for _ in range(4):
        rotation = pitch_rotation(level_rotation(azimuth), pitch)
        place = np.array([*((middle_px - centre) * depth / focal), depth])
        offset = place - rotation @ middle_m
        pitch += math.atan2(height_m - float((-rotation.T @ offset)[1]), depth)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, offset
    return Camera(photo.width_px, photo.height_px, focal, matrix)


def side_shown(points: ViewPoints) -> str:
    """Return which side of the person a side photo shows: that of the detected ear."""
    return "left" if "ear_outer_L" in points.names else "right"


def run(
    *,
    photos: PhotoSet,
    body_points: BodyPoints,
    person: Person,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the first cameras of the body photos, all scaled by the one stature."""
    params = Params()
    azimuths = {"front": 0.0, "back": math.pi, "left": math.pi / 2, "right": -math.pi / 2}
    views: dict[ViewId, View] = {}
    warnings: list[str] = []
    for view, points in body_points.views.items():
        shown = {ViewId.BODY_FRONT: "front", ViewId.BODY_BACK: "back"}.get(view) or side_shown(points)
        focal, known = focal_px(photos.photos[view], params.body_focal_35mm)
        top = points.get("head_top")
        soles = [s for s in (points.get("sole_left"), points.get("sole_right")) if s is not None]
        if top is None or not soles:
            raise ValueError(f"{view}: no head top or sole among the points")
        bottom = np.array([float(np.mean([s[0] for s in soles])), max(float(s[1]) for s in soles)])
        span = (-params.sole_m, person.stature_m + params.hair_m)
        camera = level_camera(photos.photos[view], focal, azimuths[shown], top, bottom, span, params.camera_height_m)
        views[view] = View(view, camera, shown, known)
        if not known:
            assumed = f"{params.body_focal_35mm:.0f} mm (35 mm equivalent)"
            warnings.append(f"{view}: no focal length in the photo; {assumed} assumed.")
    return StageResult({"views": ViewSet(views)}, warnings=tuple(warnings))
