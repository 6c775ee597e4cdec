"""Corrections of the pose net: exchanged sides, limbs and misplaced joints.

The net reads a person, and may read a back as a front, or both knees on one leg. What a front photo shows is
known: the person's left lies to the image's right, from behind to its left; each leg's joints lie on its own leg.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.nets import pose_rows as net
from cloner.detectors.nets.results import PoseResult
from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.points import PhotoState, StateKind
from cloner.vision.segmentation.outline_walk import EDGE, SoftMask

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.pose_order")


TIE: Final = _CALIBRATED.number("tie", "figure")
BESIDE: Final = _CALIBRATED.number("beside", "figure")
LEAST_LEG: Final = _CALIBRATED.number("least_leg", "figure")
OFF_LINE: Final = _CALIBRATED.number("off_line", "figure")
#: Which way the person's left lies from the right in the image, along its columns.
_EXPECTED: Final = {ViewId.BODY_FRONT: 1.0, ViewId.BODY_BACK: -1.0}


def corrected_pose(figure: SoftMask, pose_px: Array, view: ViewId) -> tuple[Array, tuple[PhotoState, ...]]:
    """Return the pose with exchanged and misplaced joints corrected, and what was wrong.

    Parameters
    ----------
    figure : Figure
    pose_px : (33, 2) float64
    view : ViewId
        A body view; of the side photo only joints beside the person are put back.
    """
    pose, states = pose_px.copy(), list[PhotoState]()
    if view is not ViewId.BODY_SIDE:
        pose, exchanged = _with_sides_corrected(pose, view, TIE * figure.height_px)
        states += exchanged
        pose, crossed = _joints_on_own_leg(figure, pose)
        states += crossed
    pose, beside = _joints_on_person(figure, pose, view)
    return pose, tuple(states + beside)


def is_mirrored(pose_px: Array, view: ViewId) -> bool:
    """Return whether left and right of a whole pose (33, 2) are exchanged in a front or back photo."""
    return view in _EXPECTED and _left_right_distance(pose_px, (net.SHOULDERS, net.HIPS), _EXPECTED[view]) < 0.0


def mirrored_pose(seen: PoseResult, width: int) -> PoseResult:
    """Return the pose of a photo of some width, given that of its mirror image."""
    points, visibility, presence = (
        _with_pairs_swapped(each, net.TWINS) for each in (seen.points_px, seen.visibility, seen.presence)
    )
    mask = np.ascontiguousarray(seen.mask[:, ::-1])
    return PoseResult(points * (-1.0, 1.0) + (width - 1.0, 0.0), visibility, presence, seen.score, mask)


def pose_by_mirror(
    rgb: NDArray[np.uint8], view: ViewId, pose: PoseResult, net_of: Callable[[NDArray[np.uint8]], PoseResult | None]
) -> PoseResult:
    """Return a pose, or that of the mirror image where left and right are exchanged here and not there.

    A back that is read as a front has more wrong than its sides: elbows lie on the trunk. ``net_of`` reads a photo.
    """
    if not is_mirrored(pose.points_px, view):
        return pose
    mirrored = net_of(np.ascontiguousarray(rgb[:, ::-1]))
    again = pose if mirrored is None else mirrored_pose(mirrored, rgb.shape[1])
    return pose if is_mirrored(again.points_px, view) else again


def _left_right_distance(pose: Array, pairs: Sequence[tuple[int, int]], expected: float) -> float:
    """Return how far left lies on its own side of right, px; negative when exchanged."""
    return expected * float(np.mean([pose[pair[0], 0] - pose[pair[1], 0] for pair in pairs]))


def _with_pairs_swapped(pose: Array, pairs: Sequence[tuple[int, int]]) -> Array:
    rows = np.array(pairs)
    swapped = pose.copy()
    swapped[rows[:, 0]], swapped[rows[:, 1]] = pose[rows[:, 1]], pose[rows[:, 0]]
    return swapped


def _with_sides_corrected(pose: Array, view: ViewId, tie_px: float) -> tuple[Array, list[PhotoState]]:
    """Return the pose with left on the expected side: the whole person, then arms and legs, then single joints."""
    states, expected = [], _EXPECTED[view]
    if is_mirrored(pose, view):
        pose = _with_pairs_swapped(pose, net.TWINS)
        states.append(_swap_state("the whole person"))
    for name, pairs, checked in (
        ("the arms", net.ARM_TWINS, (net.ELBOWS,)),
        ("the legs", net.LEG_TWINS, (net.KNEES, net.ANKLES)),
    ):
        if max(_left_right_distance(pose, (pair,), expected) for pair in checked) < -tie_px:
            pose = _with_pairs_swapped(pose, pairs)
            states.append(_swap_state(name))
    for name, alone in (("the knees", (net.KNEES,)), ("the feet", (net.ANKLES, net.HEELS, net.TOES))):
        if _left_right_distance(pose, alone[:1], expected) < -tie_px:
            pose = _with_pairs_swapped(pose, alone)
            states.append(_swap_state(name))
    return pose, states


def _swap_state(what: str) -> PhotoState:
    return PhotoState(
        StateKind.EXCHANGED, "", f"left and right of {what} were exchanged by the pose net and have been put right"
    )


def _joints_on_own_leg(figure: SoftMask, pose: Array) -> tuple[Array, list[PhotoState]]:
    """Return the pose with a knee or ankle on the other leg moved to the middle of its own."""
    pose, states = pose.copy(), []
    for name, pair in (("knee", net.KNEES), ("ankle", net.ANKLES)):
        for side in (net.LEFT, net.RIGHT):
            row = float(pose[pair[side], 1])
            lines = [_leg_column(pose, which, row, name) for which in (side, 1 - side)]
            runs = _leg_runs(figure, row, lines)
            if runs is None:
                continue
            own, other = runs
            column = float(pose[pair[side], 0])
            if other[0] <= column <= other[1] and abs(column - lines[0]) > OFF_LINE * figure.height_px:
                pose[pair[side], 0] = sum(own) / 2
                states.append(_rejected_state(f"{net.SIDES[side]} {name}", "on the other leg", net.SIDES[side], row))
    return pose, states


def _leg_column(pose: Array, side: int, row: float, joint: str) -> float:
    """Return the column where a leg is expected at a row, from its other joints."""
    hip, ankle = pose[net.HIPS[side]], pose[net.ANKLES[side]]
    foot = (pose[net.HEELS[side]] + pose[net.TOES[side]]) / 2
    start, end = (hip, (ankle + foot) / 2) if joint == "knee" else (hip, foot)
    share = (row - start[1]) / max(float(end[1] - start[1]), 1.0)
    return float(start[0] + np.clip(share, 0.0, 1.2) * (end[0] - start[0]))


def _leg_runs(
    figure: SoftMask, row: float, columns: Sequence[float]
) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """Return the first and last column of the two runs nearest to two columns; None unless they are two."""
    at = round(row)
    if not 0 <= at < len(figure.level):
        return None
    inside = np.concatenate([[False], figure.level[at] > EDGE, [False]])
    steps = np.flatnonzero(inside[1:] != inside[:-1])
    runs = [(float(a), float(b - 1)) for a, b in steps.reshape(-1, 2) if b - a > LEAST_LEG * figure.height_px]
    if len(runs) < 2:
        return None
    chosen = [min(runs, key=lambda run: max(run[0] - column, column - run[1], 0.0)) for column in columns]
    return (chosen[0], chosen[1]) if chosen[0] != chosen[1] else None


def _joints_on_person(figure: SoftMask, pose: Array, view: ViewId) -> tuple[Array, list[PhotoState]]:
    """Return the pose with joints beside the person moved between their neighbours."""
    pose, states = pose.copy(), []
    seen = (net.LEFT, net.RIGHT) if view is not ViewId.BODY_SIDE else ()
    for name, pair, before, after in (
        ("elbow", net.ELBOWS, net.SHOULDERS, net.WRISTS),
        ("wrist", net.WRISTS, net.ELBOWS, net.FINGERS[1]),
        ("knee", net.KNEES, net.HIPS, net.ANKLES),
        ("ankle", net.ANKLES, net.KNEES, net.HEELS),
    ):
        for side in seen:
            point = pose[pair[side]]
            if _near_person(figure, point):
                continue
            between = (pose[before[side]] + pose[after[side]]) / 2
            if figure.inside(between[None])[0]:
                pose[pair[side]] = between
            states.append(
                _rejected_state(f"{net.SIDES[side]} {name}", "beside the person", net.SIDES[side], float(point[1]))
            )
    return pose, states


def _near_person(figure: SoftMask, point: Array) -> bool:
    """Return whether a point lies on or close to the person; points beyond the photo do."""
    height, width = figure.level.shape
    if not (0 <= point[0] < width and 0 <= point[1] < height):
        return True  # a cut limb; told as such
    angles = np.arange(0.0, 2.0 * np.pi, np.pi / 4)
    around = point + BESIDE * figure.height_px * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return bool(figure.inside(np.vstack([point[None], around])).any())


def _rejected_state(joint: str, where: str, side: str, row: float) -> PhotoState:
    return PhotoState(
        StateKind.REFUSED,
        side,
        f"the pose net put the {joint} {where}; its place was taken from the outline instead",
        rows_px=(row, row),
    )
