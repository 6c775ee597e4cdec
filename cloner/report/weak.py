"""Weaknesses of a clone that come from its photos, in plain words."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Final

import numpy as np

from cloner.frames import ViewId
from cloner.labels.states import State, read_states
from cloner.records.photos import Photo, PhotoSet
from cloner.records.proposals import Proposal, Proposals
from cloner.report.agreement import PhotoAgreement
from cloner.vision.retouching.open_mouth import open_lip_borders

#: Face-mesh points: outer eye corners, inner edges of the lips, mouth corners (numbering of Google's face mesh).
_EYES: Final = (33, 263)
#: Fewer pixels between the outer eye corners give a visibly soft face (taste; the sample visitors have 330).
LEAST_EYES_PX: Final = 120.0
#: Channels of a pixel that differ by no more are one grey; JPEG's own colour noise is smaller on grey pictures.
GREY_LEVELS: Final = 6
#: A body view below this overlap looks wrong to the eye (the bar for the hard sample set is 0.90).
LEAST_OVERLAP: Final = 0.90
#: The same above the chin: hair and hats are drawn roughly (9 generated people: 0.84 to 0.98, and 0.39 of a head at
#: half its size).
LEAST_HEAD_OVERLAP: Final = 0.80


def photo_weaknesses(photos: PhotoSet, proposals: Proposals, seen: Mapping[ViewId, PhotoAgreement]) -> tuple[str, ...]:
    """Return sentences about what the photos could not give.

    Parameters
    ----------
    photos : PhotoSet
    proposals : Proposals
    seen : mapping
        How well the finished clone covers the outline in each photo.
    """
    weaknesses: list[str] = []
    for view, photo in photos.photos.items():
        if view in proposals.left_out:
            weaknesses.append(f"{view}: {proposals.left_out[view]}")
        if is_grey(photo):
            weaknesses.append(f"{view}: the photo has no colours, so what only it shows stays grey")
    if not {ViewId.FACE_SIDE, ViewId.BODY_SIDE, ViewId.BODY_BACK} & set(photos.photos):
        weaknesses.append("No photo shows the head from the side or behind: the hair there is a guess")
    face = proposals.views.get(ViewId.FACE_FRONT)
    if face is not None and face.face_presence > 0.0:
        weaknesses += _face(face)
        weaknesses += _covered_face(read_states({face.view: face.labels}, face.face_px))
    for view, found in seen.items():
        if view.is_body and found.iou < LEAST_OVERLAP:
            weaknesses.append(f"{view}: the clone covers the person's outline only to {100 * found.iou:.0f} percent")
        if view.is_face and found.iou < LEAST_HEAD_OVERLAP:
            weaknesses.append(f"{view}: the clone covers the head's outline only to {100 * found.iou:.0f} percent")
    return tuple(weaknesses)


def _covered_face(states: frozenset[State]) -> list[str]:
    """Return sentences about what covers the face or the hair."""
    weaknesses = []
    if State.GLASSES in states:
        weaknesses.append(
            f"{ViewId.FACE_FRONT}: the glasses became an object of their own and the skin behind their frame is a "
            "guess; take the face photos without glasses if you can"
        )
    if State.HEADWEAR in states:
        weaknesses.append(
            f"{ViewId.FACE_FRONT}: headwear hides the hair and becomes part of the head; take it off if you can"
        )
    if State.FRINGE in states:
        weaknesses.append(
            f"{ViewId.FACE_FRONT}: hair hides an eye, so what lies behind it is a guess; retake the face photos with "
            "the hair away from the face"
        )
    return weaknesses


def group_warnings(warnings: Iterable[str]) -> tuple[str, ...]:
    """Return warnings once each, in order; those of several photos ("view: text") are merged."""
    views: dict[str, list[str]] = {}
    for warning in warnings:
        view, found, text = warning.partition(": ")
        known = bool(found) and view in set(ViewId)
        named = views.setdefault(text if known else warning, [])
        if known and view not in named:
            named.append(view)
    return tuple(f"{', '.join(named)}: {text}" if named else text for text, named in views.items())


def is_grey(photo: Photo) -> bool:
    """Return whether a photo has no colours."""
    few = photo.rgb[::8, ::8].astype(np.int16)
    return bool(np.ptp(few, axis=2).max() <= GREY_LEVELS)


def _face(proposal: Proposal) -> list[str]:
    """Return what is weak in the face photo."""
    points = proposal.face_px
    eyes = _apart(points, _EYES)
    weaknesses = []
    if eyes < LEAST_EYES_PX:
        weaknesses.append(
            f"The face is small in its photo ({eyes:.0f} pixels between the eyes' corners): it stays soft"
        )
    if open_lip_borders(points) is not None:
        weaknesses.append(
            "The mouth is open in the face photo: the clone's lips are closed, their inner borders a guess"
        )
    return weaknesses


def _apart(points: Any, pair: tuple[int, int]) -> float:
    return float(np.linalg.norm(points[pair[0]] - points[pair[1]]))
