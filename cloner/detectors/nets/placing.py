"""Where to look: the crops nets want, and which finds belong together. No net here."""

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
    """Return the square round a circle, turned so that the rim point is up."""
    across, down = (rim - middle).tolist()
    side = 2.0 * math.hypot(across, down) * scale
    return Crop(float(middle[0]), float(middle[1]), side, side, math.atan2(across, -down))


def around_body(body: Box) -> Crop:
    """Return the square the pose net wants, from a detected body or from the net's own points."""
    return circle_crop(body.keypoints_px[0], body.keypoints_px[1], 1.25)


def same_crop(first: Crop, second: Crop) -> bool:
    """Whether two crops around bodies show one person alike: hips nearer than a hand is wide, of one height.

    Measured on 15 photos: what one person's crops differ by is 1 to 4 % of a side in place and up to 13 % in size.
    """
    apart = float(np.hypot(first.x_px - second.x_px, first.y_px - second.y_px))
    small, large = sorted((first.width_px, second.width_px))
    return apart < SAME_CROP * small and large < SAME_CROP_SIZE * small


def same_place(first: Box, second: Box, overlap: float) -> bool:
    """Whether two boxes share more than `overlap` of their union."""
    rows = [
        np.array([[b.left_px + b.right_px, b.top_px + b.bottom_px], [2 * b.width_px, 2 * b.height_px]]) / 2.0
        for b in (first, second)
    ]
    return bool(overlaps(rows[0], rows[1][None])[0] > overlap)


def distinct(boxes: list[Box]) -> list[Box]:
    """Return the boxes without repeats, the best first."""
    kept: list[Box] = []
    for box in sorted(boxes, key=lambda b: -b.score):
        if not any(same_place(box, other, SAME_BOX) for other in kept):
            kept.append(box)
    return kept


def near_head(person: Box, point: Floats) -> bool:
    """Whether a point lies no farther from a body's nose than its shoulders do."""
    shoulders, nose = person.keypoints_px[2:4]
    return bool(np.hypot(*(point - nose)) < np.hypot(*(shoulders - nose)))


def same_body(first: Box, second: Box) -> bool:
    """Whether two confirmed bodies are one: by either's head, or, in portraits from the side, by all but the head."""
    heads = near_head(first, second.keypoints_px[3]) or near_head(second, first.keypoints_px[3])
    return heads or same_place(first, second, 0.7)


def lies_in(inner: Box, outer: Box) -> bool:
    """Whether a smaller box lies within another's, but for a tenth of it."""
    across = min(inner.right_px, outer.right_px) - max(inner.left_px, outer.left_px)
    down = min(inner.bottom_px, outer.bottom_px) - max(inner.top_px, outer.top_px)
    size = inner.width_px * inner.height_px
    return size < outer.width_px * outer.height_px and min(across, down) > 0.0 and across * down > 0.9 * size


def stands(body: Box) -> bool:
    """Whether a detected body's head is above its hips: a pattern on trousers can look like one upside down."""
    hips, reach = body.keypoints_px[:2]
    return bool(reach[1] < hips[1])


def middle(box: Box) -> Floats:
    """Return the middle of a box, photo px."""
    return np.array([box.left_px + box.right_px, box.top_px + box.bottom_px]) / 2.0


def has_face(person: Box, faces: Sequence[Box]) -> bool:
    """Whether one of the faces is where a body's head is."""
    return any(near_head(person, middle(face)) for face in faces)


def owns(person: Box, face: Box) -> bool:
    """Whether a face is a body's own, or lies on it (a printed shirt)."""
    x, y = middle(face)
    inside = person.left_px < x < person.right_px and person.top_px < y < person.bottom_px
    return has_face(person, [face]) or inside


@lru_cache(maxsize=1)
def mirror_order() -> NDArray[np.intp]:
    """Return for each of the 468 points the one on the other side of the face."""
    with (files("cloner_models") / "nets" / "canonical_face.npz").open("rb") as file:
        vertices = np.load(file)["vertices_cm"].astype(np.float64)
    gap = np.linalg.norm(vertices[:, None] * np.array([-1.0, 1.0, 1.0]) - vertices[None], axis=-1)
    order = np.asarray(gap.argmin(axis=1), np.intp)
    order.flags.writeable = False
    return order


def face_crop(box: Box) -> Crop:
    """Return the square the mesh net wants, from a detected face."""
    right_eye, left_eye = box.keypoints_px[:2]
    across, down = (left_eye - right_eye).tolist()
    side = 1.5 * max(box.width_px, box.height_px)
    middle = ((box.left_px + box.right_px) / 2, (box.top_px + box.bottom_px) / 2)
    return Crop(*middle, side, side, math.atan2(down, across))


def around(box: Box) -> Crop:
    """Return an upright square three times as large as a found face."""
    side = 3.0 * max(box.width_px, box.height_px)
    return Crop((box.left_px + box.right_px) / 2, (box.top_px + box.bottom_px) / 2, side, side)


def mesh_crop(points: Floats) -> Crop:
    """Return the square the mesh net wants, from a first mesh in photo px."""
    across, down = (points[263, :2] - points[33, :2]).tolist()
    angle = math.atan2(down, across)
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    upright = points[:, :2] @ turn.T
    low, high = upright.min(axis=0), upright.max(axis=0)
    middle = turn.T @ ((low + high) / 2)
    side = 1.5 * float((high - low).max())
    return Crop(float(middle[0]), float(middle[1]), side, side, angle)


def nearby(crop: Crop) -> list[Crop]:
    """Return crops a little larger, smaller, turned and shifted, the given one first.

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


def turned(points: Floats, angle_rad: float) -> Floats:
    """Return (N, 2) points turned about the origin, clockwise as seen."""
    cos, sin = math.cos(angle_rad), math.sin(angle_rad)
    return np.asarray(points @ [[cos, sin], [-sin, cos]])


def mirror_crop(photo: Photo, crop: Crop) -> tuple[Photo, Crop]:
    """Return the mirrored photo and the crop that shows the same place in it."""
    flipped = np.asarray(cv2.flip(photo, 1), np.uint8)  # a tenth of the time that a reversed view takes to copy
    across = photo.shape[1] - 1 - crop.x_px
    return flipped, Crop(across, crop.y_px, crop.width_px, crop.height_px, -crop.angle_rad)


def whole_photo(photo: Photo) -> Crop:
    """Return the smallest square round the photo."""
    height, width = photo.shape[:2]
    side = float(max(height, width))
    return Crop((width - 1) / 2.0, (height - 1) / 2.0, side, side)


def whole_picture(photo: Photo) -> Crop:
    """Return the photo itself as a crop; a square net sees it squeezed."""
    height, width = photo.shape[:2]
    return Crop((width - 1) / 2.0, (height - 1) / 2.0, float(width), float(height))
