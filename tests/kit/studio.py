"""Photographs of known bodies: cameras, silhouettes and shaded pictures, with OpenCV alone.

Known bias: OpenCV fills every touched pixel, so a body is about half a pixel
too large on every side. Write tolerances in pixels and turn them into mm.
"""

import math

import cv2
import numpy as np
from skimage.measure import find_contours

from cloner.frames import ViewId, focal_px_from_35mm
from cloner.records.labels import Label
from cloner.records.photos import Photo, PhotoSet
from cloner.records.proposals import Proposal
from cloner.records.silhouettes import Silhouette
from cloner.records.views import Camera

#: Directions of the cameras around the person, degrees; 0 front, +90 the person's left.
AZIMUTH_DEG = {
    "body_front": 0.0,
    "body_side": -90.0,
    "body_back": 180.0,
    "face_front": 0.0,
    "face_side": -90.0,
    "body_three_quarter": 45.0,
    "face_three_quarter": 45.0,
}
FOCAL_35MM = 62.0
_LIGHT = np.array([0.3, 0.5, 0.8]) / math.sqrt(0.98)


def camera(
    azimuth_deg=0.0,
    *,
    distance_m=3.5,
    height_m=1.1,
    aim_m=0.87,
    size_px=(1200, 1800),
    focal_35mm=FOCAL_35MM,
    across_m=0.0,
):
    """Return a camera that looks at the point (0, aim_m, 0) from a direction around the person."""
    width, height = size_px
    turn = math.radians(azimuth_deg)
    out = np.array([math.sin(turn), 0.0, math.cos(turn)])
    eye = distance_m * out + [0.0, height_m, 0.0]
    forward = np.array([0.0, aim_m, 0.0]) - eye
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, [0.0, 1.0, 0.0])
    right /= np.linalg.norm(right)
    rotation = np.stack([right, np.cross(forward, right), forward])
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, -rotation @ eye + [across_m, 0.0, 0.0]
    return Camera(width, height, focal_px_from_35mm(focal_35mm, width, height), matrix)


def orthographic(azimuth_deg=0.0, *, pixels_per_m=900.0, aim_m=0.87, size_px=(1200, 1800)):
    """Return the camera of infinite distance, in which the paper's formulas are exact."""
    far = camera(azimuth_deg, distance_m=5.0, height_m=aim_m, aim_m=aim_m, size_px=size_px)
    return Camera(far.width_px, far.height_px, far.focal_px, far.camera_from_model, pixels_per_m)


def silhouette(vertices_m, triangles, seen_by):
    """Return the (H, W) bool mask of a body through a camera."""
    pixels = np.round(seen_by.project(vertices_m) * 16).astype(np.int32)
    picture = np.zeros((seen_by.height_px, seen_by.width_px), np.uint8)
    for corners in pixels[triangles]:
        cv2.fillConvexPoly(picture, corners, 255, cv2.LINE_8, 4)
    return picture > 0


def picture(vertices_m, triangles, seen_by, *, colours=(200, 160, 140), background=(120, 130, 140)):
    """Return an (H, W, 3) uint8 shaded picture: far triangles first, one light.

    ``colours`` is one sRGB colour or (T, 3).
    """
    corners = vertices_m[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    towards = np.einsum("ta,ta->t", normals, seen_by.position_m - corners.mean(axis=1))
    lit = 0.45 + 0.55 * np.clip(normals @ _LIGHT, 0.0, 1.0)
    shades = np.clip(np.broadcast_to(colours, normals.shape) * lit[:, None], 0, 255)
    depth = seen_by.to_camera(corners.mean(axis=1))[:, 2]
    order = np.argsort(-depth)
    pixels = np.round(seen_by.project(vertices_m) * 16).astype(np.int32)
    drawn = np.empty((seen_by.height_px, seen_by.width_px, 3), np.uint8)
    drawn[:] = background
    for row in order[towards[order] > 0]:
        cv2.fillConvexPoly(drawn, pixels[triangles[row]], shades[row].tolist(), cv2.LINE_8, 4)
    return drawn


def silhouette_record(view, mask):
    """Return the record of a perfect outline."""
    padded = np.pad(mask.astype(np.float64), 1)
    contours = [line[:-1, ::-1] - 1.0 for line in find_contours(padded, 0.5) if len(line) > 8]
    contours.sort(key=len, reverse=True)
    return Silhouette(ViewId(view), tuple(contours), mask, ())


def photo_record(view, rgb, *, focal_35mm=FOCAL_35MM):
    """Return a photograph as the project reads one."""
    return Photo(ViewId(view), rgb, focal_35mm, f"studio-{view}", f"{view}.png")


def photo_set(pictures):
    """Return a PhotoSet of a mapping view -> (H, W, 3) uint8."""
    return PhotoSet({ViewId(view): photo_record(view, rgb) for view, rgb in pictures.items()})


def empty_proposal(view, mask):
    """Return what nets would say that find the person's mask and nothing else."""
    return Proposal(
        view=ViewId(view),
        pose_px=np.zeros((33, 2)),
        pose_visibility=np.zeros(33),
        face_px=np.zeros((468, 2)),
        face_depth=np.zeros(468),
        face_presence=0.0,
        mask=np.where(mask, 255, 0).astype(np.uint8),
        labels=np.where(mask, Label.UPPER_CLOTHES, 0).astype(np.uint8),
    )
