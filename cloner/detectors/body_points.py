"""Outline feature points of the body: pose joints say where to look, the mask where the outline is."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.points import Proposal, ViewPoints

Array = NDArray[np.float64]

#: BlazePose rows that stand for H-Anim joint centres.
POSE_JOINTS = {
    "l_shoulder": 11,
    "r_shoulder": 12,
    "l_elbow": 13,
    "r_elbow": 14,
    "l_wrist": 15,
    "r_wrist": 16,
    "l_hip": 23,
    "r_hip": 24,
    "l_knee": 25,
    "r_knee": 26,
    "l_ankle": 27,
    "r_ankle": 28,
}
#: BlazePose rows that stand for surface features of head and feet.
POSE_FEATURES = {
    "nose_tip": 0,
    "ear_outer_L": 7,
    "ear_outer_R": 8,
    "pupil_L": 2,
    "pupil_R": 5,
    "heel_left": 29,
    "heel_right": 30,
    "toe_left": 31,
    "toe_right": 32,
}
_LEFT_EAR, _RIGHT_EAR = 7, 8


class _Outline:
    """Walks over one binary mask."""

    def __init__(self, mask: NDArray[np.bool_]) -> None:
        self.mask = mask
        rows = np.flatnonzero(mask.any(axis=1))
        self.top, self.bottom = int(rows[0]), int(rows[-1])
        self.height = self.bottom - self.top + 1

    def inside(self, point: Array) -> bool:
        column, row = round(float(point[0])), round(float(point[1]))
        height, width = self.mask.shape
        return 0 <= row < height and 0 <= column < width and bool(self.mask[row, column])

    def walk(self, start: Array, direction: Array, reach: float) -> Array | None:
        """Return the last inside point from ``start`` along ``direction``, None if there is no border."""
        unit = direction / max(float(np.linalg.norm(direction)), 1e-9)
        steps = np.arange(0.0, reach * self.height, 0.5)
        path = start + steps[:, None] * unit
        column = np.clip(np.round(path[:, 0]).astype(int), 0, self.mask.shape[1] - 1)
        row = np.clip(np.round(path[:, 1]).astype(int), 0, self.mask.shape[0] - 1)
        outside = np.flatnonzero(~self.mask[row, column])
        if len(outside) == 0 or outside[0] == 0:
            return None
        return np.asarray(path[outside[0] - 1], dtype=np.float64)

    def run(self, row: float, column: float) -> tuple[float, float] | None:
        """Return the first and last column of the mask's run through a pixel."""
        line = self.mask[int(np.clip(round(row), 0, self.mask.shape[0] - 1))]
        at = int(np.clip(round(column), 0, len(line) - 1))
        if not line[at]:
            filled = np.flatnonzero(line)
            if len(filled) == 0:
                return None
            at = int(filled[np.argmin(np.abs(filled - at))])
            if abs(at - column) > 0.05 * self.height:
                return None
        left = at - int(np.argmin(line[at::-1])) + 1 if not line[: at + 1].all() else 0
        right = at + int(np.argmin(line[at:])) - 1 if not line[at:].all() else len(line) - 1
        return float(left), float(right)


def propose_body_points(proposal: Proposal) -> ViewPoints:
    """Return the named body points of one photo.

    Joint centres carry their H-Anim names, outline points the names of the
    generic human's features (method §3). Points that cannot be found are absent.

    Parameters
    ----------
    proposal : Proposal
        Pose and mask of a body photo.
    """
    found: dict[str, tuple[Array, float]] = {}
    visible = proposal.pose_visibility
    far = ""
    if proposal.view is ViewId.BODY_SIDE:
        far = "l" if looks_right(proposal.pose_px) else "r"
    for name, row in POSE_JOINTS.items():
        if name[0] != far:  # the net guesses hidden limbs, and guesses them turned
            found[name] = (proposal.pose_px[row], (0.45 if far else 0.6) * float(visible[row]))
    for name, row in POSE_FEATURES.items():
        if visible[row] > 0.5 and _is_seen(name, proposal):
            found[name] = (proposal.pose_px[row], 0.8 * float(visible[row]))
    outline = _Outline(proposal.mask > 127)
    if proposal.view is ViewId.BODY_SIDE:
        _side_points(proposal, outline, found)
    else:
        _front_points(proposal, outline, found)
    names = tuple(found)
    return ViewPoints(
        proposal.view,
        names,
        np.array([found[name][0] for name in names]),
        np.array([np.clip(found[name][1], 0.0, 1.0) for name in names]),
        np.zeros(len(names), dtype=bool),
    )


def looks_right(pose_px: Array) -> bool:
    """Whether a person seen from the side looks towards the image's right: nose against ears, toes against heels."""
    head = pose_px[0, 0] - pose_px[[_LEFT_EAR, _RIGHT_EAR], 0].mean()
    feet = pose_px[31:33, 0].mean() - pose_px[29:31, 0].mean()
    return bool(head + 0.5 * feet > 0)


def _is_seen(name: str, proposal: Proposal) -> bool:
    """Whether a feature can be seen at all in this view."""
    if name.startswith(("heel", "toe")):
        far = "left" if looks_right(proposal.pose_px) else "right"
        return proposal.view is not ViewId.BODY_SIDE or not name.endswith(far)
    if proposal.view is ViewId.BODY_BACK:
        return name.startswith("ear")
    if proposal.view is ViewId.BODY_SIDE:
        near = "R" if looks_right(proposal.pose_px) else "L"
        return name in ("nose_tip", f"ear_outer_{near}", f"pupil_{near}")
    return True


def _add(found: dict[str, tuple[Array, float]], name: str, point: Array | None, confidence: float) -> None:
    if point is not None:
        found[name] = (np.asarray(point, dtype=np.float64), confidence)


def _front_points(proposal: Proposal, outline: _Outline, found: dict[str, tuple[Array, float]]) -> None:
    """Add the outline points of a front or back photo."""
    pose = proposal.pose_px
    middle = (pose[11] + pose[12] + pose[23] + pose[24]) / 4
    for side, first in (("left", 0), ("right", 1)):
        shoulder, elbow, wrist = pose[11 + first], pose[13 + first], pose[15 + first]
        hip, knee, ankle = pose[23 + first], pose[25 + first], pose[27 + first]
        outwards = np.array([np.sign(shoulder[0] - middle[0]), 0.0])
        for name, at, along, reach in (
            ("elbow", elbow, wrist - shoulder, 0.08),
            ("wrist", wrist, wrist - elbow, 0.06),
            ("knee", knee, ankle - hip, 0.10),
            ("ankle", ankle, ankle - knee, 0.06),
        ):
            across = np.array([-along[1], along[0]])
            across = across if across @ outwards > 0 else -across
            _add(found, f"{name}_outer_{side}", outline.walk(at, across, reach), 0.7)
            _add(found, f"{name}_inner_{side}", outline.walk(at, -across, reach), 0.7)
        _add(found, f"shoulder_end_{side}", outline.walk(shoulder, outwards + [0.0, -1.0], 0.08), 0.5)
        _add(found, f"armpit_{side}", _armpit(outline, shoulder, elbow, hip), 0.6)
        for name, share in (("waist", 0.62), ("hip", 1.05)):
            level = (pose[11] + pose[12]) / 2 * (1 - share) + (pose[23] + pose[24]) / 2 * share
            run = outline.run(level[1], level[0])
            if run is not None and run[1] - run[0] < 0.35 * outline.height:
                column = run[1] if outwards[0] > 0 else run[0]
                _add(found, f"{name}_{side}", np.array([column, round(level[1])]), 0.6)
    _add(found, "crotch", _crotch(outline, pose), 0.7)
    _neck(proposal, outline, found)
    _ends(outline, pose, found)


def _armpit(outline: _Outline, shoulder: Array, elbow: Array, hip: Array) -> Array | None:
    """Return the top of the background gap between arm and torso."""
    top, bottom = int(shoulder[1]), int(max(elbow[1], shoulder[1] + 2))
    left, right = sorted((elbow[0], hip[0]))
    box = ~outline.mask[top:bottom, int(max(left, 0)) : int(right) + 1]
    rows, columns = np.nonzero(box)
    if len(rows) == 0 or rows[0] == 0:
        return None
    first = rows == rows[0]
    return np.array([columns[first].mean() + int(max(left, 0)), top + rows[0] - 1.0])


def _crotch(outline: _Outline, pose: Array) -> Array | None:
    """Return the top of the background gap between the legs."""
    hips, knees = pose[23:25].mean(axis=0), pose[25:27].mean(axis=0)
    left, right = sorted((pose[23, 0], pose[24, 0]))
    top = int(hips[1])
    box = ~outline.mask[top : int(knees[1]) + int(0.1 * outline.height), int(left) : int(right) + 1]
    rows, columns = np.nonzero(box)
    if len(rows) == 0 or rows[0] == 0:
        return None
    first = rows == rows[0]
    return np.array([columns[first].mean() + int(left), top + rows[0] - 1.0])


def _neck(proposal: Proposal, outline: _Outline, found: dict[str, tuple[Array, float]]) -> None:
    """Add the neck base: where the neck's run widens into the shoulders."""
    pose = proposal.pose_px
    ears, shoulders = (pose[_LEFT_EAR] + pose[_RIGHT_EAR]) / 2, (pose[11] + pose[12]) / 2
    rows = np.arange(round(ears[1] + 0.25 * (shoulders[1] - ears[1])), round(shoulders[1]))
    runs = [outline.run(row, float(np.interp(row, [ears[1], shoulders[1]], [ears[0], shoulders[0]]))) for row in rows]
    widths = np.array([np.inf if run is None else run[1] - run[0] for run in runs])
    if len(widths) < 4 or not np.isfinite(widths).any():
        return
    narrow = int(np.argmin(widths))
    wide = np.flatnonzero(widths[narrow:] > 1.25 * widths[narrow])
    if len(wide) == 0:
        return
    run = runs[narrow + int(wide[0])]
    if run is not None:
        names = ("neck_base_right", "neck_base_left")
        if pose[11, 0] < pose[12, 0]:
            names = names[::-1]
        _add(found, names[0], np.array([run[0], rows[narrow + wide[0]]], dtype=float), 0.6)
        _add(found, names[1], np.array([run[1], rows[narrow + wide[0]]], dtype=float), 0.6)


def _ends(outline: _Outline, pose: Array, found: dict[str, tuple[Array, float]]) -> None:
    """Add head top and the sole below each ankle."""
    columns = np.flatnonzero(outline.mask[outline.top])
    _add(found, "head_top", np.array([columns.mean(), outline.top]), 0.5)
    for side, row in (("left", 27), ("right", 28)):
        reach = int(0.04 * outline.height)
        at = int(np.clip(round(pose[row, 0]), 0, outline.mask.shape[1] - 1))
        strip = outline.mask[:, max(at - reach, 0) : at + reach + 1].any(axis=1)
        _add(
            found,
            f"sole_{side}",
            np.array([pose[row, 0], float(np.flatnonzero(strip)[-1]) if strip.any() else outline.bottom]),
            0.5,
        )


def _side_points(proposal: Proposal, outline: _Outline, found: dict[str, tuple[Array, float]]) -> None:
    """Add the front and back outline points of the side photo by levels along the body."""
    pose = proposal.pose_px
    shoulders, hips = pose[11:13].mean(axis=0), pose[23:25].mean(axis=0)
    knees, ankles = pose[25:27].mean(axis=0), pose[27:29].mean(axis=0)
    ears = pose[7:9].mean(axis=0)
    forward = 1.0 if looks_right(pose) else -1.0
    side = "right" if forward > 0 else "left"
    levels = (
        ("neck_front", "neck_back", shoulders, ears, 0.45),
        ("chest_front", "back", shoulders, hips, 0.30),
        ("belly_front", "waist_back", shoulders, hips, 0.70),
        ("", f"buttock_{side}", shoulders, hips, 1.05),
        (f"thigh_front_{side}", f"thigh_back_{side}", hips, knees, 0.5),
        (f"knee_front_{side}", f"knee_back_{side}", hips, knees, 1.0),
        (f"ankle_front_{side}", f"ankle_back_{side}", knees, ankles, 1.0),
    )
    for front_name, back_name, start, end, share in levels:
        level = start + share * (end - start)
        run = outline.run(level[1], level[0])
        if run is None:
            continue
        front, back = (run[1], run[0]) if forward > 0 else (run[0], run[1])
        if front_name:
            _add(found, front_name, np.array([front, round(level[1])]), 0.6)
        _add(found, back_name, np.array([back, round(level[1])]), 0.6)
    _ends(outline, pose, found)
