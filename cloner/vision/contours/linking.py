"""Edge pixels into curves, curves into short straight segments, and how well two of them link: G^L.

References
----------
W.-S. Lee, J. Gu, N. Magnenat-Thalmann, "Generating Animatable 3D Virtual Humans from
Photographs", Eurographics 2000, section 3.5; method §4, steps 1, 3 and 4.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Bools = NDArray[np.bool_]

#: Smoothness threshold T_sm of the paper, radians.  Its value is not printed; 70 degrees keeps
#: fingertips and shoe corners admissible and refuses a turn on to a crossing line.  Taste.
SMOOTHNESS_RAD = np.deg2rad(70.0)
#: Weight w of D1 against D2 in G^L.  Not printed; equal weights.
LINK_WEIGHT = 0.5
#: Least denominator of G^L and G^P, px: positions below half a pixel are not known.
LEAST_DISTANCE_PX = 0.5
#: A run of fewer edge points has no direction.
FEWEST_POINTS = 3
#: A bridge shorter than this (px) has no direction of its own: it joins neighbours on the grid.
SHORT_BRIDGE_PX = 2.0


#: Steps of the walk: straight neighbours first, so that a staircase is not cut short.
_STEPS = ((1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1))


def walk_curves(edges: Bools) -> list[Ints]:
    """Walk connected edge pixels into curves, colouring each pixel once.

    Each walk starts at the first uncoloured pixel, grows at both ends to the uncoloured
    neighbour that turns least, and colours what it passes.  At a junction one branch goes on
    and the others become curves of their own.

    Parameters
    ----------
    edges : ndarray, shape (H, W), bool

    Returns
    -------
    list of ndarray, shape (n, 2), intp
        Pixel positions (x, y) in order, one array per curve.

    References
    ----------
    Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method section 4, step 1.
    """
    stride = edges.shape[1] + 2
    flat = np.flatnonzero(np.pad(edges, 1).ravel())
    uncoloured = dict.fromkeys(flat.tolist())
    offsets = [dy * stride + dx for dx, dy in _STEPS]
    turns = {
        (step, following): (dx - ex) ** 2 + (dy - ey) ** 2
        for step, (dx, dy) in zip(offsets, _STEPS, strict=True)
        for following, (ex, ey) in zip(offsets, _STEPS, strict=True)
    }
    numbered = list(enumerate(offsets))
    # Trying the steps by how little they turn makes the first free one the straightest.
    ordered = {step: [f for *_, f in sorted((turns[step, f], k, f) for k, f in numbered)][:5] for step in offsets}

    def grow(at: int, trial: list[int]) -> list[int]:
        curve = []
        while True:
            for step in trial:
                if at + step in uncoloured:
                    at += step
                    del uncoloured[at]
                    curve.append(at)
                    trial = ordered[step]
                    break
            else:
                return curve

    curves = []
    for start in flat.tolist():
        if start not in uncoloured:
            continue
        del uncoloured[start]
        forward = grow(start, offsets)
        backward = grow(start, ordered[start - forward[0]] if forward else offsets)
        indices = np.array([*reversed(backward), start, *forward], dtype=np.intp)
        curves.append(np.column_stack([indices % stride - 1, indices // stride - 1]))
    return curves


def split_curves(curves: list[Floats], *, longest_px: float, deviation_px: float = 1.0) -> tuple[Floats, Ints]:
    """Cut curves into runs that are short and nearly straight.

    Parameters
    ----------
    curves : list of ndarray, shape (n, 2), float64
        Ordered points, px.
    longest_px : float
        No run holds more points than this many pixels.
    deviation_px : float
        No point lies farther from its run's chord than this.

    Returns
    -------
    points : ndarray, shape (P, 2), float64
        All points, curve after curve, px.
    first : ndarray, shape (S + 1,), intp
        Run k is ``points[first[k] : first[k + 1]]``.

    References
    ----------
    Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method section 4, step 1: so that a body
    edge accidentally joined to a background edge can be separated.
    """
    if not curves:
        return np.zeros((0, 2)), np.zeros(1, dtype=np.intp)
    points = np.concatenate(curves)
    size = max(int(longest_px), 3)
    lengths = np.array([len(curve) for curve in curves], dtype=np.intp)
    pieces = np.maximum(-(-lengths // size), 1)
    which = np.repeat(np.arange(len(curves)), pieces)
    number = np.arange(len(which)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    starts = np.cumsum(lengths) - lengths
    first = np.append(starts[which] + number * lengths[which] // pieces[which], len(points))
    while True:
        extra = _largest_deviations(points, first, deviation_px)
        if len(extra) == 0:
            return points, first
        first = np.union1d(first, extra).astype(np.intp)


def _largest_deviations(points: Floats, first: Ints, deviation_px: float) -> Ints:
    """Return for each run that bends too much the index of its farthest point."""
    count = np.diff(first)
    run = np.repeat(np.arange(len(count)), count)
    start, chord = points[first[:-1]], points[first[1:] - 1] - points[first[:-1]]
    length = np.maximum(np.linalg.norm(chord, axis=1), 1e-9)
    rel = points - start[run]
    off = np.abs(chord[run, 0] * rel[:, 1] - chord[run, 1] * rel[:, 0]) / length[run]
    # A run whose ends meet has no chord; its distance from the start measures the bend.
    off = np.where(length[run] < 1.0, np.linalg.norm(rel, axis=1), off)
    # A cut at either end of a run would leave it as it was.
    inner = np.ones(len(points), dtype=bool)
    inner[first[:-1]] = False
    off = np.where(inner, off, 0.0)
    worst = np.maximum.reduceat(off, first[:-1])
    bent = np.flatnonzero(worst > deviation_px)
    hits = np.flatnonzero((off == worst[run]) & np.isin(run, bent))
    _, unique = np.unique(run[hits], return_index=True)
    return np.asarray(hits[unique], dtype=np.intp)


def bridge(s1: Floats, s2: Floats, c12: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the two joint angles and the length of the bridge between two segments.

    Parameters
    ----------
    s1, s2 : ndarray, shape (..., 2), float64
        Segment vectors P12 - P11 and P22 - P21, px.
    c12 : ndarray, shape (..., 2), float64
        Bridge P21 - P12, px.

    Returns
    -------
    alpha1, alpha2 : ndarray, shape (...)
        Angles (S1, C12) and (C12, S2), radians in 0..pi.
    d1 : ndarray, shape (...)
        Length of the bridge, px.

    Notes
    -----
    Departure: a bridge shorter than ``SHORT_BRIDGE_PX`` has the grid's direction, not the
    outline's.  The bisector of S1 and S2 is added to it, twice the missing length, so that
    two runs which overlap by a pixel still link.
    """
    d1 = np.linalg.norm(c12, axis=-1)
    u1 = s1 / np.maximum(np.linalg.norm(s1, axis=-1, keepdims=True), 1e-9)
    u2 = s2 / np.maximum(np.linalg.norm(s2, axis=-1, keepdims=True), 1e-9)
    missing = np.maximum(SHORT_BRIDGE_PX - d1, 0.0)[..., None]
    bisector = u1 + u2
    bisector = bisector / np.maximum(np.linalg.norm(bisector, axis=-1, keepdims=True), 1e-9)
    course = c12 + 2.0 * missing * bisector
    course = course / np.maximum(np.linalg.norm(course, axis=-1, keepdims=True), 1e-9)
    alpha1 = np.arccos(np.clip((u1 * course).sum(-1), -1.0, 1.0))
    alpha2 = np.arccos(np.clip((u2 * course).sum(-1), -1.0, 1.0))
    return alpha1, alpha2, d1


def is_admissible(
    s1: Floats,
    s2: Floats,
    alpha1: Floats | float,
    alpha2: Floats | float,
    *,
    smoothness_rad: float = SMOOTHNESS_RAD,
) -> Bools:
    """Return whether S1 may connect to S2: S1.S2 >= 0 and both angles below T_sm.

    Parameters
    ----------
    s1, s2 : ndarray, shape (..., 2), float64
        Segment vectors, px.
    alpha1, alpha2 : ndarray or float
        Joint angles, radians.
    smoothness_rad : float
        T_sm, radians.

    References
    ----------
    Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method section 4, step 3.
    """
    forward = (np.asarray(s1) * np.asarray(s2)).sum(-1) >= 0.0
    smooth = (np.asarray(alpha1) < smoothness_rad) & (np.asarray(alpha2) < smoothness_rad)
    return np.asarray(forward & smooth)


def link_goodness(
    alpha1: Floats | float,
    alpha2: Floats | float,
    d1_px: Floats | float,
    d2_px: Floats | float,
    m2: Floats | float,
    *,
    weight: float = LINK_WEIGHT,
) -> Floats:
    """Return G^L(S1, S2), the goodness of linking segment S2 after S1.

    ``cos a1 cos a2 (1 + cos a1 cos a2 log M2) / (w D1 + (1 - w) D2)``

    Parameters
    ----------
    alpha1, alpha2 : ndarray or float
        Joint angles, radians.
    d1_px, d2_px : ndarray or float
        Length of the bridge; distance of S2's far end from the feature segment L, px.
    m2 : ndarray or float
        Normalised magnitude of S2; values below 1 count as 1, so that log M2 >= 0.
    weight : float
        w in 0..1.

    Returns
    -------
    ndarray
        Goodness; zero where an angle exceeds a right angle.

    Notes
    -----
    The scan prints the bracket as a divisor; only the product favours strong edges.  Departures:
    a cosine below zero counts as zero (no admissible link has one) and the denominator is at
    least ``LEAST_DISTANCE_PX``.

    References
    ----------
    Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method section 4, step 4.
    """
    cosines = np.maximum(np.cos(alpha1), 0.0) * np.maximum(np.cos(alpha2), 0.0)
    strength = np.log(np.maximum(m2, 1.0))
    distance = weight * np.asarray(d1_px) + (1.0 - weight) * np.asarray(d2_px)
    return np.asarray(cosines * (1.0 + cosines * strength) / np.maximum(distance, LEAST_DISTANCE_PX))
