"""Named feature points of the face: by calibrated rules from the net in front, by the profile at the side."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.face_net import load_face_net
from cloner.detectors.profile import Hints, find_profile
from cloner.detectors.results import POSE_NAMES
from cloner.frames import ViewId
from cloner.records.photos import Photo
from cloner.records.points import Proposal, ViewPoints

Array = NDArray[np.float64]

#: Error of a rule (share of the eye distance) at which the confidence has fallen to 1/e.
LOOSE_RULE_IOD = 0.10
#: Error of the laid-on profile at which the confidence has fallen to 1/e, metres.
LOOSE_PROFILE_M = 0.0025
#: How well each profile point is defined by the outline alone (measured on the sample visitors, both sets: nose tip
#: within 1.5 mm, nasion and subnasale 3, lips 3-5, chin_front 10 along the chin, where it is flat).
PROFILE_CONFIDENCE = {
    "glabella": 0.3, "nasion": 0.6, "nose_tip": 0.95, "subnasale": 0.7, "lip_top": 0.6, "stomion": 0.6,
    "lip_bottom": 0.5, "chin_front": 0.4, "chin_bottom": 0.5,
}  # fmt: skip
#: Pose points below this visibility are no hints.
VISIBLE = 0.3


def propose_face_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    """Return the named face points of a front or side photo, with a confidence each.

    Parameters
    ----------
    photo : Photo
    proposal : Proposal
        The nets' points and mask of the same photo.

    Returns
    -------
    ViewPoints
        Without points where no face was found.
    """
    if photo.view in (ViewId.FACE_SIDE, ViewId.BODY_SIDE):
        return _side_points(photo, proposal)
    return _front_points(photo, proposal)


def _none(view: ViewId) -> ViewPoints:
    return ViewPoints(view, (), np.zeros((0, 2)), np.zeros(0), np.zeros(0, dtype=bool))


def _front_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    if proposal.face_presence < 0.5:
        return _none(photo.view)
    net = load_face_net()
    points = net.rules @ proposal.face_px
    confidence = proposal.face_presence * np.exp(-net.rule_error / LOOSE_RULE_IOD)
    return ViewPoints(photo.view, net.names, points, np.clip(confidence, 0.0, 1.0), np.zeros(len(points), dtype=bool))


def pose_hints(proposal: Proposal) -> tuple[int | None, Hints | None]:
    """Return which way the head looks (+1 image right, -1 left) and rough face places, as far as the pose tells."""
    row = {name: index for index, name in enumerate(POSE_NAMES)}
    ears, eyes = [row["ear_l"], row["ear_r"]], [row["eye_l"], row["eye_r"]]
    mouth, nose = [row["mouth_l"], row["mouth_r"]], row["nose"]
    if proposal.pose_visibility[[nose, *eyes, *mouth]].max() < VISIBLE:
        return None, None
    points = proposal.pose_px
    ahead = float(points[nose, 0] - points[ears, 0].mean())
    hints = Hints(points[nose], points[eyes].mean(axis=0), points[mouth].mean(axis=0))
    if np.linalg.norm(hints.mouth_px - hints.eye_px) < 3.0:
        return None, None
    return (1 if ahead > 0 else -1), hints


def _side_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    facing, hints = pose_hints(proposal)
    profile = find_profile(proposal.mask, load_face_net().template, facing=facing, hints=hints)
    if profile is None:
        return _none(photo.view)
    fit = float(np.exp(-profile.error_m / LOOSE_PROFILE_M))
    confidence = np.array([PROFILE_CONFIDENCE[name] for name in profile.names]) * fit
    return ViewPoints(
        photo.view, profile.names, profile.points_px, confidence, np.zeros(len(profile.names), dtype=bool)
    )
