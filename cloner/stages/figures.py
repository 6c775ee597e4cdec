"""Who is in a photo and where: pose, mask and labels, as the pose net and the label net see them together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, cast

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.body.pose_order import read_again
from cloner.detectors.face.found import Face, face_behind_hair, face_in
from cloner.detectors.nets.portraits import is_cut_below
from cloner.detectors.nets.results import Box, PoseResult
from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.labels.crops import cuts, person_crop
from cloner.labels.looks import Looks, look
from cloner.labels.photo import label_photo
from cloner.records.photos import Photo
from cloner.vision.segmentation.masks import refine_mask

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.figures")

DENIED: Final = _CALIBRATED.number("denied", "score")
LABELLED: Final = _CALIBRATED.number("labelled", "share")
LEAST_PERSON = _CALIBRATED.number("least_person", "share")
UPRIGHT = _CALIBRATED.number("upright", "factor")
MOST_UNSURE = _CALIBRATED.number("most_unsure", "share")


class NobodySeen(ClonerError):
    """No net sees a person in a photo."""


def nobody_in(photo: Photo) -> NobodySeen:
    """Return the refusal of a photo in which no net sees a person."""
    return NobodySeen("no person found in this photo", "Take it again with one person in full view", photo.name)


def check_people(photo: Photo) -> Box:
    """Return the one person, or face, in a photo; refuse it without exactly one.

    Raises
    ------
    NobodySeen
        If nobody is found.
    ClonerError
        If more than one person is found.
    """
    people: list[Box] = DETECTORS.get("people")(photo.rgb)
    if not people:
        raise nobody_in(photo)
    if len(people) > 1:
        raise ClonerError(
            f"{len(people)} people found in this photo", "Take it again with one person alone in view", photo.name
        )
    return people[0]


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """Where the person is in a photo.

    Attributes
    ----------
    pose_px : (33, 2)
    visibility : (33,)
    probability : (H, W) uint8, 0..255
    inside : (H, W) bool
    labels : (H, W) uint8
    face : tuple
        As :func:`cloner.detectors.face.found.face_in` gives it.
    seen_px : (21, 2) or (0, 2)
        Joints and points under clothes.
    naked_px : (N, 4)
        Edges of the body under clothes.
    """

    pose_px: NDArray[np.float64]
    visibility: NDArray[np.float64]
    probability: NDArray[np.uint8]
    inside: NDArray[np.bool_]
    labels: NDArray[np.uint8]
    face: Face
    seen_px: NDArray[np.float64]
    naked_px: NDArray[np.float64]


def find_figure(photo: Photo) -> Figure:
    """Return pose, face, mask and labels of one photo.

    Raises
    ------
    ClonerError
        If the photo does not show exactly one person.
    """
    try:
        pose = DETECTORS.get("pose")(photo.rgb, check_people(photo))
    except NobodySeen:
        pose = _pose_unseen(photo)
    if pose is None:
        raise nobody_in(photo)
    pose = read_again(photo.rgb, photo.view, pose, DETECTORS.get("pose"))
    if float((pose.mask > 0.5).mean()) < LEAST_PERSON:
        raise nobody_in(photo)
    face = face_in(photo)
    looks = _look(photo, pose.mask, pose.points_px, face)
    if photo.view.is_body and cuts(person_crop(pose.mask > 0.5, photo.view), looks.person(pose.mask.shape)):
        whole = _pose_unseen(photo)  # the detector's circle ended at the shins
        if whole is not None:
            pose = read_again(photo.rgb, photo.view, whole, DETECTORS.get("pose"))
            looks = _look(photo, pose.mask, pose.points_px, face)
    return _figure(photo, pose.points_px, np.asarray(pose.visibility, dtype=np.float64), pose.mask, face, looks)


def _pose_unseen(photo: Photo) -> PoseResult | None:
    """Return the pose of somebody whom no detector sees, or not whole; None where there is none."""
    if photo.view is ViewId.FACE_SIDE:
        return cast(PoseResult | None, DETECTORS.get("pose_with_room")(photo.rgb))
    standing = standing_mask(photo) if photo.view.is_body else None
    return None if standing is None else DETECTORS.get("pose_in_mask")(photo.rgb, standing)


def _look(photo: Photo, rough: NDArray[np.float32], pose_px: NDArray[np.float64], face: Face) -> Looks:
    """Return what the label net sees of somebody who is roughly (H, W) known."""
    features = DETECTORS.get("label_features")
    return look(photo.rgb, rough > 0.5, photo.view, features, face_points=_shown(face), pose_points=pose_px)


def _shown(face: Face) -> NDArray[np.float64] | None:
    return face[0] if face[2] > 0.0 else None


def _figure(
    photo: Photo,
    pose_px: NDArray[np.float64],
    visibility: NDArray[np.float64],
    rough: NDArray[np.float32],
    face: Face,
    looks: Looks,
) -> Figure:
    """Return what is in a photo whose person is roughly (H, W) known.

    Raises
    ------
    NobodySeen
        If next to nothing of the photo is the person.
    """
    shown = _shown(face)
    labelled = looks.person(rough.shape)
    rough = both_masks(rough, labelled) if photo.view.is_face else undenied(rough, labelled)
    mask = refine_mask(photo.rgb, rough, pose_px if photo.view.is_body and visibility.any() else None)
    if float((mask > 0.5).mean()) < LEAST_PERSON:
        raise nobody_in(photo)
    labels, _ = label_photo(photo.rgb, mask > 0.5, looks, shown, faced=photo.view is not ViewId.BODY_BACK)
    if shown is None and visibility.any():
        face = face_behind_hair(photo, pose_px, labels) or face
    probability = np.round(np.clip(mask, 0.0, 1.0) * 255).astype(np.uint8)
    return Figure(pose_px, visibility, probability, mask > 0.5, labels, face, looks.seen_px, looks.naked_px)


def both_masks(posed: NDArray[np.float32], labelled: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (H, W) the person's probability in a face photo from the selfie net's mask and that of the label net."""
    first, second = (np.clip(each, 0.01, 0.99) for each in (posed, labelled))
    odds = (1.0 - LABELLED) * np.log(first / (1.0 - first)) + LABELLED * np.log(second / (1.0 - second))
    return np.asarray(1.0 / (1.0 + np.exp(-odds)), np.float32)


def undenied(posed: NDArray[np.float32], labelled: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (H, W) the person's probability in a body photo: the pose net's, even odds where the label net is sure of
    the opposite.

    Either takes what stands behind a limb for a part of it now and then, seldom both; the photo's colours decide there.
    """
    denied = np.where(posed > 0.5, labelled < DENIED, labelled > 1.0 - DENIED)
    return np.where(denied, np.float32(0.5), posed)


def find_hidden_figure(photo: Photo) -> Figure | None:
    """Return a portrait in which no body or face is seen, as the label net sees it; None where that is torn.

    Its pose is unknown: all points lie in the mask's middle and none is visible.
    """
    mask = _seen_anywhere(photo)
    if not _is_whole(mask) or not is_cut_below(mask.astype(np.float64)):
        return None
    rows, columns = np.nonzero(mask > 0.5)
    pose = np.tile(np.array([columns.mean(), rows.mean()]), (33, 1))
    face = face_in(photo)
    return _figure(photo, pose, np.zeros(33), mask, face, _look(photo, mask, pose, face))


def _seen_anywhere(photo: Photo) -> NDArray[np.float32]:
    """Return (H, W) the probability of a person as the label net sees it in the whole photo."""
    everywhere = np.ones(photo.rgb.shape[:2], np.bool_)
    return look(photo.rgb, everywhere, photo.view, DETECTORS.get("label_features")).person(everywhere.shape)


def standing_mask(photo: Photo) -> NDArray[np.bool_] | None:
    """Return the (H, W) standing figure that the label net sees in a body photo, None where it sees none."""
    mask = _seen_anywhere(photo)
    inside = np.asarray(mask > 0.5, np.bool_)
    return inside if _is_whole(mask) and not is_cut_below(mask.astype(np.float64)) and _stands(inside) else None


def _is_whole(mask: NDArray[np.float32]) -> bool:
    """Whether a (H, W) probability is a person's: large enough, and sure where it ends."""
    person, unsure = float((mask > 0.5).mean()), float(((mask > 0.1) & (mask < 0.9)).mean())
    return person >= LEAST_PERSON and unsure <= MOST_UNSURE * person


def _stands(inside: NDArray[np.bool_]) -> bool:
    rows, columns = (np.ptp(np.flatnonzero(inside.any(axis=axis))) for axis in (1, 0))
    return bool(rows > UPRIGHT * columns)
