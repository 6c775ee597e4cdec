"""Class probabilities of a photo by the label net: the whole person, and the head at a larger scale."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.labels.crops import head_crop, person_crop
from cloner.labels.decoder import SIDE_PX, Scores, decode, probabilities
from cloner.labels.naked_edges import IN_HEAD, IN_PERSON, NO_EDGES, body_edges
from cloner.labels.points import locate_points
from cloner.records.labels import Label
from cloner.vision.photographs.crops import Crop, cut, photo_px_from_crop
from cloner.vision.photographs.head_frame import HeadFrame, find_head

#: What each number is and where it comes from: ``cloner/calibration/labels.toml``.
_CALIBRATED: Final = calibrated("labels.evidence")

Photo = NDArray[np.uint8]
Floats = NDArray[np.float32]
Points = NDArray[np.float64]
Features = Callable[[Photo], Sequence[Floats]]

#: Labels are decided at this long side, px; the photo's own pixels decide the outline and the hair's edge.
WORK_PX: Final = 800
#: The head is decided at this side, px.
HEAD_PX: Final = 480
RIM: Final = _CALIBRATED.number("rim", "share")


@dataclass(frozen=True, slots=True, eq=False)
class LabelEvidence:
    """Class probabilities of a photo by the label net, before any decision.

    Attributes
    ----------
    whole : (11, h, w) float32
        Probabilities over the whole photo, its long side `WORK_PX` at most.
    near : (11, h, w) float32 or None
        The same in the head's box, at most `HEAD_PX` a side; None where the photo shows no head.
    box : pair of slices or None
        The head's rows and columns in the photo.
    head : HeadFrame
    seen_px : (21, 2) float64
        Joints and points under clothes, ``cloner.generic.seen_points.NAMES``; no rows in a photo of the face.
    naked_px : (N, 4) float64
        Where the body ends under clothes (``cloner.labels.naked_edges``); no rows in a photo of the face.
    """

    whole: Floats
    near: Floats | None
    box: tuple[slice, slice] | None
    head: HeadFrame
    seen_px: Points
    naked_px: Points

    def rough_person(self, shape: tuple[int, ...]) -> Floats:
        """Return the probability (H, W) that a pixel shows the person, without the closer look at the head."""
        return np.asarray(1.0 - resized_to(self.whole[Label.BACKGROUND], shape), np.float32)

    def person(self, shape: tuple[int, ...]) -> Floats:
        """Return the probability (H, W) that a pixel shows the person."""
        found = self.rough_person(shape)
        if self.near is not None and self.box is not None:
            found[self.box] = 1.0 - resized_to(self.near[Label.BACKGROUND], found[self.box].shape)
        return found


def label_evidence(
    rgb: Photo,
    person: NDArray[np.bool_],
    view: ViewId,
    features: Features,
    *,
    face_points: Points | None = None,
    pose_points: Points | None = None,
) -> LabelEvidence:
    """Return the label net's output for a photo: the whole person, and the head alone.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    person : (H, W) bool
        Roughly where the person is; some pixel is True.
    view : ViewId
    features : callable
        From a (256, 256, 3) uint8 crop to the features that the decoder reads
        (``DETECTORS.get("label_features")``).
    face_points : (468, 2) float64, optional
        Face mesh in px, where the photo shows a face from the front.
    pose_points : (33, 2) float64, optional
        Pose points in px.
    """
    crop = person_crop(person, view)
    scores = _scores(rgb, crop, features)
    points = locate_points(scores.points, crop, view) if view.is_body else np.zeros((0, 2))
    naked = body_edges(scores.parts, crop, IN_PERSON) if view.is_body else NO_EDGES
    whole = _in_photo(probabilities(scores.classes), crop, person.shape)
    head = find_head(person, face_points, str(view), pose_points)
    near = head_crop(head)
    box = _box(near, person.shape)
    if box is None:
        return LabelEvidence(whole, None, None, head, points, naked)
    close = _scores(rgb, near, features)
    if view.is_body:
        naked = np.concatenate([naked, body_edges(close.parts, near, IN_HEAD)])
    return LabelEvidence(
        whole, _blend_head(probabilities(close.classes), near, whole, box, person.shape), box, head, points, naked
    )


def _scores(rgb: Photo, crop: Crop, features: Features) -> Scores:
    """Return the label net's output for a crop."""
    image = cut(rgb, crop, width=SIDE_PX, height=SIDE_PX)
    return decode(features(image), image)


def _in_photo(shares: Floats, crop: Crop, shape: tuple[int, ...]) -> Floats:
    """Return the probabilities (11, h, w) of a whole photo, its long side at most ``WORK_PX``."""
    scale = min(1.0, WORK_PX / max(shape))
    size = (max(1, round(shape[1] * scale)), max(1, round(shape[0] * scale)))
    return _resampled(shares, crop, (0.0, 0.0, float(shape[1]), float(shape[0])), size)


def _resampled(shares: Floats, crop: Crop, box: tuple[float, float, float, float], size: tuple[int, int]) -> Floats:
    """Return a crop's planes in a box (left, top, width, height) of the photo, resampled to (width, height).

    Beyond the crop all is background.
    """
    photo_from_crop = np.vstack([photo_px_from_crop(crop, width=SIDE_PX, height=SIDE_PX), [0.0, 0.0, 1.0]])
    across, down = box[2] / size[0], box[3] / size[1]
    photo_from_out = np.array(
        [[across, 0.0, box[0] + across / 2 - 0.5], [0.0, down, box[1] + down / 2 - 0.5], [0.0, 0.0, 1.0]]
    )
    crop_from_out = (np.linalg.inv(photo_from_crop) @ photo_from_out)[:2]
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    planes = [
        cv2.warpAffine(plane, crop_from_out, size, flags=flags, borderMode=cv2.BORDER_CONSTANT, borderValue=outside)
        for plane, outside in zip(shares, [1.0] + [0.0] * (len(shares) - 1), strict=True)
    ]
    return np.stack(planes)


def resized_to(plane: Floats, shape: tuple[int, ...]) -> Floats:
    """Return a plane at the size of a photo (H, W, ...), bilinear."""
    return np.asarray(cv2.resize(plane, (shape[1], shape[0]), interpolation=cv2.INTER_LINEAR), np.float32)


def _box(crop: Crop, shape: tuple[int, ...]) -> tuple[slice, slice] | None:
    """Return the rows and columns of the photo that a crop covers, None where it covers next to nothing."""
    half = crop.width_px / 2
    top, left = int(max(crop.y_px - half, 0)), int(max(crop.x_px - half, 0))
    bottom, right = int(min(crop.y_px + half, shape[0])), int(min(crop.x_px + half, shape[1]))
    return None if bottom - top < 8 or right - left < 8 else (slice(top, bottom), slice(left, right))


def _blend_head(close: Floats, crop: Crop, shares: Floats, box: tuple[slice, slice], shape: tuple[int, ...]) -> Floats:
    """Return the probabilities in the head's box: those of the head crop inside, blended to the whole person's at its
    border.
    """
    rows, columns = box
    height, width = rows.stop - rows.start, columns.stop - columns.start
    scale = min(1.0, HEAD_PX / max(height, width))
    size = (max(1, round(width * scale)), max(1, round(height * scale)))
    place = (float(columns.start), float(rows.start), float(width), float(height))
    near = _resampled(close, crop, place, size)
    weight = _resampled(_blend_weights()[None], crop, place, size)[0]
    ratio = shares.shape[1] / shape[0], shares.shape[2] / shape[1]
    cut_rows = slice(int(rows.start * ratio[0]), int(np.ceil(rows.stop * ratio[0])))
    cut_columns = slice(int(columns.start * ratio[1]), int(np.ceil(columns.stop * ratio[1])))
    far = np.stack([cv2.resize(plane[cut_rows, cut_columns], size) for plane in shares])
    return np.asarray(far + weight * (near - far), np.float32)


def _blend_weights() -> Floats:
    """Return the weights (256, 256) of the head crop: one inside, zero at the border."""
    away = np.minimum(np.arange(SIDE_PX), np.arange(SIDE_PX)[::-1]) / (RIM * SIDE_PX)
    side = np.clip(away, 0.0, 1.0)
    return np.asarray(np.minimum(side[:, None], side[None, :]), np.float32)
