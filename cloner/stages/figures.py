"""The person in a photo: pose, mask and labels, by pose net and label net together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, cast

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.body.pose_order import pose_by_mirror
from cloner.detectors.face.frontal import Face, frontal_face, frontal_face_behind_hair
from cloner.detectors.nets.portraits import is_cut_below
from cloner.detectors.nets.results import Box, PoseResult
from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.labels.crops import is_cut_by_crop, person_crop
from cloner.labels.evidence import LabelEvidence, label_evidence
from cloner.labels.photo import label_photo
from cloner.records.photos import Photo
from cloner.vision.segmentation.masks import refine_mask
from cloner.vision.segmentation.pieces import largest_piece

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.figures")

AGREED: Final = _CALIBRATED.number("agreed", "share")
DENIED: Final = _CALIBRATED.number("denied", "score")
LABELLED: Final = _CALIBRATED.number("labelled", "share")
LEAST_PERSON = _CALIBRATED.number("least_person", "share")
UPRIGHT = _CALIBRATED.number("upright", "factor")
MOST_UNSURE = _CALIBRATED.number("most_unsure", "share")


class NobodySeen(ClonerError):
    """No net detects a person in a photo."""


def nobody_seen(photo: Photo) -> NobodySeen:
    """Return the error for a photo in which no net detects a person."""
    return NobodySeen("no person found in this photo", "Take it again with one person in full view", photo.name)


def check_people(photo: Photo) -> Box:
    """Return the one person, or face, in a photo; raise unless there is exactly one.

    Raises
    ------
    NobodySeen
        If nobody is found.
    ClonerError
        If more than one person is found.
    """
    people: list[Box] = DETECTORS.get("people")(photo.rgb)
    if not people:
        raise nobody_seen(photo)
    if len(people) > 1:
        raise ClonerError(
            f"{len(people)} people found in this photo", "Take it again with one person alone in view", photo.name
        )
    return people[0]


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """Pose, face, mask and labels of the person in a photo.

    Attributes
    ----------
    pose_px : (33, 2)
    visibility : (33,)
    probability : (H, W) uint8, 0..255
    inside : (H, W) bool
    labels : (H, W) uint8
    face : tuple
        As :func:`cloner.detectors.face.frontal.frontal_face` gives it.
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


@dataclass(frozen=True, slots=True, eq=False)
class PersonEvidence:
    """What the pose net and the label net say of the person in a photo.

    Attributes
    ----------
    pose : PoseResult
    labels : LabelEvidence
    person : (H, W) float32
        Probability of the person by the label net.
    """

    pose: PoseResult
    labels: LabelEvidence
    person: NDArray[np.float32]

    def agreement(self) -> float:
        """Return the intersection over union of the person by either net."""
        inside, seen = self.pose.mask > 0.5, self.person > 0.5
        return float(np.count_nonzero(inside & seen) / np.count_nonzero(inside | seen))

    def is_cut(self, view: ViewId) -> bool:
        """Return whether the label net sees the person continue beyond where the pose net does."""
        return is_cut_by_crop(person_crop(self.pose.mask > 0.5, view), self.person)


def find_figure(photo: Photo) -> Figure:
    """Return pose, face, mask and labels of one photo.

    Where no detector sees the person, or the nets disagree about it, the label net looks at the whole photo; what both
    nets agree about best counts.

    Raises
    ------
    ClonerError
        If the photo does not show exactly one person.
    """
    try:
        pose: PoseResult | None = DETECTORS.get("pose")(photo.rgb, check_people(photo))
    except NobodySeen:
        pose = None
    face = frontal_face(photo)
    best = _person_evidence(photo, pose, face)
    if best is None or (photo.view.is_body and (best.is_cut(photo.view) or best.agreement() < AGREED)):
        second = _person_evidence(photo, _pose_of_undetected(photo), face)
        if best is None or (second is not None and (best.is_cut(photo.view) or second.agreement() > best.agreement())):
            best = second
    if best is None:
        raise nobody_seen(photo)
    pose = best.pose
    visibility = np.asarray(pose.visibility, dtype=np.float64)
    return _figure(photo, pose.points_px, visibility, pose.mask, face, best.labels, best.person)


def _person_evidence(photo: Photo, pose: PoseResult | None, face: Face) -> PersonEvidence | None:
    """Return what both nets say of the person of a pose, None where next to nothing of the photo is one."""
    if pose is None:
        return None
    pose = pose_by_mirror(photo.rgb, photo.view, pose, DETECTORS.get("pose"))
    inside = pose.mask > 0.5
    if float(inside.mean()) < LEAST_PERSON:
        return None
    labels = _label_person(photo, pose.mask, pose.points_px, face)
    return PersonEvidence(pose, labels, labels.person(inside.shape))


def _pose_of_undetected(photo: Photo) -> PoseResult | None:
    """Return the pose of a person whom no detector sees, or not completely; None where there is none."""
    if photo.view is ViewId.FACE_SIDE:
        return cast(PoseResult | None, DETECTORS.get("padded_pose")(photo.rgb))
    standing = standing_mask(photo) if photo.view.is_body else None
    return None if standing is None else DETECTORS.get("pose_in_mask")(photo.rgb, standing)


def _label_person(photo: Photo, rough: NDArray[np.float32], pose_px: NDArray[np.float64], face: Face) -> LabelEvidence:
    """Return the label net's output for a person whose rough mask (H, W) is known."""
    features = DETECTORS.get("label_features")
    return label_evidence(
        photo.rgb, rough > 0.5, photo.view, features, face_points=_is_face_shown(face), pose_points=pose_px
    )


def _is_face_shown(face: Face) -> NDArray[np.float64] | None:
    return face[0] if face[2] > 0.0 else None


def _figure(
    photo: Photo,
    pose_px: NDArray[np.float64],
    visibility: NDArray[np.float64],
    rough: NDArray[np.float32],
    face: Face,
    looks: LabelEvidence,
    labelled: NDArray[np.float32],
) -> Figure:
    """Return the figure of a person whose rough masks (H, W) by both nets are known.

    Raises
    ------
    NobodySeen
        If next to nothing of the photo is the person.
    """
    shown = _is_face_shown(face)
    rough = merge_masks(rough, labelled) if photo.view.is_face else veto_by_labels(rough, labelled)
    mask = refine_mask(photo.rgb, rough, pose_px if photo.view.is_body and visibility.any() else None)
    if float((mask > 0.5).mean()) < LEAST_PERSON:
        raise nobody_seen(photo)
    labels, _ = label_photo(photo.rgb, mask > 0.5, looks, shown, faced=photo.view is not ViewId.BODY_BACK)
    if shown is None and visibility.any():
        face = frontal_face_behind_hair(photo, pose_px, labels) or face
    probability = np.round(np.clip(mask, 0.0, 1.0) * 255).astype(np.uint8)
    return Figure(pose_px, visibility, probability, mask > 0.5, labels, face, looks.seen_px, looks.naked_px)


def merge_masks(posed: NDArray[np.float32], labelled: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the person's probability (H, W) in a face photo, from the selfie net's mask and the label net's."""
    first, second = (np.clip(each, 0.01, 0.99) for each in (posed, labelled))
    odds = (1.0 - LABELLED) * np.log(first / (1.0 - first)) + LABELLED * np.log(second / (1.0 - second))
    return np.asarray(1.0 / (1.0 + np.exp(-odds)), np.float32)


def veto_by_labels(posed: NDArray[np.float32], labelled: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the person's probability (H, W) in a body photo: the pose net's, one half where the label net is sure of
    the opposite.

    Either takes what stands behind a limb for a part of it now and then, seldom both; the photo's colours decide there.
    """
    denied = np.where(posed > 0.5, labelled < DENIED, labelled > 1.0 - DENIED)
    return np.where(denied, np.float32(0.5), posed)


def find_hidden_figure(photo: Photo) -> Figure | None:
    """Return a portrait without a detected body or face as the label net sees it, None where that falls apart.

    Its pose is unknown: all points lie in the mask's middle and none is visible.
    """
    mask = _label_mask(photo)
    if not _is_whole(mask) or not is_cut_below(mask.astype(np.float64)):
        return None
    rows, columns = np.nonzero(mask > 0.5)
    pose = np.tile(np.array([columns.mean(), rows.mean()]), (33, 1))
    face = frontal_face(photo)
    looks = _label_person(photo, mask, pose, face)
    return _figure(photo, pose, np.zeros(33), mask, face, looks, looks.person(mask.shape))


def _label_mask(photo: Photo) -> NDArray[np.float32]:
    """Return the person's probability (H, W) by the label net: in the whole photo, then around whom it saw there.

    The second look finds the head of somebody who stands small in the photo.
    """
    seen = np.ones(photo.rgb.shape[:2], np.bool_)
    features = DETECTORS.get("label_features")
    rough = label_evidence(photo.rgb, seen, photo.view, features).rough_person(seen.shape) > 0.5
    if rough.any():
        seen = largest_piece(rough)
    return label_evidence(photo.rgb, seen, photo.view, features).person(seen.shape)


def standing_mask(photo: Photo) -> NDArray[np.bool_] | None:
    """Return the standing person's probability (H, W) by the label net in a body photo, None where it sees none."""
    mask = _label_mask(photo)
    inside = np.asarray(mask > 0.5, np.bool_)
    return inside if _is_whole(mask) and not is_cut_below(mask.astype(np.float64)) and _is_standing(inside) else None


def _is_whole(mask: NDArray[np.float32]) -> bool:
    """Return whether a probability (H, W) is a whole person's: large enough, with a sharp boundary."""
    person, unsure = float((mask > 0.5).mean()), float(((mask > 0.1) & (mask < 0.9)).mean())
    return person >= LEAST_PERSON and unsure <= MOST_UNSURE * person


def _is_standing(inside: NDArray[np.bool_]) -> bool:
    rows, columns = (np.ptp(np.flatnonzero(inside.any(axis=axis))) for axis in (1, 0))
    return bool(rows > UPRIGHT * columns)
