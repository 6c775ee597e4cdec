"""Does each photo show what its name says? Judged by the pose net's points alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

import numpy as np

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.photos import PhotoSet
from cloner.records.points import Proposal, Proposals

#: Shoulder breadth over body height in the picture: below it nobody stands square to the camera
#: (sample visitors: front and back 0.19-0.22, side 0.01-0.05).
SQUARE_TO_CAMERA: Final = 0.11
#: Where the nose lies between the ears, 0..1 (sample visitors: front 0.38-0.51; profiles below -6 or above 1.6).
FRONTAL: Final = (0.1, 0.9)
PROFILE: Final = (-0.3, 1.3)
#: Distance of the ears over the photo's height below which no close-up is shown (samples: face front 0.23, body 0.06).
CLOSE_UP: Final = 0.10
#: How much surer the net is of the toes than of the heels when a person faces the camera (samples: 0.23-0.49 in front,
#: -0.59 to -0.17 from behind).
TOES_LEAD: Final = 0.1
# BlazePose numbering
_NOSE, _EARS, _SHOULDERS, _KNEES, _ANKLES = 0, (7, 8), (11, 12), (25, 26), (27, 28)
_HEELS, _TOES = (29, 30), (31, 32)
_HINT: Final = "Rename or retake the photos so that each shows what its name says"


def check_photos(proposals: Proposals, photos: PhotoSet) -> None:
    """Refuse photos that were exchanged or that cut the person.

    Raises
    ------
    ClonerError
        If a photo shows another side than its name says, a face photo the whole
        body, or a body photo only a part of it.
    """
    checks: Mapping[ViewId, Callable[[Proposal], str]] = {
        ViewId.FACE_FRONT: _trouble_in_face_front,
        ViewId.FACE_SIDE: _trouble_in_face_side,
    }
    for view, proposal in proposals.views.items():
        trouble = checks.get(view, _trouble_in_body)(proposal)
        if trouble:
            raise ClonerError(trouble, _HINT, photos.photos[view].name)


def _trouble_in_body(proposal: Proposal) -> str:
    """Return what is wrong with a body photo, "" when all is well."""
    pose, view = proposal.pose_px, proposal.view
    height = proposal.mask.shape[0]
    if pose[_KNEES, 1].min() > height:
        return "this photo shows only the upper part of the person, not the whole body"
    if pose[_ANKLES, 1].min() > height:
        return "the feet are outside this photo"
    rows = np.flatnonzero((proposal.mask > 127).any(axis=1))
    tall = max(float(rows[-1] - rows[0]), 1.0) if len(rows) else 1.0
    left, right = pose[_SHOULDERS[0], 0], pose[_SHOULDERS[1], 0]
    square = abs(float(left - right)) / tall > SQUARE_TO_CAMERA
    if view is ViewId.BODY_SIDE and square:
        return "this photo shows the person from the front or back, not from the side"
    if view is not ViewId.BODY_SIDE and not square:
        return f"this photo shows the person from the side, not the {view.value[5:]}"
    if view is ViewId.BODY_FRONT and left < right and proposal.face_presence == 0.0:
        return "this photo shows the person's back, not the front"
    if view is ViewId.BODY_BACK and left > right and _toes_lead(proposal):
        return "this photo shows the person's front, not the back"
    return ""


def _toes_lead(proposal: Proposal) -> bool:
    """Whether the toes are seen better than the heels, as on a person who faces the camera."""
    seen = proposal.pose_visibility
    return bool(seen[[*_TOES]].mean() > seen[[*_HEELS]].mean() + TOES_LEAD)


def _trouble_in_face_front(proposal: Proposal) -> str:
    """Return what is wrong with the front photo of the face, "" when all is well."""
    if _shows_whole_body(proposal) and _ear_distance_px(proposal) < CLOSE_UP * proposal.mask.shape[0]:
        return "this photo shows the whole body, not the face from near"
    place = nose_between_ears(proposal)
    if not PROFILE[0] < place < PROFILE[1]:
        return "this photo shows the face from the side, not from the front"
    if proposal.face_presence == 0.0:
        return "no face can be seen from the front in this photo"
    return ""


def _trouble_in_face_side(proposal: Proposal) -> str:
    """Return what is wrong with the side photo of the face, "" when all is well."""
    if _shows_whole_body(proposal):
        return "this photo shows the whole body, not the face from near"
    if FRONTAL[0] < nose_between_ears(proposal) < FRONTAL[1]:
        return "this photo shows the head from the front or back, not from the side"
    return ""


def nose_between_ears(proposal: Proposal) -> float:
    """Return where the nose lies across the picture: 0 and 1 at the ears, outside on a profile."""
    ears = np.sort(proposal.pose_px[_EARS, 0])
    return float((proposal.pose_px[_NOSE, 0] - ears[0]) / max(ears[1] - ears[0], 1.0))


def _shows_whole_body(proposal: Proposal) -> bool:
    return bool(proposal.pose_px[_ANKLES, 1].max() < proposal.mask.shape[0])


def _ear_distance_px(proposal: Proposal) -> float:
    return float(np.ptp(proposal.pose_px[_EARS, 0]))
