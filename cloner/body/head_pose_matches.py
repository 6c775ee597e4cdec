"""Face skin of the face photos matched in the body photos: evidence for the head's pose there.

A face photo and the body photo of the same direction show the same skin from nearly the same side. Places on ear, eye,
nose and mouth are found again in the body photo to about a millimetre, eight times as well as outline and pose net
place them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.head.jaw import jaw_opening_rad, with_open_jaw
from cloner.head.size import head_camera
from cloner.head.skin_matches import PLACES, SkinMatches, match_vertices
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, PosedView
from cloner.records.photos import PhotoSet
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.head_pose_matches")


#: Body photos and the face photos of the same direction.
TWINS: Final = ((ViewId.BODY_FRONT, ViewId.FACE_FRONT), (ViewId.BODY_SIDE, ViewId.FACE_SIDE))
#: Places on the ear that are looked up beside those of the face.
EAR: Final = tuple((f"{name}_L", f"{name}_R") for name in ("ear_top", "ear_lobe", "ear_outer", "ear_back"))
SAME_WAY: Final = _CALIBRATED.number("same_way", "cosine")
ASIDE: Final = _CALIBRATED.number("aside", "sine")


def match_face_skin(mesh: BodyMesh, photos: PhotoSet, poses: Mapping[ViewId, PosedView]) -> dict[ViewId, SkinMatches]:
    """Return the matches in body photos of skin that the face photos show.

    Parameters
    ----------
    mesh : BodyMesh
        The person in rest pose.
    photos : PhotoSet
    poses : mapping of ViewId to PosedView
        As the head lies in the photos now.
    """
    generic = load_generic()
    middle = mesh.vertices_m[generic.head_vertices].mean(axis=0)
    found = {}
    for view, twin in TWINS:
        if view not in poses or twin not in poses or not {view, twin} <= set(photos.photos):
            continue
        cameras = head_camera(mesh.joints_m, poses[twin]), head_camera(mesh.joints_m, poses[view])
        directions = [_view_direction(camera, middle) for camera in cameras]
        if directions[0] @ directions[1] > SAME_WAY:
            pictures = photos.photos[twin].rgb, photos.photos[view].rgb
            places = np.array([generic.feature(name) for name in visible_points(directions[0])])
            wholes = _with_photo_jaw(mesh, poses[twin]), _with_photo_jaw(mesh, poses[view])
            found[view] = match_vertices(places, wholes, cameras, pictures)
    return found


def visible_points(direction: Array) -> list[str]:
    """Return the names of the points visible to a camera in a direction (3,) from the head."""
    sides = [0] if direction[0] > ASIDE else [1] if direction[0] < -ASIDE else [0, 1]
    return [pair[side] for pair in (*PLACES, *EAR) for side in sides]


def _with_photo_jaw(mesh: BodyMesh, posed: PosedView) -> Array:
    """Return the person at rest (V, 3), with the jaw as far open as a photo shows it."""
    generic = load_generic()
    return with_open_jaw(generic, mesh.vertices_m, mesh.joints_m, jaw_opening_rad(generic, posed.rotations))


def _view_direction(camera: Camera, middle: Array) -> Array:
    away = camera.position_m - middle
    return np.asarray(away / np.linalg.norm(away))
