"""Conditions in a body photo that make points unreliable, and what the operator can do about them."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.body.front_cues import row_of
from cloner.detectors.body.front_features import Found, SideFindings
from cloner.detectors.body.side_contours import ARM_HALF
from cloner.detectors.nets import pose_rows as net
from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.points import PhotoState, StateKind
from cloner.vision.segmentation.outline_walk import SoftMask

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.photo_states")


_ONE_ANKLE: Final = _CALIBRATED.number("one_ankle", "figure")
_ANKLE_WIDTH: Final = _CALIBRATED.number("ankle_width", "figure")
_GUESSED: Final = _CALIBRATED.number("guessed", "score")
_TURN: Final = _CALIBRATED.triple("turn", "factor")
MOST_TURNED: Final = _CALIBRATED.number("most_turned", "deg")
SHOULDERS_APART: Final = _CALIBRATED.number("shoulders_apart", "figure")
RAISED: Final = _CALIBRATED.number("raised", "share")
#: Names of the joints that the net's levels stand for.
_JOINTS: Final = {"net_shoulder": "shoulder", "net_hip": "hip", "net_knee": "knee", "net_ankle": "ankle"}


def cut_states(figure: SoftMask, view: ViewId) -> list[PhotoState]:
    """Return whether the picture's border cuts the person."""
    if not figure.cut:
        return []
    borders = " and the ".join(figure.cut)
    advice = f"step back until head, hands and feet are in the picture and retake {view}"
    return [PhotoState(StateKind.CUT, "", f"the picture's {borders} border cuts the person; {advice}")]


def turned_degrees(figure: SoftMask, pose_px: Array) -> float:
    """Return how far the person of a front or back photo is turned, degrees, to the image's right positive."""
    toes, heels, ears, shoulders = (
        float(pose_px[list(pair), 0].mean()) for pair in (net.TOES, net.HEELS, net.EARS, net.SHOULDERS)
    )
    ahead = np.array([toes - heels, ears - shoulders, float(pose_px[net.NOSE, 0]) - ears]) / figure.height_px
    return float(np.degrees(np.arcsin(np.clip(ahead @ _TURN, -1.0, 1.0))))


def turned_states(figure: SoftMask, pose_px: Array, view: ViewId) -> list[PhotoState]:
    """Return whether the person is turned away from the view that the photo's name says."""
    if view is ViewId.BODY_SIDE:
        apart = abs(float(pose_px[net.SHOULDERS[0], 0] - pose_px[net.SHOULDERS[1], 0])) / figure.height_px
        advice = f"stand with one shoulder behind the other and retake {view}"
        sentence = f"the person does not stand sideways; {advice}"
        return [PhotoState(StateKind.TURNED, "", sentence, 0.8)] if apart > SHOULDERS_APART else []
    degrees = abs(turned_degrees(figure, pose_px))
    if degrees < MOST_TURNED:
        return []
    away = "from" if view is ViewId.BODY_BACK else "to"
    advice = f"turn chest and feet straight {away} the camera and retake {view}"
    return [PhotoState(StateKind.TURNED, "", f"the person stands turned by about {degrees:.0f} degrees; {advice}", 0.8)]


def front_states(
    figure: SoftMask,
    pose_px: Array,
    visibility: Array,
    looks: tuple[SideFindings, SideFindings],
    found: Found,
    view: ViewId,
) -> list[PhotoState]:
    """Return the unusual conditions of a front or back photo.

    Parameters
    ----------
    figure : Figure
    pose_px, visibility : (33, 2), (33,) float64
    looks : two Look, the person's left and right
    found : the named points
    view : ViewId
    """
    states = cut_states(figure, view) + turned_states(figure, pose_px, view)
    for look in looks:
        states += _arm_states(figure, pose_px, look, found, view)
        states += _rejected_joints(figure, look)
    if "crotch" not in found:
        states.append(_legs_together(figure, looks, view))
    return states + _foot_states(figure, pose_px, visibility, looks, view)


def _arm_states(figure: SoftMask, pose_px: Array, look: SideFindings, found: Found, view: ViewId) -> list[PhotoState]:
    """Return whether an arm touches the trunk, and where its hand is."""
    side = net.SIDES[look.contour.side]
    shoulder, wrist = (float(pose_px[pair[look.contour.side], 1]) for pair in (net.SHOULDERS, net.WRISTS))
    states = []
    if f"armpit_{side}" not in found:
        if _raised(pose_px, look.contour.side):
            return []
        advice = f"hold the arms a little away from the body and retake {view}"
        sentence = f"no background is seen between the {side} arm and the body; {advice}"
        states.append(PhotoState(StateKind.ARM_TOUCHES, side, sentence, rows_px=(shoulder, wrist)))
    elif hand_hidden(figure, pose_px, look):
        sentence = f"the {side} hand lies before the body or in a pocket; let the arms hang beside and retake {view}"
        states.append(PhotoState(StateKind.HAND_HIDDEN, side, sentence, 0.7, rows_px=(wrist, wrist)))
    return states


def _raised(pose_px: Array, side: int) -> bool:
    """Return whether an upper arm is raised so far that the row-wise search cannot find its armpit."""
    upper = pose_px[net.ELBOWS[side]] - pose_px[net.SHOULDERS[side]]
    return bool(upper[1] < RAISED * np.linalg.norm(upper))


def hand_hidden(figure: SoftMask, pose_px: Array, look: SideFindings) -> bool:
    """Return whether a wrist lies on trunk or thighs, with no background between."""
    wrist = pose_px[net.WRISTS[look.contour.side]]
    entry = round(look.contour.place(float(wrist[1])))
    if not 0 <= entry < len(look.contour.rows):
        return False
    strip = look.contour.strip
    aside = (wrist[0] - strip.centres_px[entry, 0]) * look.contour.outwards
    apart = look.contour.arm_gap[entry] > 0.0 or aside > strip.far[entry]
    near_end = len(look.arm.far) - 1
    narrow = look.arm.width[
        round(min(look.arm_levels.level["joint_wrist"], look.arm_share[-1]) * near_end / look.arm_share[-1])
    ]
    return bool(not apart and not narrow < 1.5 * ARM_HALF * figure.height_px)


def _rejected_joints(figure: SoftMask, look: SideFindings) -> list[PhotoState]:
    """Return the net's joints that contradict the rest of the body."""
    side, states = net.SIDES[look.contour.side], []
    for name, joint in _JOINTS.items():
        if name in look.levels.refused:
            sentence = f"the pose net put the {side} {joint} where none can be; its level was taken from the others"
            row = row_of(figure, look.cues[name])
            states.append(PhotoState(StateKind.REFUSED, side, sentence, rows_px=(row, row)))
    return states


def _legs_together(figure: SoftMask, looks: tuple[SideFindings, SideFindings], view: ViewId) -> PhotoState:
    """Return that no gap between the legs shows the crotch."""
    ankle = max(row_of(figure, look.levels.level["joint_ankle"]) for look in looks)
    hip = min(row_of(figure, look.levels.level["joint_hip"]) for look in looks)
    advice = f"stand with the feet a foot's length apart and retake {view}"
    return PhotoState(
        StateKind.LEGS_TOGETHER,
        "",
        f"no background is seen between the thighs, so the crotch is not known; {advice}",
        0.9,
        rows_px=(hip, ankle),
    )


def _foot_states(
    figure: SoftMask, pose_px: Array, visibility: Array, looks: tuple[SideFindings, SideFindings], view: ViewId
) -> list[PhotoState]:
    """Return whether one foot hides the other, or something hides a foot."""
    ankles = pose_px[list(net.ANKLES)]
    entry = round(looks[0].contour.place(float(ankles[:, 1].mean())))
    width = looks[0].contour.strip.width[min(max(entry, 0), len(looks[0].contour.rows) - 1)]
    apart = abs(float(ankles[0, 0] - ankles[1, 0])) / figure.height_px
    advice = f"stand with both feet side by side and retake {view}"
    if apart < _ONE_ANKLE and width < _ANKLE_WIDTH * figure.height_px:
        sentence = f"one foot stands behind the other; {advice}"
        rows = (float(ankles[:, 1].min()), float(figure.bottom_px[1]))
        return [PhotoState(StateKind.FOOT_HIDDEN, "", sentence, 0.8, rows_px=rows)]
    hidden = [side for side, row in zip(net.SIDES, net.ANKLES, strict=True) if visibility[row] < _GUESSED]
    if len(hidden) == 1:
        row = float(ankles[net.SIDES.index(hidden[0]), 1])
        sentence = f"the {hidden[0]} foot is hidden; {advice}"
        return [PhotoState(StateKind.FOOT_HIDDEN, hidden[0], sentence, 0.6, rows_px=(row, row))]
    return []
