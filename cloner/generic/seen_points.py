"""Joints and skin points that the label net sees under clothes, and their positions on the generic human."""

from __future__ import annotations

from typing import Final

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.proposals import Proposal

#: What each number is and where it comes from: ``cloner/calibration/generic.toml``.
_CALIBRATED: Final = calibrated("generic.seen_points")

#: Joints and features of the generic human, in the order of the net's maps (``build/label_crops.py``).
NAMES: Final = (
    *(f"{side}_{joint}" for joint in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle") for side in "lr"),
    "acromion_L", "acromion_R", "neck_base_L", "neck_base_R",
    "crotch", "nape", "neck_front_base", "vertex_top", "chin_bottom",
)  # fmt: skip
#: Rows of the ankles.
ANKLES: Final = [NAMES.index(f"{side}_ankle") for side in "lr"]
#: Rows of a pose (BlazePose) of the first twelve.
POSE_ROWS: Final = [11, 12, 13, 14, 15, 16, 23, 24, 25, 26, 27, 28]
#: How names tell the person's sides.
_MARKS: Final = {"left": ("l_", "_L"), "right": ("r_", "_R")}
#: Expected errors by side and kind of point.
SPREADS: Final = {side: _CALIBRATED.table(f"spread_{side}", "share") for side in ("front", "back", "near", "far")}
#: Rows of a point on the left and of its twin on the right.
PAIRS: Final = tuple((row, row + 1) for row in range(0, 16, 2))


def visible_aspect(own: str, side_shown: str) -> str:
    """Return the aspect of a point in a photo: "front", "back", or "near" or "far" of the body in a side photo.

    Parameters
    ----------
    own : str
        The person's side that the point lies on: "left", "right", or "" for the middle.
    side_shown : str
        "front", "back", "left" or "right": the person's side that the camera sees.
    """
    if side_shown in ("front", "back"):
        return side_shown
    return "near" if own in ("", side_shown) else "far"


def kind_and_aspect(name: str, side_shown: str) -> tuple[str, str]:
    """Return a point's kind, the same for left and right, and its aspect in a photo.

    Parameters
    ----------
    name : str
        One of `NAMES`.
    side_shown : str
        As for :func:`visible_aspect`.

    Returns
    -------
    kind : str
    side : str
        As :func:`visible_aspect` gives it.
    """
    own = next((side for side, marks in _MARKS.items() if name.startswith(marks[0]) or name.endswith(marks[1])), "")
    kind = name.removeprefix("l_").removeprefix("r_").removesuffix("_L").removesuffix("_R")
    return kind, visible_aspect(own, side_shown)


def point_sigma(name: str, side_shown: str) -> float:
    """Return a point's standard deviation along one picture axis, share of the stature."""
    kind, side = kind_and_aspect(name, side_shown)
    return SPREADS[side][kind]


def combined_pose(proposal: Proposal) -> tuple[Array, Array]:
    """Return a photo's pose (33, 2) px and its visibility (33,), with the joints that are seen under clothes.

    What the body hides in a side photo, its far side, is as visible as the pose says.
    """
    pose, visibility = proposal.pose_px.copy(), proposal.pose_visibility.copy()
    if len(proposal.seen_px):
        pose[POSE_ROWS] = proposal.seen_px[: len(POSE_ROWS)]
        sides = [POSE_ROWS[0::2], POSE_ROWS[1::2]]
        if proposal.view is ViewId.BODY_SIDE:
            sides = [max(sides, key=lambda rows: float(proposal.pose_visibility[rows].sum()))]
        for rows in sides:
            visibility[rows] = 1.0
    return pose, visibility
