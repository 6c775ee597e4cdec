"""Propagation of corrections: a point that an operator placed corrects others whose errors correlate with its own.

The proposed points of one photo err jointly: a nod that the net missed moves nose, brow and chin alike, an ear found
too low is too low at top and lobe. How they err was measured on painted people (``calibrate_face_errors.py``) as a
Gaussian over all points of a photo; given the errors that an operator showed, it tells the others' most likely errors,
and how much of their doubt is left.
"""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.points import ViewPoints, expected_face_error, face_confidence

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.propagation")

Rows = NDArray[np.int64]

HAND: Final = _CALIBRATED.number("hand", "iod")
LEAST = _CALIBRATED.number("least", "iod")
MOST = _CALIBRATED.number("most", "iod")
#: Fewer known points than this tell no frame.
FEWEST: Final = 4


@dataclass(frozen=True, slots=True, eq=False)
class FaceErrors:
    """Covariance of the errors of a face photo's proposed points.

    Attributes
    ----------
    names : tuple of str
        Points of a side photo without the side they are of.
    layout_iod : (K, 2) float64
        Where they lie in an upright photo on the average, x right, y down, eye distances; a side face looks right.
    moment : (2K, 2K) float64
        Mean products of their errors (x and y of a point after each other), each in its own expected error.
    net : (468, 2, 2K) float64 or None
        The same between the net's points, eye distances, and the named ones; none of a side photo.
    """

    names: tuple[str, ...]
    layout_iod: Array
    moment: Array
    net: Array | None


@dataclass(frozen=True, slots=True, eq=False)
class LayoutAlignment:
    """Points with known error statistics, and the similarity between photo and layout.

    Attributes
    ----------
    rows, known : (M,) int64
        Their rows in the photo's points, and in ``FaceErrors.names``.
    px_from_iod : (2, 2) float64
        Turns, scales and perhaps mirrors errors from eye distances to pixels.
    expected_iod : (M,) float64
        Expected errors, eye distances.
    """

    rows: Rows
    known: Rows
    px_from_iod: Array
    expected_iod: Array


@functools.cache
def load_face_errors(view: str) -> FaceErrors:
    """Return the errors of "front" or "side" photos (made by ``calibrate_face_errors.py``)."""
    place = importlib.resources.files("cloner_models") / "face_errors.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        data = {name.removeprefix(f"{view}_"): archive[name] for name in archive.files if name.startswith(view)}
    return FaceErrors(
        tuple(str(name) for name in data["names"]),
        data["layout_iod"].astype(np.float64),
        data["moment"].astype(np.float64),
        data["net"].astype(np.float64) if "net" in data else None,
    )


def errors_in_view(view: ViewId) -> FaceErrors:
    """Return the error statistics of a view's points."""
    return load_face_errors("side" if view.is_side else "front")


def align_layout(points: ViewPoints, errors: FaceErrors) -> LayoutAlignment | None:
    """Return the alignment of a photo's proposed points with the layout, None where too few are known."""
    side = "pupil_L" not in errors.names
    own = [name[:-2] if side and name.endswith(("_L", "_R")) else name for name in points.names]
    rows = np.array([row for row, name in enumerate(own) if name in errors.names], dtype=np.int64)
    known = np.array([errors.names.index(own[row]) for row in rows], dtype=np.int64)
    if len(rows) < FEWEST:
        return None
    px_from_iod = _similarity(errors.layout_iod[known], points.points_px[rows], either_hand=side)
    expected = np.clip(expected_face_error(points.confidence[rows]), LEAST, MOST)
    return LayoutAlignment(rows, known, px_from_iod, expected)


def _similarity(layout: Array, places_px: Array, *, either_hand: bool) -> Array:
    """Return the (2, 2) similarity, mirrored where that fits better and is allowed."""
    away, goal = layout - layout.mean(axis=0), places_px - places_px.mean(axis=0)
    best, least = np.eye(2), np.inf
    for hand in (1.0, -1.0) if either_hand else (1.0,):
        first, aim = (away * [hand, 1.0]) @ [1, 1j], goal @ [1, 1j]
        factor = np.vdot(first, aim) / max(float(np.vdot(first, first).real), 1e-12)
        miss = float((np.abs(aim - factor * first) ** 2).sum())
        if miss < least:
            turn = np.array([[factor.real, -factor.imag], [factor.imag, factor.real]])
            best, least = turn * [hand, 1.0], miss
    return best


def propagate_corrections(points: ViewPoints, fixed: NDArray[np.bool_], targets_px: Array) -> tuple[Array, Array]:
    """Return positions (N, 2) px and confidences (N,) of a face's points after an operator has placed some.

    Parameters
    ----------
    points : ViewPoints
        As proposed.
    fixed : (N,) bool
        Which were placed.
    targets_px : (M, 2) float64
        Where those are, in their order.

    Notes
    -----
    The conditional mean and spread of a Gaussian, the operator's own error (``HAND``) added to what is conditioned on.
    Placed points stay exactly where they are; points whose errors nobody measured stay where they were proposed.
    """
    places, confidence = points.points_px.copy(), points.confidence.copy()
    places[fixed], confidence[fixed] = targets_px, 1.0
    errors = errors_in_view(points.view)
    frame = align_layout(points, errors)
    gains = None if frame is None else _kalman_gain(errors, frame, points, fixed, places)
    if frame is None or gains is None:
        return places, confidence
    gain, error = gains
    axes = axis_rows(frame.known)
    most_likely = (errors.moment[axes] @ gain @ error).reshape(-1, 2) * frame.expected_iod[:, None]
    before = np.diag(errors.moment)[axes].reshape(-1, 2).sum(axis=1)
    told_away = np.einsum("ij,ij->i", errors.moment[axes] @ gain, errors.moment[axes]).reshape(-1, 2).sum(axis=1)
    left = np.sqrt(np.clip(1.0 - told_away / before, 0.0, 1.0))
    free = ~fixed[frame.rows]
    rows = frame.rows[free]
    places[rows] += (most_likely @ frame.px_from_iod.T)[free]
    confidence[rows] = _raised_confidence(points.confidence[rows], left[free])
    return places, confidence


def propagate_to_net(net_px: Array, points: ViewPoints) -> Array:
    """Return the net's points (468, 2) px corrected by the errors that an operator's points reveal.

    Parameters
    ----------
    net_px : (468, 2) float64
    points : ViewPoints
        Of the same photo, corrections on top.
    """
    errors, before = errors_in_view(points.view), points.proposed or points
    frame, count = align_layout(before, errors), len(before.names)
    if frame is None or errors.net is None:
        return net_px.copy()
    gains = _kalman_gain(errors, frame, before, points.corrected[:count], points.points_px[:count])
    if gains is None:
        return net_px.copy()
    gain, error = gains
    return np.asarray(net_px + (errors.net @ gain @ error) @ frame.px_from_iod.T)


def _kalman_gain(
    errors: FaceErrors, frame: LayoutAlignment, before: ViewPoints, fixed: NDArray[np.bool_], places_px: Array
) -> tuple[Array, Array] | None:
    """Return the gain (2K, 2K) and the observed errors (2K,), each in its point's sigma; None without any.

    Errors are what has to be added to a proposal. A point that lies where it was proposed says nothing: it may never
    have been looked at.
    """
    away = (places_px - before.points_px)[frame.rows]
    shown = fixed[frame.rows] & (np.abs(away) > 0.0).any(axis=1)
    if not shown.any():
        return None
    error = np.zeros(len(errors.moment))
    spread = frame.expected_iod[shown]
    axes = axis_rows(frame.known[shown])
    error[axes] = (away[shown] @ np.linalg.inv(frame.px_from_iod).T / spread[:, None]).ravel()
    hand = np.repeat((HAND / spread) ** 2, 2)
    gain = np.zeros_like(errors.moment)
    gain[np.ix_(axes, axes)] = np.linalg.inv(errors.moment[np.ix_(axes, axes)] + np.diag(hand))
    return gain, error


def axis_rows(known: Rows) -> Rows:
    """Return the rows of both axes of points."""
    return np.asarray((2 * known[:, None] + [0, 1]).ravel(), dtype=np.int64)


def _raised_confidence(confidence: Array, left: Array) -> Array:
    """Return confidences once a share of the sigma is left."""
    return np.asarray(face_confidence(left * expected_face_error(confidence)))
