"""What nets and colours say about each photo: pose, face, mask, skin and hair.

Runs once a photo; corrections never run it again.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.abreast import in_two_steps
from cloner.detectors.profile_cut import free_profile
from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.labels.photo import label_photo
from cloner.labels.states import stands_barefoot
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import Proposal, Proposals
from cloner.records.results import StageResult
from cloner.vision.masks import refine_mask

#: A face-mesh presence below this is no face (the net's own score, measured on the sample visitors: 1.0).
FACE_PRESENCE = 0.5
#: A photo in which less than this share of pixels is the person is refused.
LEAST_PERSON = 0.01


def check_people(photo: Photo) -> None:
    """Refuse photos without exactly one person.

    Raises
    ------
    ClonerError
        If nobody, or more than one person, is found.
    """
    people = DETECTORS.get("people")(photo.rgb)
    if not people:
        raise ClonerError("no person found in this photo", "Take it again with one person in full view", photo.name)
    if len(people) > 1:
        raise ClonerError(
            f"{len(people)} people found in this photo", "Take it again with one person alone in view", photo.name
        )


def face_in(photo: Photo) -> tuple[NDArray[np.float64], NDArray[np.float64], float, NDArray[np.float64]]:
    """Return (468, 2) points, (468,) depths, all pixels, presence and (2, 2) irises of a face; zeros without one."""
    if photo.view in (ViewId.FACE_FRONT, ViewId.BODY_FRONT):
        face = DETECTORS.get("face")(photo.rgb)
        if face is not None and face.presence >= FACE_PRESENCE:
            points = DETECTORS.get("refined_face")(photo.rgb, face.points_px, face.irises_px)
            return points, np.asarray(face.depth_px, dtype=np.float64), float(face.presence), face.irises_px
    return np.zeros((468, 2)), np.zeros(468), 0.0, np.zeros((2, 2))


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """Where the person is in a photo.

    Attributes
    ----------
    pose_px : (33, 2)
    visibility : (33,)
    probability : (H, W) uint8, 0..255
    inside : (H, W) bool
    """

    pose_px: NDArray[np.float64]
    visibility: NDArray[np.float64]
    probability: NDArray[np.uint8]
    inside: NDArray[np.bool_]


def find_figure(photo: Photo) -> Figure:
    """Return pose and mask of one photo.

    Raises
    ------
    ClonerError
        If the photo does not show exactly one person.
    """
    check_people(photo)
    pose = DETECTORS.get("pose")(photo.rgb)
    if pose is None:
        raise ClonerError("no person found in this photo", "Take it again with one person in full view", photo.name)
    mask = refine_mask(photo.rgb, pose.mask, pose.points_px if photo.view.is_body else None)
    if float((mask > 0.5).mean()) < LEAST_PERSON:
        raise ClonerError("no person found in this photo", "Take it again with one person in full view", photo.name)
    probability = np.round(np.clip(mask, 0.0, 1.0) * 255).astype(np.uint8)
    return Figure(pose.points_px, np.asarray(pose.visibility, dtype=np.float64), probability, mask > 0.5)


def propose_within(photo: Photo, figure: Figure) -> Proposal:
    """Return pose, face, mask and labels of one photo whose person is found."""
    points, depth, presence, irises = face_in(photo)
    shown = points if presence > 0.0 else None
    labels, _ = label_photo(
        photo.rgb,
        figure.inside,
        photo.view,
        DETECTORS.get("label_features"),
        face_points=shown,
        pose_points=figure.pose_px,
    )
    found = Proposal(
        photo.view,
        figure.pose_px,
        figure.visibility,
        points,
        depth,
        presence,
        figure.probability,
        labels,
        photo.view.is_body and barefoot(figure, labels),
        irises,
    )
    return free_profile(photo, found) if photo.view is ViewId.FACE_SIDE else found


def propose(photo: Photo) -> Proposal:
    """Return pose, face, mask and labels of one photo.

    Raises
    ------
    ClonerError
        If the photo does not show exactly one person.
    """
    return propose_within(photo, find_figure(photo))


def barefoot(figure: Figure, labels: NDArray[np.uint8]) -> bool:
    """Return whether a body photo shows bare feet, looking halfway between heels and toes."""
    feet = (figure.pose_px[29:31] + figure.pose_px[31:33]) / 2
    height = float(np.ptp(np.flatnonzero(figure.inside.any(axis=1))))
    return stands_barefoot(labels, feet, 0.008 * height)


def run(*, photos: PhotoSet, tick: Callable[[float], None], rng: np.random.Generator) -> StageResult:
    """Give one proposal a photo."""
    views: dict[ViewId, Proposal] = {}
    proposed = in_two_steps(find_figure, propose_within, photos.photos.values())
    for view, proposal in zip(photos.photos, proposed, strict=True):
        views[view] = proposal
        tick(len(views) / len(photos.photos))
    DETECTORS.get("let_nets_go")()  # no later stage asks them
    return StageResult({"proposals": Proposals(views)})
