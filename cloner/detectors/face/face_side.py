"""Named points of a face seen from the side."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.profile import front_contour, outline
from cloner.detectors.face.profile_fit import Laid, find_laid, named_px
from cloner.detectors.face.profile_search import ProfileModel, normals_of
from cloner.detectors.nets.results import POSE_NAMES
from cloner.geometry.outlines.contour_match import contour_normals
from cloner.records.labels import FACE, shows
from cloner.records.points import Proposal
from cloner.remembered import once_each
from cloner.vision.contours.snake import look_along, normals, snake_picture

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.face_side")

Array = NDArray[np.float64]

VISIBLE: Final = _CALIBRATED.number("visible", "score")
_TOP_OVER_NOSE_M: Final = _CALIBRATED.number("top_over_nose_m", "m")
_EYE_TO_MOUTH_M: Final = _CALIBRATED.number("eye_to_mouth_m", "m")
_LEAN: Final = _CALIBRATED.number("lean", "rad")
_NOSE_REACH_M: Final = _CALIBRATED.number("nose_reach_m", "m")
_STEP_M: Final = _CALIBRATED.number("step_m", "m")
_DOUBTED: Final = _CALIBRATED.number("doubted", "cost")
_EDGE_LEVELS: Final = _CALIBRATED.number("edge_levels", "grey")
_UNIT_PX: Final = _CALIBRATED.number("unit_px", "px")
_EDGE_REACH_M: Final = _CALIBRATED.number("edge_reach_m", "m")
_EDGE_SHARE: Final = _CALIBRATED.number("edge_share", "share")
_STRETCHES: Final = _CALIBRATED.numbers("stretches", "share")
IOD_M: Final = _CALIBRATED.number("iod_m", "m")
WRONG = _CALIBRATED.number("wrong", "cost")
_WRONG_TURN = _CALIBRATED.number("wrong_turn", "cost")
FACE_INSIDE: Final = _CALIBRATED.number("face_inside", "factor")
INSIDE_M: Final = _CALIBRATED.number("inside_m", "m")
WRONG_ERROR: Final = _CALIBRATED.number("wrong_error", "iod")


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


@once_each
def side_face_of(proposal: Proposal) -> SideFace | None:
    """Return the profile of a side photo with the shipped model: its mask is freed by it, its points are told by it."""
    return find_side_face(proposal, load_face_net().profile)


def find_side_face(proposal: Proposal, model: ProfileModel) -> SideFace | None:
    """Return the profile of a side photo, or None without an outline.

    What the pose net tells is believed unless the profile fits badly there; then all fronts are tried, either way.
    A profile has a face on its inner side: a fall of hair may have the same outline.
    """
    ring = outline(proposal.mask)
    if len(ring) < 50:
        return None
    full = np.hstack([ring, contour_normals(ring)])
    hints = pose_hints(proposal)
    found: list[tuple[float, int, Laid]] = []
    if hints is not None:
        near = _lay_near(proposal.mask, full, model, hints)
        found += [] if near is None else [(_cost(near, model, proposal.labels), hints.facing, near)]
    if not found or found[0][0] > _DOUBTED:
        for facing in (1, -1):
            laid_there = _lay_anywhere(proposal.mask, full, model, facing)
            found += [(_cost(laid, model, proposal.labels), facing, laid) for laid in laid_there]
    if not found:
        return None
    cost, facing, laid = min(found, key=lambda one: one[0])
    points, spread_m = named_px(model, laid)
    wrong = 1.0 / (1.0 + np.exp(-(cost - WRONG) / _WRONG_TURN))
    # a mean distance in the plane is 1.25 times the spread along one axis
    error = 1.25 * spread_m / IOD_M + wrong * WRONG_ERROR
    side = "R" if facing > 0 else "L"
    paired = ("eye", "pupil", "ala", "mouth", "ear")
    names = tuple(f"{name}_{side}" if name.startswith(paired) else name for name in model.names)
    return SideFace(facing, full, laid, names, points, error)


def _cost(laid: Laid, model: ProfileModel, labels: NDArray[np.uint8]) -> float:
    """Return a laid profile's cost with what the labels on its inner side say; no labels say nothing."""
    if not labels.any():
        return laid.cost
    inwards = -normals_of(model.shape(laid.weights)[: model.samples]) @ laid.px_from_m[:, :2].T
    column, row = np.rint(laid.curve_px(model) + INSIDE_M * inwards).astype(np.int64).T
    height, width = labels.shape
    within = (column >= 0) & (row >= 0) & (column < width) & (row < height)
    share = float(shows(labels, *FACE)[row[within], column[within]].mean()) if within.any() else 0.0
    return laid.cost + FACE_INSIDE * (0.5 - share)


def doubt_of(rgb: NDArray[np.uint8], model: ProfileModel, laid: Laid) -> float:
    """Return 0..1 how little the photo shows an edge along a laid profile: a mask may follow a shadow on the wall.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    model : ProfileModel
    laid : Laid
    """
    curve = laid.curve_px(model)
    picture, small_from_photo = snake_picture(rgb, curve, unit_px=IOD_M * laid.size, unit=_UNIT_PX)
    small = curve @ small_from_photo[:, :2].T + small_from_photo[:, 2]
    reach = _EDGE_REACH_M * laid.size * float(small_from_photo[0, 0])
    offsets, seen = look_along(picture, small, normals(small, closed=False), reach)
    slope = np.linalg.norm(np.gradient(seen, offsets[1] - offsets[0], axis=1), axis=2) / np.sqrt(seen.shape[2])
    share = float((slope[:, 2:-2].max(axis=1) > _EDGE_LEVELS).mean())
    return float(np.clip((_EDGE_SHARE - share) / (0.7 * _EDGE_SHARE), 0.0, 1.0))


def _lay_near(mask: NDArray[np.uint8], full: Array, model: ProfileModel, hints: Hints) -> Laid | None:
    """Return the profile laid on the outline near a hinted nose, or None where no outline is."""
    top = float(full[:, 1].min())
    front = front_contour(full, hints.facing, float(full[:, 1].max()) + 1.0)
    down = hints.mouth_px - hints.eye_px
    by_face = float(np.linalg.norm(down)) / _EYE_TO_MOUTH_M
    near = front[np.abs(front[:, 1] - hints.nose_px[1]) < _NOSE_REACH_M * by_face]
    if len(near) == 0:
        return None
    tip = near[int(np.argmax(hints.facing * near[:, 0]))]
    size = float(np.sqrt(by_face * max(float(tip[1]) - top, 1.0) / _TOP_OVER_NOSE_M))
    near = front[np.abs(front[:, 1] - hints.nose_px[1]) < _NOSE_REACH_M * size]
    lean = float(np.arctan2(hints.facing * down[0], down[1])) - _LEAN
    step = max(1, int(_STEP_M * size))
    return find_laid(mask, full, model, near[::step, :2], facing=hints.facing, size=size, lean=lean)


def _lay_anywhere(mask: NDArray[np.uint8], full: Array, model: ProfileModel, facing: int) -> list[Laid]:
    """Return profiles laid along the whole front of an outline, one for each stretch of heights.

    How far a nose lies below the head's top tells the head's size, so each stretch has a size of its own.
    """
    top, height = float(full[:, 1].min()), float(np.ptp(full[:, 1]))
    front = front_contour(full, facing, float(full[:, 1].max()) + 1.0)
    out = []
    for low, high in itertools.pairwise(_STRETCHES):
        noses = front[(front[:, 1] > top + low * height) & (front[:, 1] <= top + high * height), :2]
        size = 0.5 * (low + high) * height / _TOP_OVER_NOSE_M
        step = max(1, round(2.0 * _STEP_M * size))
        laid = find_laid(mask, full, model, noses[::step], facing=facing, size=size, lean=0.0)
        out += [] if laid is None else [laid]
    return out
