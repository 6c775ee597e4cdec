"""Named points of a side photo: levels from pose and contour together, points on the contour itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.body.front_cues import row_of
from cloner.detectors.body.front_features import MASK_ERROR, MEAN_OF_NORMAL, Found, Placed
from cloner.detectors.body.levels import Levels, infer_levels, load_levels, load_offsets
from cloner.detectors.body.side_cues import BodyProfile, find_body_profile, foot_ends, side_cues
from cloner.detectors.nets import pose_rows as net
from cloner.records.arrays import Array
from cloner.vision.segmentation.outline_walk import SoftMask

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.side_features")


#: Points of the trunk by border: True in front.
MIDDLE: Final = {
    "neck_front": True,
    "neck_back": False,
    "chest_front": True,
    "back": False,
    "belly_front": True,
    "waist_front": True,
    "waist_back": False,
}
#: Points of the near leg by border.
LEG: Final = {
    "buttock": False,
    "thigh_front": True,
    "thigh_back": False,
    "knee_front": True,
    "knee_back": False,
    "calf": False,
    "ankle_back": False,
}
JOINTS: Final = {
    "shoulder": net.SHOULDERS,
    "elbow": net.ELBOWS,
    "wrist": net.WRISTS,
    "hip": net.HIPS,
    "knee": net.KNEES,
    "ankle": net.ANKLES,
}
INSTEP_REACH: Final = _CALIBRATED.number("instep_reach", "figure")
_LEAN: Final = _CALIBRATED.number("lean", "factor")


@dataclass(frozen=True, slots=True, eq=False)
class ProfileFindings:
    """What was found along a person seen from the side: contour, observed levels, and all levels given these."""

    profile: BodyProfile
    cues: Mapping[str, float]
    levels: Levels


def find_from_side(
    figure: SoftMask, pose_px: Array, near: int, forwards: float, hair: NDArray[np.bool_]
) -> ProfileFindings:
    """Return what pose and contour of a side photo show (arguments as in ``find_body_profile``)."""
    profile = find_body_profile(figure, pose_px, near, forwards, hair)
    cues = side_cues(figure, pose_px, profile)
    return ProfileFindings(profile, cues, infer_levels(load_levels("side"), cues))


def profile_points(figure: SoftMask, pose_px: Array, look: ProfileFindings) -> Found:
    """Return the named points of a side photo, the near side's joints too."""
    profile, name = look.profile, net.SIDES[look.profile.near]
    found: Found = {}
    for feature, in_front in (MIDDLE | LEG).items():
        placed = _contour_point(figure, look, feature, in_front=in_front)
        if placed is not None:
            found[feature if feature in MIDDLE else f"{feature}_{name}"] = placed
    instep = _instep(figure, look)
    if instep is not None:
        found[f"ankle_front_{name}"] = instep
    offsets = load_offsets("side")
    for end, point in zip(("toe", "heel"), foot_ends(figure, profile), strict=True):
        if point is not None and "bottom" not in figure.cut:
            offset, left = offsets.of(f"{end}_outline")  # the shoe's end lies before the foot's
            found[f"{end}_{name}"] = point, float(np.linalg.norm(offset)) + left
    for joint, place in profile_joints(figure, pose_px, look).items():
        offset, left = offsets.of(joint)
        found[f"{name[0]}_{joint}"] = place + offset * [profile.forwards, -1.0] * np.array(figure.height_px), left
    return found


def profile_joints(figure: SoftMask, pose_px: Array, look: ProfileFindings) -> dict[str, Array]:
    """Return positions of the near side's joint centres before their mean error is subtracted."""
    places = {}
    for joint, pair in JOINTS.items():
        place = pose_px[pair[look.profile.near]].copy()
        if f"joint_{joint}" in look.levels.level:
            place[1] = row_of(figure, look.levels.level[f"joint_{joint}"])
        places[joint] = place
    return places


def _instep(figure: SoftMask, look: ProfileFindings) -> Placed | None:
    """Return the contour before the ankle, if it is the near foot's."""
    profile, levels = look.profile, look.levels
    row = row_of(figure, levels.level["ankle_front"])
    entry = round(float(np.clip(profile.place(row), 0, len(profile.rows) - 1)))
    ahead = profile.forwards * levels.level["ankle_front_ahead"] * figure.height_px
    place = np.array([profile.strip.centres_px[entry, 0] + ahead, row])
    point = profile.strip.nearest_px(place, far=True, reach_px=INSTEP_REACH * figure.height_px)
    error = MEAN_OF_NORMAL * float(np.hypot(levels.sigma["ankle_front"], levels.sigma["ankle_front_ahead"]))
    return None if point is None else (point, error + MASK_ERROR)


def _contour_point(figure: SoftMask, look: ProfileFindings, name: str, *, in_front: bool) -> Placed | None:
    """Return the contour at a feature's level with its expected error, None where arm or hair covers it."""
    profile = look.profile
    place = profile.place(row_of(figure, look.levels.level[name]))
    entry = round(float(np.clip(place, 0, len(profile.rows) - 1)))
    if (profile.front_arm if in_front else profile.back_arm | profile.back_veiled)[entry]:
        return None
    point = profile.strip.border_px(place, far=in_front)
    if point is None:
        return None
    step = 0.01 * figure.height_px
    ends = [profile.strip.border_px(place + at, far=in_front) for at in (-step, step)]
    lean = [abs(float(end[0] - point[0])) / step for end in ends if end is not None]
    steep = min(float(np.mean(lean)), _LEAN) if lean else _LEAN
    return point, MEAN_OF_NORMAL * look.levels.sigma[name] * float(np.hypot(1.0, steep)) + MASK_ERROR
