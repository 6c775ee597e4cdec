"""Named points of a face seen from the side."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.profile import front_contour, outline
from cloner.detectors.profile_fit import Laid, find_laid, named_px
from cloner.detectors.profile_search import ProfileModel
from cloner.detectors.results import POSE_NAMES
from cloner.geometry.contour_match import contour_normals
from cloner.records.points import Proposal

Array = NDArray[np.float64]

#: Pose points below this visibility are no hints.
VISIBLE: Final = 0.3
#: Height of the skull's top with some hair over the nose tip, and of the eye over the mouth, metres: first sizes.
_TOP_OVER_NOSE_M: Final = 0.14
_EYE_TO_MOUTH_M: Final = 0.068
#: How far forward the mouth lies of the eye when a head stands upright, radians.
_LEAN: Final = 0.10
#: The nose tip lies within this height of a hinted nose; steps along the outline at which it is tried, metres.
_NOSE_REACH_M: Final = 0.055
_STEP_M: Final = 0.0025
#: Cost of a laid profile at which the hinted direction of the face is doubted and the other tried.
_DOUBTED: Final = 0.28
#: Inter-ocular distance of the mean adult, metres.
IOD_M: Final = 0.063
#: Cost at which every second profile was wrong, and how sharply that turns (painted faces).
_WRONG, _WRONG_TURN = 0.32, 0.025
#: Error of a point on a profile laid wrongly, share of the eye distance.
_WRONG_ERROR: Final = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Hints:
    """Which way a head looks in the picture (+1 right, -1 left), and rough places of a pose net, (2,) px each."""

    facing: int
    nose_px: Array
    eye_px: Array
    mouth_px: Array


@dataclass(frozen=True, slots=True, eq=False)
class SideFace:
    """A profile found in a side photo.

    Attributes
    ----------
    facing : int
        +1 when the person looks to the image's right, -1 to the left.
    outline_px : (N, 4) float64
        The person's outline and its outward normals.
    laid : Laid
    names : tuple of str
        Those of paired points end with the side that is seen.
    points_px : (K, 2) float64
    error_iod : (K,) float64
        Expected distance from the truth, share of the eye distance.
    """

    facing: int
    outline_px: Array
    laid: Laid
    names: tuple[str, ...]
    points_px: Array
    error_iod: Array


def pose_hints(proposal: Proposal) -> Hints | None:
    """Return which way the head looks and rough places of the face, as far as the pose tells."""
    row = {name: index for index, name in enumerate(POSE_NAMES)}
    ears, eyes = [row["ear_l"], row["ear_r"]], [row["eye_l"], row["eye_r"]]
    mouth, nose = [row["mouth_l"], row["mouth_r"]], row["nose"]
    if proposal.pose_visibility[[nose, *eyes, *mouth]].max() < VISIBLE:
        return None
    points = proposal.pose_px
    ahead = float(points[nose, 0] - points[ears, 0].mean())
    hints = Hints(1 if ahead > 0 else -1, points[nose], points[eyes].mean(axis=0), points[mouth].mean(axis=0))
    return hints if np.linalg.norm(hints.mouth_px - hints.eye_px) >= 3.0 else None


def find_side_face(proposal: Proposal, model: ProfileModel) -> SideFace | None:
    """Return the profile of a side photo, or None without an outline.

    The direction that the pose net tells is believed unless the profile fits badly there; then the other is tried too.
    """
    ring = outline(proposal.mask)
    if len(ring) < 50:
        return None
    full = np.hstack([ring, contour_normals(ring)])
    hints = pose_hints(proposal)
    first = 1 if hints is None else hints.facing
    found: list[tuple[int, Laid]] = []
    for facing in (first, -first):
        laid = _lay_facing(proposal.mask, full, model, facing, hints if facing == first else None)
        if laid is not None:
            found.append((facing, laid))
            if hints is not None and laid.cost < _DOUBTED:
                break
    if not found:
        return None
    facing, laid = min(found, key=lambda pair: pair[1].cost)
    points, spread_m = named_px(model, laid)
    wrong = 1.0 / (1.0 + np.exp(-(laid.cost - _WRONG) / _WRONG_TURN))
    # a mean distance in the plane is 1.25 times the spread along one axis
    error = 1.25 * spread_m / IOD_M + wrong * _WRONG_ERROR
    side = "R" if facing > 0 else "L"
    paired = ("eye", "pupil", "ala", "mouth", "ear")
    names = tuple(f"{name}_{side}" if name.startswith(paired) else name for name in model.names)
    return SideFace(facing, full, laid, names, points, error)


def _lay_facing(
    mask: NDArray[np.uint8], full: Array, model: ProfileModel, facing: int, hints: Hints | None
) -> Laid | None:
    """Return the profile laid on the outline when the head looks one way; without hints anywhere along its front."""
    top = float(full[:, 1].min())
    front = front_contour(full, facing, float(full[:, 1].max()) + 1.0)
    if hints is None:
        below = front[front[:, 1] > top + 5.0]
        if len(below) == 0:
            return None
        size = 0.5 * float(np.ptp(full[:, 1])) / (2.0 * _TOP_OVER_NOSE_M)  # a portrait: half of it is the head
        step = max(1, round(2.0 * _STEP_M * size))
        return find_laid(mask, full, model, below[::step, :2], facing=facing, size=size, lean=0.0)
    down = hints.mouth_px - hints.eye_px
    by_face = float(np.linalg.norm(down)) / _EYE_TO_MOUTH_M
    near = front[np.abs(front[:, 1] - hints.nose_px[1]) < _NOSE_REACH_M * by_face]
    if len(near) == 0:
        return _lay_facing(mask, full, model, facing, None)
    tip = near[int(np.argmax(facing * near[:, 0]))]
    size = float(np.sqrt(by_face * max(float(tip[1]) - top, 1.0) / _TOP_OVER_NOSE_M))
    near = front[np.abs(front[:, 1] - hints.nose_px[1]) < _NOSE_REACH_M * size]
    lean = float(np.arctan2(facing * down[0], down[1])) - _LEAN
    step = max(1, int(_STEP_M * size))
    return find_laid(mask, full, model, near[::step, :2], facing=facing, size=size, lean=lean)
