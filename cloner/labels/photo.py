"""The label picture of one photo."""

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
from cloner.labels.decoder import SIDE_PX, Scores, decoded, shares_of
from cloner.labels.own_skin import without_strange_skin
from cloner.labels.points import points_seen
from cloner.records.labels import Label, shows
from cloner.vision.photographs.crops import Crop, cut, photo_px_from_crop
from cloner.vision.photographs.head_frame import HeadFrame, find_head
from cloner.vision.retouching.repair import nearest_known
from cloner.vision.segmentation.hair_edge import draw_edge
from cloner.vision.segmentation.pieces import pieces_of

#: What each number is and where it comes from: ``cloner/calibration/labels.toml``.
_CALIBRATED: Final = calibrated("labels.photo")

Photo = NDArray[np.uint8]
Floats = NDArray[np.float32]
Points = NDArray[np.float64]
Features = Callable[[Photo], Sequence[Floats]]

#: Labels are decided at this long side, px; the photo's own pixels decide the outline and the hair's edge.
WORK_PX: Final = 800
#: The head is decided at this side, px.
HEAD_PX: Final = 480
SPECK: Final = _CALIBRATED.number("speck", "factor")
SMALL_BY_NATURE: Final = (Label.EYES, Label.MOUTH)
RIM: Final = _CALIBRATED.number("rim", "share")


@dataclass(frozen=True, slots=True, eq=False)
class Looks:
    """What the label net sees in a photo, before anything is decided.

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
    """

    whole: Floats
    near: Floats | None
    box: tuple[slice, slice] | None
    head: HeadFrame
    seen_px: Points

    def person(self, shape: tuple[int, ...]) -> Floats:
        """Return (H, W) the probability that a pixel of the photo shows the person."""
        found = 1.0 - _sized(self.whole[Label.BACKGROUND], shape)
        if self.near is not None and self.box is not None:
            found[self.box] = 1.0 - _sized(self.near[Label.BACKGROUND], found[self.box].shape)
        return np.asarray(found, np.float32)


def look(
    rgb: Photo,
    person: NDArray[np.bool_],
    view: ViewId,
    features: Features,
    *,
    face_points: Points | None = None,
    pose_points: Points | None = None,
) -> Looks:
    """Return what the label net sees in a photo: the person as a whole, and the head alone.

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
    points = points_seen(scores.points, crop, view) if view.is_body else np.zeros((0, 2))
    whole = _in_photo(shares_of(scores.classes), crop, person.shape)
    head = find_head(person, face_points, str(view), pose_points)
    near = head_crop(head)
    box = _box(near, person.shape)
    if box is None:
        return Looks(whole, None, None, head, points)
    close = shares_of(_scores(rgb, near, features).classes)
    return Looks(whole, _blended(close, near, whole, box, person.shape), box, head, points)


def label_photo(
    rgb: Photo, person: NDArray[np.bool_], looks: Looks, face_points: Points | None = None, *, faced: bool = True
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return what every pixel of a photo shows, and how sure that is.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    person : (H, W) bool
        The person; everything else is background.
    looks : Looks
        Of the same photo.
    face_points : (468, 2) float64, optional
        Face mesh in px.
    faced : bool
        False of a back.

    Returns
    -------
    labels : (H, W) uint8
        Values of ``cloner.records.labels.Label``.
    confidence : (H, W) uint8
        Probability of the label, 255 is certain.
    """
    labels, sure = _decided(looks.whole, person.shape)
    if looks.near is not None and looks.box is not None:
        box = looks.box
        labels[box], sure[box] = _decided(looks.near, labels[box].shape)
        _draw_hair(labels, looks.near[Label.HAIR], rgb, person, box, looks.head, face_points)
    labels[~person] = Label.BACKGROUND
    labels = without_collars(labels, looks.head.chin_px)
    labels = without_specks(labels, SPECK * looks.head.head_px**2)
    return (without_strange_skin(rgb, labels, looks.seen_px, faced=faced) if len(looks.seen_px) else labels), sure


def _scores(rgb: Photo, crop: Crop, features: Features) -> Scores:
    """Return what the label net says of a crop."""
    image = cut(rgb, crop, width=SIDE_PX, height=SIDE_PX)
    return decoded(features(image), image)


def _in_photo(shares: Floats, crop: Crop, shape: tuple[int, ...]) -> Floats:
    """Return the probabilities (11, h, w) of a whole photo, its long side ``WORK_PX`` at most."""
    scale = min(1.0, WORK_PX / max(shape))
    size = (max(1, round(shape[1] * scale)), max(1, round(shape[0] * scale)))
    return _warped(shares, crop, (0.0, 0.0, float(shape[1]), float(shape[0])), size)


def _warped(shares: Floats, crop: Crop, box: tuple[float, float, float, float], size: tuple[int, int]) -> Floats:
    """Return a crop's planes in a box (left, top, width, height) of the photo, resampled to a (width, height).

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


def _sized(plane: Floats, shape: tuple[int, ...]) -> Floats:
    return np.asarray(cv2.resize(plane, (shape[1], shape[0]), interpolation=cv2.INTER_LINEAR), np.float32)


def _box(crop: Crop, shape: tuple[int, ...]) -> tuple[slice, slice] | None:
    """Return the rows and columns of the photo that a crop covers; None where it covers next to nothing."""
    half = crop.width_px / 2
    top, left = int(max(crop.y_px - half, 0)), int(max(crop.x_px - half, 0))
    bottom, right = int(min(crop.y_px + half, shape[0])), int(min(crop.x_px + half, shape[1]))
    return None if bottom - top < 8 or right - left < 8 else (slice(top, bottom), slice(left, right))


def _blended(close: Floats, crop: Crop, shares: Floats, box: tuple[slice, slice], shape: tuple[int, ...]) -> Floats:
    """Return the probabilities in the head's box: the near look inside, the whole person's at its rim."""
    rows, columns = box
    height, width = rows.stop - rows.start, columns.stop - columns.start
    scale = min(1.0, HEAD_PX / max(height, width))
    size = (max(1, round(width * scale)), max(1, round(height * scale)))
    place = (float(columns.start), float(rows.start), float(width), float(height))
    near = _warped(close, crop, place, size)
    weight = _warped(_rim()[None], crop, place, size)[0]
    ratio = shares.shape[1] / shape[0], shares.shape[2] / shape[1]
    cut_rows = slice(int(rows.start * ratio[0]), int(np.ceil(rows.stop * ratio[0])))
    cut_columns = slice(int(columns.start * ratio[1]), int(np.ceil(columns.stop * ratio[1])))
    far = np.stack([cv2.resize(plane[cut_rows, cut_columns], size) for plane in shares])
    return np.asarray(far + weight * (near - far), np.float32)


def _rim() -> Floats:
    """Return (256, 256) how much the near look counts: all inside, nothing at the border."""
    away = np.minimum(np.arange(SIDE_PX), np.arange(SIDE_PX)[::-1]) / (RIM * SIDE_PX)
    side = np.clip(away, 0.0, 1.0)
    return np.asarray(np.minimum(side[:, None], side[None, :]), np.float32)


def _decided(shares: Floats, shape: tuple[int, ...]) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return the likeliest class of the person at the photo's size, and its share of all classes but background."""
    own = shares[1:]
    best = (own.argmax(axis=0) + 1).astype(np.uint8)
    sure = np.round(255 * own.max(axis=0) / np.maximum(own.sum(axis=0), 1e-6)).astype(np.uint8)
    size = (shape[1], shape[0])
    return (
        np.asarray(cv2.resize(best, size, interpolation=cv2.INTER_NEAREST), np.uint8),
        np.asarray(cv2.resize(sure, size, interpolation=cv2.INTER_LINEAR), np.uint8),
    )


def _draw_hair(
    labels: NDArray[np.uint8],
    hair: Floats,
    rgb: Photo,
    person: NDArray[np.bool_],
    box: tuple[slice, slice],
    head: HeadFrame,
    face_points: Points | None,
) -> None:
    """Redraw the hair's edge in the head's box along the photo's own colours, in place."""
    part = labels[box]
    if not (part == Label.HAIR).any():
        return
    coarse = _sized(hair, part.shape)
    shift = np.array([box[1].start, box[0].start], np.float64)
    face = None if face_points is None else face_points[:, :2] - shift
    fine = draw_edge(rgb[box], coarse, person[box], face, head.head_px, head.ear_px - shift[1])
    lost = (part == Label.HAIR) & ~fine
    part[lost] = _nearest(part, ~lost & (part != Label.HAIR) & person[box], lost)
    part[fine & ~np.isin(part, (Label.EYES, Label.ACCESSORY, Label.BEARD))] = Label.HAIR


def without_collars(labels: NDArray[np.uint8], chin_px: float) -> NDArray[np.uint8]:
    """Return a label picture without hair that begins below the chin: hair hangs from the scalp, collars do not.

    Parameters
    ----------
    labels : (H, W) uint8
    chin_px : float
        Row of the chin.
    """
    # a band or a scarf may cross a tail, a beard may join it
    box, pieces, figures = pieces_of(shows(labels, Label.HAIR, Label.ACCESSORY, Label.BEARD))
    low = figures[:, cv2.CC_STAT_TOP] > chin_px
    low[0] = False
    collar = np.zeros(labels.shape, np.bool_)
    collar[box] = low[pieces] & (labels[box] == Label.HAIR)
    if not collar.any():
        return labels
    cleaned = labels.copy()
    known = ~shows(labels, Label.BACKGROUND, Label.HAIR)
    cleaned[collar] = _nearest(labels, known, collar)
    return cleaned


def without_specks(labels: NDArray[np.uint8], least_px: float) -> NDArray[np.uint8]:
    """Return a label picture whose small pieces have become what lies nearest to them.

    Parameters
    ----------
    labels : (H, W) uint8
    least_px : float
        Pieces of fewer pixels go, unless they are `SMALL_BY_NATURE` or background.
    """
    small = np.zeros(labels.shape, np.bool_)
    for label in np.unique(labels):
        if label == Label.BACKGROUND or label in SMALL_BY_NATURE:
            continue
        box, pieces, figures = pieces_of(labels == label)
        few = figures[:, cv2.CC_STAT_AREA] < least_px
        few[0] = False
        small[box] |= few[pieces]
    if not small.any():
        return labels
    cleaned = labels.copy()
    cleaned[small] = _nearest(labels, ~small & (labels != Label.BACKGROUND), small)
    return cleaned


def _nearest(labels: NDArray[np.uint8], known: NDArray[np.bool_], wanted: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return the nearest known label of each wanted pixel."""
    if not known.any():
        return np.full(int(wanted.sum()), Label.FACE_SKIN, np.uint8)
    return nearest_known(labels, known, wanted)
