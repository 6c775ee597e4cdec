"""Named points of a face seen from the side."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_fill_holes

from cloner.caching import cached_per_object
from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.profile import front_contour, outline
from cloner.detectors.face.profile_fit import FittedProfile, fit_from_all_starts, named_px
from cloner.detectors.face.profile_judge import FACE_SHARE, features, load_judge
from cloner.detectors.face.profile_search import ProfileModel
from cloner.detectors.nets.results import POSE_NAMES
from cloner.frames import mm_from_m
from cloner.geometry.outlines.contour_match import contour_normals
from cloner.records.arrays import Array
from cloner.records.labels import Label
from cloner.records.proposals import Proposal
from cloner.vision.contours.snake import normals, sample_along_normals, snake_picture
from cloner.vision.segmentation.pieces import box_around, largest_piece

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.face_side")

VISIBLE: Final = _CALIBRATED.number("visible", "score")
_TOP_OVER_NOSE_M: Final = _CALIBRATED.number("top_over_nose_m", "m")
_EYE_TO_MOUTH_M: Final = _CALIBRATED.number("eye_to_mouth_m", "m")
_LEAN: Final = _CALIBRATED.number("lean", "rad")
_NOSE_REACH_M: Final = _CALIBRATED.number("nose_reach_m", "m")
_STEP_M: Final = _CALIBRATED.number("step_m", "m")
_DOUBTED: Final = _CALIBRATED.number("doubted", "log odds")
_EDGE_LEVELS: Final = _CALIBRATED.number("edge_levels", "grey")
_UNIT_PX: Final = _CALIBRATED.number("unit_px", "px")
_EDGE_REACH_M: Final = _CALIBRATED.number("edge_reach_m", "m")
_EDGE_SHARE: Final = _CALIBRATED.number("edge_share", "share")
_STRETCHES: Final = _CALIBRATED.numbers("stretches", "share")
IOD_M: Final = _CALIBRATED.number("iod_m", "m")
WRONG = _CALIBRATED.number("wrong", "cost")
_WRONG_TURN = _CALIBRATED.number("wrong_turn", "cost")
_WRONG_MM: Final = _CALIBRATED.number("wrong_mm", "mm")
_HIDDEN_SHARE: Final = _CALIBRATED.number("hidden_share", "share")
_HIDDEN_ODDS: Final = _CALIBRATED.number("hidden_odds", "log odds")
_WRONG_RATIO: Final = _CALIBRATED.number("wrong_ratio", "log")
WRONG_ERROR: Final = _CALIBRATED.number("wrong_error", "iod")


@dataclass(frozen=True, slots=True, eq=False)
class PoseHints:
    """Direction of a head in the photo (+1 right, -1 left), and rough positions of the pose net, (2,) px each."""

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
    fitted : FittedProfile
    names : tuple of str
        Those of paired points end with the side that is seen.
    points_px : (K, 2) float64
    error_iod : (K,) float64
        Expected distance from the truth, share of the eye distance.
    """

    facing: int
    fitted: FittedProfile
    names: tuple[str, ...]
    points_px: Array
    error_iod: Array


def pose_hints(proposal: Proposal) -> PoseHints | None:
    """Return the head's direction and rough positions of the face, as far as the pose tells."""
    row = {name: index for index, name in enumerate(POSE_NAMES)}
    ears, eyes = [row["ear_l"], row["ear_r"]], [row["eye_l"], row["eye_r"]]
    mouth, nose = [row["mouth_l"], row["mouth_r"]], row["nose"]
    if proposal.pose_visibility[[nose, *eyes, *mouth]].max() < VISIBLE:
        return None
    points = proposal.pose_px
    ahead = float(points[nose, 0] - points[ears, 0].mean())
    hints = PoseHints(1 if ahead > 0 else -1, points[nose], points[eyes].mean(axis=0), points[mouth].mean(axis=0))
    return hints if np.linalg.norm(hints.mouth_px - hints.eye_px) >= 3.0 else None


@cached_per_object
def side_face_of(proposal: Proposal) -> SideFace | None:
    """Return the profile of a side photo with the shipped model."""
    return find_side_face(proposal, load_face_net().profile)


def find_side_face(proposal: Proposal, model: ProfileModel) -> SideFace | None:
    """Return the profile of a side photo, or None without an outline.

    The profile is sought with and without what the head wears, as glasses and caps change its outline; the more likely
    one counts. Where the pose net tells the nose is looked first; unless a profile is sure there, all fronts are tried,
    either way.
    """
    hints = pose_hints(proposal)

    def rate(found: list[tuple[int, FittedProfile]]) -> list[tuple[tuple[float, float], int, FittedProfile]]:
        return [(log_odds_against(proposal, model, hints, facing, fitted), facing, fitted) for facing, fitted in found]

    rated = []
    for mask in _searched_masks(proposal):
        full = whole_outline(mask)
        if full is None:
            continue
        own = rate(align_near_hints(mask, full, model, hints))
        if not own or min(doubt for doubt, *_ in own)[0] > _DOUBTED:
            own += rate(align_anywhere(mask, full, model))
        rated += own
    if not rated:
        return None
    (odds, lost_iod), facing, fitted = min(rated, key=lambda one: one[0])
    points, sigma_m = named_px(model, fitted)
    # a mean distance in the plane is 1.25 times the spread along one axis
    error = 1.25 * sigma_m / IOD_M + lost_iod / (1.0 + np.exp(-odds))
    side = "R" if facing > 0 else "L"
    paired = ("eye", "pupil", "ala", "mouth", "ear")
    names = tuple(f"{name}_{side}" if name.startswith(paired) else name for name in model.names)
    return SideFace(facing, fitted, names, points, error)


def _searched_masks(proposal: Proposal) -> list[NDArray[np.uint8]]:
    """Return the person's probability (H, W) and, if something is worn, its largest piece without accessories."""
    worn = proposal.labels == Label.ACCESSORY
    masks = [proposal.mask]
    if worn.any():
        piece = largest_piece(proposal.person() & ~worn)
        if piece.any():
            box = box_around(piece)
            bare = binary_fill_holes(piece[box])
            masks.append(np.zeros_like(proposal.mask))
            masks[1][box] = np.where(bare, np.maximum(proposal.mask[box], 128), 0)
    return masks


def whole_outline(mask: NDArray[np.uint8]) -> Array | None:
    """Return the outline of a person's probability (H, W) with outward normals, (N, 4) px; None for a speck."""
    ring = outline(mask)
    return np.hstack([ring, contour_normals(ring)]) if len(ring) >= 50 else None


def judge_hints(hints: PoseHints | None) -> tuple[int, Array] | None:
    """Return the hints as the profile judge takes them: the head's direction, and nose, eye and mouth (3, 2), px."""
    return None if hints is None else (hints.facing, np.array([hints.nose_px, hints.eye_px, hints.mouth_px]))


def log_odds_against(
    proposal: Proposal, model: ProfileModel, hints: PoseHints | None, facing: int, fitted: FittedProfile
) -> tuple[float, float]:
    """Return the log odds that a fitted profile is wrong, and its points' sigma in that case, eye distances.

    Without labels the outline alone tells.
    """
    if not proposal.labels.any():
        return (fitted.cost - WRONG) / _WRONG_TURN, WRONG_ERROR
    seen = features(model, fitted, facing, proposal.labels, judge_hints(hints))
    if seen[FACE_SHARE] < _HIDDEN_SHARE:
        return _HIDDEN_ODDS, WRONG_ERROR
    error_mm = load_judge().error_mm(seen)
    lost_iod = min(error_mm / mm_from_m(IOD_M), WRONG_ERROR)
    return float(np.log(error_mm / _WRONG_MM)) / _WRONG_RATIO, lost_iod


def missing_edge_share(rgb: NDArray[np.uint8], model: ProfileModel, fitted: FittedProfile) -> float:
    """Return the share 0..1 of a fitted profile without an image edge: a mask may follow a shadow on the wall.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    model : ProfileModel
    fitted : FittedProfile
    """
    curve = fitted.curve_px(model)
    picture, small_from_photo = snake_picture(rgb, curve, unit_px=IOD_M * fitted.size, unit=_UNIT_PX)
    small = curve @ small_from_photo[:, :2].T + small_from_photo[:, 2]
    reach = _EDGE_REACH_M * fitted.size * float(small_from_photo[0, 0])
    offsets, seen = sample_along_normals(picture, small, normals(small, closed=False), reach)
    slope = np.linalg.norm(np.gradient(seen, offsets[1] - offsets[0], axis=1), axis=2) / np.sqrt(seen.shape[2])
    share = float((slope[:, 2:-2].max(axis=1) > _EDGE_LEVELS).mean())
    return float(np.clip((_EDGE_SHARE - share) / (0.7 * _EDGE_SHARE), 0.0, 1.0))


def align_near_hints(
    mask: NDArray[np.uint8], full: Array, model: ProfileModel, hints: PoseHints | None
) -> list[tuple[int, FittedProfile]]:
    """Return profiles fitted to the outline (N, 4) near a hinted nose, and their directions; none without hints."""
    if hints is None:
        return []
    top = float(full[:, 1].min())
    front = front_contour(full, hints.facing, float(full[:, 1].max()) + 1.0)
    down = hints.mouth_px - hints.eye_px
    by_face = float(np.linalg.norm(down)) / _EYE_TO_MOUTH_M
    near = front[np.abs(front[:, 1] - hints.nose_px[1]) < _NOSE_REACH_M * by_face]
    if len(near) == 0:
        return []
    tip = near[int(np.argmax(hints.facing * near[:, 0]))]
    size = float(np.sqrt(by_face * max(float(tip[1]) - top, 1.0) / _TOP_OVER_NOSE_M))
    near = front[np.abs(front[:, 1] - hints.nose_px[1]) < _NOSE_REACH_M * size]
    lean = float(np.arctan2(hints.facing * down[0], down[1])) - _LEAN
    step = max(1, int(_STEP_M * size))
    found = fit_from_all_starts(mask, full, model, near[::step, :2], facing=hints.facing, size=size, lean=lean)
    return [(hints.facing, fitted) for fitted in found]


def align_anywhere(mask: NDArray[np.uint8], full: Array, model: ProfileModel) -> list[tuple[int, FittedProfile]]:
    """Return profiles fitted along both fronts of an outline (N, 4), by ranges of heights, and their directions.

    How far a nose lies below the head's top tells the head's size, so each stretch has a size of its own.
    """
    top, height = float(full[:, 1].min()), float(np.ptp(full[:, 1]))
    out = []
    fronts = {facing: front_contour(full, facing, float(full[:, 1].max()) + 1.0) for facing in (1, -1)}
    for (facing, front), (low, high) in itertools.product(fronts.items(), itertools.pairwise(_STRETCHES)):
        noses = front[(front[:, 1] > top + low * height) & (front[:, 1] <= top + high * height), :2]
        size = 0.5 * (low + high) * height / _TOP_OVER_NOSE_M
        step = max(1, round(2.0 * _STEP_M * size))
        found = fit_from_all_starts(mask, full, model, noses[::step], facing=facing, size=size, lean=0.0)
        out += [(facing, fitted) for fitted in found]
    return out
