"""People in a photo: bodies that the pose net confirms, and faces without a body."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.nets.litert import detect, detect_pose, face_mesh, find_faces, pose_net, selfie_net
from cloner.detectors.nets.placing import (
    body_crop,
    face_crop,
    full_crop,
    has_face,
    is_upright,
    is_within,
    owns_face,
    same_body,
    same_crop,
    square_around_photo,
)  # fmt: skip
from cloner.detectors.nets.portraits import is_cut_below
from cloner.detectors.nets.pose_passes import CONFIRMED, run_portrait_pose, run_pose
from cloner.detectors.nets.results import Box, PoseResult
from cloner.vision.photographs.crops import Crop
from cloner.vision.segmentation.pieces import box_around

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.people")

Photo = NDArray[np.uint8]

CLEAR: Final = _CALIBRATED.number("clear", "score")
DIM: Final = _CALIBRATED.number("dim", "score")
CERTAIN: Final = _CALIBRATED.number("certain", "score")
ROOM: Final = _CALIBRATED.number("room", "share")
AT_EDGE: Final = _CALIBRATED.number("at_edge", "share")
IN_MASK: Final = _CALIBRATED.quadruple("in_mask", "share")


def _find_people(photo: Photo) -> list[Box]:
    """Return the bodies in a photo that the pose net confirms, the best first.

    The detector sees one person well and a second beside him badly, so it also looks at
    the left and the right of the photo alone. Whom it sees dimly (a long coat, hair over the face) counts when the
    pose net is certain and nobody else is there.
    """
    height, width = photo.shape[:2]
    side = float(max(height, 0.6 * width))
    tiles = [square_around_photo(photo)]
    tiles += [Crop(x * width, (height - 1) / 2.0, side, side) for x in (0.27, 0.73)]
    found = [b for tile in tiles for b in detect("pose_detection", photo, tile, "person", DIM)]
    found = sorted((box for box in found if is_upright(box)), key=lambda b: -b.score)
    people = _confirmed_by_pose(photo, [box for box in found if box.score >= CLEAR], CONFIRMED)
    dim = [] if people else [box for box in found if box.score < CLEAR]
    if dim and is_cut_below(selfie_net(photo, full_crop(photo))):
        dim = []  # a portrait: what stands in it is no whole body
    return people or _confirmed_by_pose(photo, dim, CERTAIN)[:1]


def _confirmed_by_pose(photo: Photo, boxes: Sequence[Box], least: float) -> list[Box]:
    """Return the distinct bodies among boxes with at least this pose score, in the boxes' order."""
    people: list[Box] = []
    confirmed: list[Crop] = []
    for box in boxes:
        crop = body_crop(box)
        if any(same_crop(other, crop) for other in confirmed):  # as most tiles find the person: a third of the looks
            continue
        seen = run_pose(photo, crop, pose_net)
        if seen.score < least:
            continue
        confirmed.append(crop)
        body = seen.box(box.score)
        if not any(same_body(other, body) for other in people):
            people.append(body)
    return people


def detect_people(rgb: Photo) -> list[Box]:
    """List the distinct people in a photo, the largest first.

    Bodies count when the pose net confirms them, faces when the mesh net does and no
    counted body owns them. Within another's body counts only who has a face: a headscarf
    over a jacket over a striped skirt looks like three people from behind.
    Anyone under 45 % of the largest one's size is left out: posters, passers-by far behind.

    Parameters
    ----------
    rgb : (H, W, 3) uint8

    Returns
    -------
    list of Box
        Empty: nobody. More than one: refuse the photo.
    """
    people = _find_people(rgb)
    tallest = max((p.height_px for p in people), default=0.0)
    people = [p for p in people if p.height_px >= 0.45 * tallest]
    faces = [f for f in find_faces(rgb, 0.6) if face_mesh(rgb, face_crop(f))[1] > 0.5]
    people = [p for p in people if has_face(p, faces) or not any(is_within(p, other) for other in people)]
    widest = max((f.width_px for f in faces), default=0.0)
    owned = [any(owns_face(p, f) for p in people) for f in faces]
    # a body's own face tells how large other faces must be; without one, a tenth of it
    least = max([f.width_px for f, o in zip(faces, owned, strict=True) if o], default=0.12 * tallest)
    for face, has_owner in zip(faces, owned, strict=True):
        if not has_owner and face.width_px >= 0.45 * max(least, 0.0 if people else widest):
            people.append(face)
    if not people:
        portrait = run_portrait_pose(rgb, pose_net, selfie_net, None)
        people = [] if portrait is None else [portrait.box(portrait.score)]
    return sorted(people, key=lambda p: -p.height_px)


def padded_pose(rgb: Photo) -> PoseResult | None:
    """Find the person whose head fills a portrait up to its upper edge, where the nets need padding.

    The edge is continued above and on both sides.

    Parameters
    ----------
    rgb : (H, W, 3) uint8

    Returns
    -------
    PoseResult or None
        In the photo's own pixels; None without exactly one person who reaches the upper edge.
    """
    height, width = rgb.shape[:2]
    room = round(ROOM * height)
    wide = cv2.copyMakeBorder(rgb, room, 0, room, room, cv2.BORDER_REPLICATE)
    people = detect_people(wide)
    pose = detect_pose(wide, people[0]) if len(people) == 1 else None
    if pose is None:
        return None
    mask = pose.mask[room:, room : room + width]
    if not (mask[: max(round(AT_EDGE * height), 1)] > 0.5).any():
        return None
    return replace(pose, points_px=pose.points_px - room, mask=np.ascontiguousarray(mask))


def pose_in_mask(rgb: Photo, inside: NDArray[np.bool_]) -> PoseResult | None:
    """Find the person inside a mask that no detector sees: hooded, before a cluttered wall.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    inside : (H, W) bool
        Where another net sees somebody standing.

    Returns
    -------
    PoseResult or None
        None where the pose net is not certain.
    """
    rows, columns = box_around(inside)
    left, top, right, bottom = float(columns.start), float(rows.start), columns.stop - 1.0, rows.stop - 1.0
    hips, radius, shoulders, nose = IN_MASK
    shares = np.array([hips, hips - radius, shoulders, nose])
    points = np.column_stack([np.full(4, 0.5 * (left + right)), top + (bottom - top) * shares])
    box = Box("person", left, top, right, bottom, 1.0, points)
    return detect_pose(rgb, box) if run_pose(rgb, body_crop(box), pose_net).score >= CERTAIN else None
