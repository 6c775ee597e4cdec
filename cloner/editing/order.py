"""Order in which an operator should check points: by how much error a true position is expected to remove."""

from __future__ import annotations

import heapq
from collections.abc import Mapping
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.propagation import HAND, FaceErrors, LayoutAlignment, align_layout, axis_rows, errors_in_view
from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.points import FAR, ViewPoints, expected_error, expected_face_error

#: What each number is and where it comes from: ``cloner/calibration/editing.toml``.
_CALIBRATED: Final = calibrated("editing.order")


BODY_SHARE: Final = _CALIBRATED.number("body_share", "share")
#: What the likeness of a face is judged by (rulers: landmarks in 3-D); other points count by what they tell of these.
COUNTED: Final = frozenset(
    ("nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front", "chin_bottom", "eye_inner",
     "eye_outer", "ala", "mouth_corner", "ear_top", "ear_lobe")
)  # fmt: skip
IOD_M = _CALIBRATED.number("iod_m", "m")
FIGURE_M = _CALIBRATED.number("figure_m", "m")


def by_expected_gain(points: Mapping[ViewId, ViewPoints]) -> list[tuple[ViewId, str]]:
    """Return the proposed points of all photos in decreasing expected gain; placed ones come last.

    A point of the face also corrects its neighbours (``detectors/propagation.py``), and gains less once they are known.
    The face in a body photo is left out where the face has a photo of its own, which says the same larger.
    """
    large = set(points[ViewId.FACE_FRONT].names) if ViewId.FACE_FRONT in points else set()
    queues, placed = [], []
    for number, (view, one) in enumerate(points.items()):
        wanted = [name for name in one.names if view.is_face or name not in large]
        placed += [(view, name) for name in wanted if one.corrected[one.names.index(name)]]
        queues.append([(-gain, number, view, name) for name, gain in greedy_gains(one) if name in wanted])
    return [(view, name) for *_, view, name in heapq.merge(*queues)] + placed


def greedy_gains(points: ViewPoints) -> list[tuple[str, float]]:
    """Return a photo's unplaced points, each with what it improves beyond those before it, square metres."""
    known: list[tuple[str, float]] = []
    if points.view.is_face:
        errors = errors_in_view(points.view)
        frame = align_layout(points, errors)
        known = [] if frame is None else [(points.names[row], gain) for row, gain in _greedy_face_gains(errors, frame)]
        away = IOD_M * expected_face_error(points.confidence) * (frame is None)  # a hairline bends no face
    else:
        expected = expected_error(points.confidence)
        away = BODY_SHARE * FIGURE_M * expected * np.sqrt(_outlier_probability(expected))
    known_now = dict(known)
    alone = {name: float(far**2) for name, far in zip(points.names, away, strict=True) if name not in known_now}
    rows = [*known_now.items(), *alone.items()]
    return sorted((row for row in rows if not points.corrected[points.names.index(row[0])]), key=lambda row: -row[1])


def _outlier_probability(expected: Array) -> Array:
    """Return the probability (N,) that points with sigmas (N,), figure heights, are wrong by more than the fit
    tolerates.

    Nearer, a joint's correction turns a limb in its own photo, a point of the outline bends the skin around itself, and
    neither shapes the person (``stages/points.py``, points_for_fit).
    Errors are normal along both axes of a photo, so their lengths are Rayleigh's.
    """
    return np.asarray(np.exp(-np.pi / 4.0 * (FAR / np.maximum(expected, 1e-6)) ** 2))


def _greedy_face_gains(errors: FaceErrors, frame: LayoutAlignment) -> list[tuple[int, float]]:
    """Return a face's points in greedy order of expected gain, and the gains, square metres."""
    axes = axis_rows(frame.known)
    spread = np.repeat(IOD_M * frame.expected_iod, 2)
    doubt = errors.moment[np.ix_(axes, axes)] * spread[:, None] * spread
    hand = (IOD_M * HAND) ** 2 * np.eye(2)
    counted = [errors.names[row].removesuffix("_L").removesuffix("_R") in COUNTED for row in frame.known]
    weight = np.repeat(np.array(counted, dtype=np.float64), 2)
    left, order = list(range(len(frame.rows))), []
    while left:
        pairs = {one: doubt[:, [2 * one, 2 * one + 1]] for one in left}
        mended = {
            one: pair @ np.linalg.solve(pair[[2 * one, 2 * one + 1]] + hand, pair.T) for one, pair in pairs.items()
        }
        worth = {one: float(weight @ np.diag(less)) for one, less in mended.items()}
        best = max(left, key=lambda one: worth[one])
        order.append((int(frame.rows[best]), worth[best]))
        doubt = doubt - mended[best]
        left.remove(best)
    return order
