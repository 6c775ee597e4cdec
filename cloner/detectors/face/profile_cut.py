"""Removal of wall from the mask before a side face: a wall of skin's colour can join nose and lips.

Where the mask stands out before the fitted profile, and what stands out has the colours of the wall
around rather than of the face behind, it is cut away. Hair, beards and glasses have other colours than the wall.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.face_side import WRONG, side_face_of
from cloner.detectors.face.profile_fit import FittedProfile
from cloner.detectors.face.profile_search import ProfileModel, curve_normals
from cloner.records.photos import Photo
from cloner.records.proposals import PERSON_LEVEL, Proposal

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.profile_cut")

Bools = NDArray[np.bool_]
Picture = NDArray[np.uint8]

_DOUBTED_M: Final = _CALIBRATED.number("doubted_m", "m")
_ENDS_M: Final = _CALIBRATED.number("ends_m", "m")
_LOOKED_M: Final = _CALIBRATED.number("looked_m", "m")
_STEP_M: Final = _CALIBRATED.number("step_m", "m")
_NEAR_M: Final = _CALIBRATED.number("near_m", "m")
_ALIKE: Final = _CALIBRATED.number("alike", "lab")
_WALL_SHARE: Final = _CALIBRATED.number("wall_share", "share")
#: Pixels of wall and face that are compared, and the fewest that tell anything (taste).
_SAMPLES: Final = 1500
_LEAST_PX: Final = 20


def without_wall_before_face(photo: Photo, proposal: Proposal) -> Proposal:
    """Return the proposal of a side photo of the face without wall in its mask before the face.

    Parameters
    ----------
    photo : Photo
    proposal : Proposal
        Of the same photo.
    """
    model = load_face_net().profile
    found = side_face_of(proposal)
    if found is None or found.fitted.cost > WRONG:  # it may lie anywhere
        return proposal
    wall = wall_before_profile(photo.rgb, proposal.mask, model, found.fitted)
    if not wall.any():
        return proposal
    return replace(
        proposal,
        mask=np.where(wall, np.uint8(0), proposal.mask),
        labels=np.where(wall, np.uint8(0), proposal.labels),
    )


def wall_before_profile(rgb: Picture, mask: Picture, model: ProfileModel, fitted: FittedProfile) -> Bools:
    """Return the pixels (H, W) of a person's mask that are wall before a fitted profile.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) uint8
        Probability of the person, 0..255.
    model, fitted
        The profile and how it lies on the mask.
    """
    person = mask > PERSON_LEVEL
    doubted, face = _suspect_pixels(person, model, fitted)
    wall = np.zeros(mask.shape, bool)
    if not doubted.any():
        return wall
    border, reach = (max(1, round(length * fitted.size)) for length in (_DOUBTED_M, _NEAR_M))
    deep = cv2.erode(face.astype(np.uint8), _square(border)) > 0
    lab = cv2.cvtColor(cv2.GaussianBlur(rgb, (0, 0), 1.5), cv2.COLOR_RGB2LAB).astype(np.float32)
    count, pieces, stats, _ = cv2.connectedComponentsWithStats(doubted.astype(np.uint8), connectivity=8)
    for piece in range(1, count):
        left, top, width, height = stats[piece, :4].tolist()
        window = np.s_[max(top - reach, 0) : top + height + reach, max(left - reach, 0) : left + width + reach]
        wall[window] |= _wall_in(lab[window], pieces[window] == piece, person[window], deep[window], reach)
    return wall


def _wall_in(lab: NDArray[np.float32], own: Bools, person: Bools, deep: Bools, reach: int) -> Bools:
    """Return the wall (h, w) that a suspect piece (h, w) belongs to; nothing where it is no wall.

    The profile lies within a millimetre or two only, so wall also goes from beside it, up to ``deep`` in the face.
    """
    near = cv2.dilate(own.astype(np.uint8), _square(reach)) > 0
    wall, face, open_ = near & ~person, near & deep, near & person & ~deep
    if min(wall.sum(), face.sum()) < _LEAST_PX:
        return np.zeros_like(own)
    gaps = [cKDTree(lab[some][:: max(int(some.sum()) // _SAMPLES, 1)]).query(lab[open_])[0] for some in (wall, face)]
    like = np.zeros(own.shape, np.uint8)
    like[open_] = (gaps[0] < gaps[1]) & (gaps[0] < _ALIKE)
    if like[own].mean() < _WALL_SHARE:
        return np.zeros_like(own)
    _, pieces = cv2.connectedComponents(like | own.astype(np.uint8), connectivity=8)
    return np.asarray(np.isin(pieces, np.unique(pieces[own])))


def _square(reach: int) -> Picture:
    return np.ones((2 * reach + 1, 2 * reach + 1), np.uint8)


def _suspect_pixels(person: Bools, model: ProfileModel, fitted: FittedProfile) -> tuple[Bools, Bools]:
    """Return the pixels (H, W) of the person in runs that stand far out before the profile, and those behind it."""
    shape = model.shape(fitted.weights)[: model.samples]
    linear = fitted.px_from_m[:, :2]
    curve = fitted.curve_px(model)
    outwards = curve_normals(shape) @ linear.T / fitted.size
    steps = np.arange(0.0, _LOOKED_M, _STEP_M)
    places = np.rint(curve[:, None] + fitted.size * steps[None, :, None] * outwards[:, None]).astype(np.intp)
    limit = np.array(person.shape[::-1]) - 1
    column, row = np.moveaxis(np.clip(places, 0, limit), 2, 0)
    ahead = _STEP_M * np.cumprod(person[row, column], axis=1).sum(axis=1)
    stretches = _hysteresis_runs(ahead > _ENDS_M, ahead > _DOUBTED_M)
    before = np.zeros(person.shape, np.uint8)
    outer = curve + fitted.size * np.minimum(ahead + _ENDS_M, _LOOKED_M)[:, None] * outwards
    for one in np.flatnonzero(stretches[:-1] & stretches[1:]):
        quad = np.array([curve[one], curve[one + 1], outer[one + 1], outer[one]])
        cv2.fillConvexPoly(before, np.rint(quad).astype(np.int32), 1)
    behind_m = shape - np.array([0.08, 0.0])  # 8 cm: safely inside the head
    face = np.zeros(person.shape, np.uint8)
    closed = np.vstack([curve, behind_m[::-1] @ linear.T + fitted.px_from_m[:, 2]])
    cv2.fillPoly(face, [np.rint(closed).astype(np.int32)], 1)
    return (before > 0) & person & (face == 0), face > 0


def _hysteresis_runs(weak: Bools, strong: Bools) -> Bools:
    """Return the runs (M,) of weak samples that contain a strong one."""
    _, run = cv2.connectedComponents(weak.astype(np.uint8)[None], connectivity=4)
    return np.asarray(weak & np.isin(run[0], run[0][strong & weak]))
