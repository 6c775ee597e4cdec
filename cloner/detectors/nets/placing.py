"""Crops for nets, and matching of detections. No net here."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from importlib.resources import files
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.nets.anchors import overlaps
from cloner.detectors.nets.results import Box
from cloner.vision.photographs.crops import Crop

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.placing")

Floats = NDArray[np.float64]
Photo = NDArray[np.uint8]

#: Size, turn (radians), and shift right and down (share of the side) of the crops that a net's mean is taken over.
_NEARBY: Final = (
    (1.00, 0.00, 0.00, 0.00), (0.92, 0.07, 0.02, -0.02), (1.08, -0.07, 0.02, 0.02), (0.92, -0.07, -0.02, 0.02),
    (1.08, 0.07, -0.02, -0.02), (1.00, 0.07, 0.03, 0.01), (1.00, -0.07, -0.03, -0.01), (0.88, 0.00, -0.01, 0.03),
    (1.13, 0.00, 0.01, -0.03),
)  # fmt: skip

SAME_CROP = _CALIBRATED.number("same_crop", "share")
SAME_CROP_SIZE = _CALIBRATED.number("same_crop_size", "factor")
SAME_BOX = _CALIBRATED.number("same_box", "share")


def circle_crop(middle: Floats, rim: Floats, scale: float) -> Crop:
    """Return the square around a circle, rotated so that the rim point is up."""
    across, down = (rim - middle).tolist()
    side = 2.0 * math.hypot(across, down) * scale
    return Crop(float(middle[0]), float(middle[1]), side, side, math.atan2(across, -down))


def body_crop(body: Box) -> Crop:
    """Return the pose net's input square, from a detected body or from the net's own points."""
    return circle_crop(body.keypoints_px[0], body.keypoints_px[1], 1.25)


def same_crop(first: Crop, second: Crop) -> bool:
    """Return whether two body crops show one person: hips closer than a hand's width, similar height.

    Measured on 15 photos: what one person's crops differ by is 1 to 4 % of a side in place and up to 13 % in size.
    """
    apart = float(np.hypot(first.x_px - second.x_px, first.y_px - second.y_px))
    small, large = sorted((first.width_px, second.width_px))
    return apart < SAME_CROP * small and large < SAME_CROP_SIZE * small


def overlap_enough(first: Box, second: Box, overlap: float) -> bool:
    """Return whether the intersection over union of two boxes exceeds `overlap`."""
    rows = [
        np.array([[b.left_px + b.right_px, b.top_px + b.bottom_px], [2 * b.width_px, 2 * b.height_px]]) / 2.0
        for b in (first, second)
    ]
    return bool(overlaps(rows[0], rows[1][None])[0] > overlap)


def distinct(boxes: list[Box]) -> list[Box]:
    """Return the boxes without duplicates, the best first."""
    kept: list[Box] = []
    for box in sorted(boxes, key=lambda b: -b.score):
        if not any(overlap_enough(box, other, SAME_BOX) for other in kept):
            kept.append(box)
    return kept


def near_head(person: Box, point: Floats) -> bool:
    """Return whether a point lies no farther from a body's nose than its shoulders do."""
    shoulders, nose = person.keypoints_px[2:4]
    return bool(np.hypot(*(point - nose)) < np.hypot(*(shoulders - nose)))


def same_body(first: Box, second: Box) -> bool:
    """Return whether two confirmed bodies are one: by either's head or, in side portraits, by their overlap."""
    heads = near_head(first, second.keypoints_px[3]) or near_head(second, first.keypoints_px[3])
    return heads or overlap_enough(first, second, 0.7)


def is_within(inner: Box, outer: Box) -> bool:
    """Return whether a smaller box lies within another one, but for a tenth of it."""
    across = min(inner.right_px, outer.right_px) - max(inner.left_px, outer.left_px)
    down = min(inner.bottom_px, outer.bottom_px) - max(inner.top_px, outer.top_px)
    size = inner.width_px * inner.height_px
    return size < outer.width_px * outer.height_px and min(across, down) > 0.0 and across * down > 0.9 * size


def is_upright(body: Box) -> bool:
    """Return whether a detected body's head is above its hips: patterns on trousers can look like a
    body upside down.
    """
    hips, reach = body.keypoints_px[:2]
    return bool(reach[1] < hips[1])


def box_centre(box: Box) -> Floats:
    """Return the centre of a box, photo px."""
    return np.array([box.left_px + box.right_px, box.top_px + box.bottom_px]) / 2.0


def has_face(person: Box, faces: Sequence[Box]) -> bool:
    """Return whether one of the faces is at a body's head."""
    return any(near_head(person, box_centre(face)) for face in faces)


def owns_face(person: Box, face: Box) -> bool:
    """Return whether a face belongs to a body, or lies on it (a printed shirt)."""
    x, y = box_centre(face)
    inside = person.left_px < x < person.right_px and person.top_px < y < person.bottom_px
    return has_face(person, [face]) or inside


@lru_cache(maxsize=1)
def mirror_order() -> NDArray[np.intp]:
    """Return for each of the 468 points its counterpart on the other side of the face."""
    with (files("cloner_models") / "nets" / "canonical_face.npz").open("rb") as file:
        vertices = np.load(file)["vertices_cm"].astype(np.float64)
    gap = np.linalg.norm(vertices[:, None] * np.array([-1.0, 1.0, 1.0]) - vertices[None], axis=-1)
    order = np.asarray(gap.argmin(axis=1), np.intp)
    order.flags.writeable = False
    return order


def face_crop(box: Box) -> Crop:
    """Return the mesh net's input square, from a detected face."""
    right_eye, left_eye = box.keypoints_px[:2]
    across, down = (left_eye - right_eye).tolist()
    side = 1.5 * max(box.width_px, box.height_px)
    middle = ((box.left_px + box.right_px) / 2, (box.top_px + box.bottom_px) / 2)
    return Crop(*middle, side, side, math.atan2(down, across))


def enlarged_crop(box: Box) -> Crop:
    """Return an upright square three times as large as a detected face."""
    side = 3.0 * max(box.width_px, box.height_px)
    return Crop((box.left_px + box.right_px) / 2, (box.top_px + box.bottom_px) / 2, side, side)


def mesh_crop(points: Floats) -> Crop:
    """Return the mesh net's input square, from a first mesh in photo px."""
    across, down = (points[263, :2] - points[33, :2]).tolist()
    angle = math.atan2(down, across)
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    upright = points[:, :2] @ turn.T
    low, high = upright.min(axis=0), upright.max(axis=0)
    middle = turn.T @ ((low + high) / 2)
    side = 1.5 * float((high - low).max())
    return Crop(float(middle[0]), float(middle[1]), side, side, angle)


def jittered_crops(crop: Crop) -> list[Crop]:
    """Return the crop and slightly scaled, rotated and shifted ones, for test-time augmentation.

    What a net says of them differs by half of its error (measured: 0.5 of 1.2 mm a point), so their mean errs less.
    """
    return [
        replace(
            crop,
            x_px=crop.x_px + right * crop.width_px,
            y_px=crop.y_px + down * crop.width_px,
            width_px=size * crop.width_px,
            height_px=size * crop.height_px,
            angle_rad=crop.angle_rad + turn,
        )
        for size, turn, right, down in _NEARBY
    ]


def rotated(points: Floats, angle_rad: float) -> Floats:
    """Return points (N, 2) rotated about the origin, clockwise as seen."""
    cos, sin = math.cos(angle_rad), math.sin(angle_rad)
    return np.asarray(points @ [[cos, sin], [-sin, cos]])


def mirror_crop(photo: Photo, crop: Crop) -> tuple[Photo, Crop]:
    """Return the mirrored photo and the corresponding crop in it."""
    flipped = np.asarray(cv2.flip(photo, 1), np.uint8)  # a tenth of the time that a reversed view takes to copy
    across = photo.shape[1] - 1 - crop.x_px
    return flipped, Crop(across, crop.y_px, crop.width_px, crop.height_px, -crop.angle_rad)


def square_around_photo(photo: Photo) -> Crop:
    """Return the smallest square around the photo."""
    height, width = photo.shape[:2]
    side = float(max(height, width))
    return Crop((width - 1) / 2.0, (height - 1) / 2.0, side, side)


def full_crop(photo: Photo) -> Crop:
    """Return the whole photo as a crop, which a square net sees squeezed."""
    height, width = photo.shape[:2]
    return Crop((width - 1) / 2.0, (height - 1) / 2.0, float(width), float(height))
