"""Grow candidate paths of edge segments along a feature segment and choose the best by G^P.

References
----------
W.-S. Lee, J. Gu, N. Magnenat-Thalmann, "Generating Animatable 3D Virtual Humans from
Photographs", Eurographics 2000, section 3.5; method §4, steps 2, 5 and 6.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.vision.contours.linking import (
    LEAST_DISTANCE_PX,
    SMOOTHNESS_RAD,
    bridge,
    is_admissible,
    link_goodness,
)

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

#: Weights w1, w2, w3 of G^P, as printed.
PATH_WEIGHTS = (0.2, 0.2, 0.8)


@dataclass(frozen=True, slots=True, eq=False)
class Candidates:
    """Edge segments in the vicinity of one feature segment L, each directed along L.

    Attributes
    ----------
    starts, ends : ndarray, shape (S, 2), float64
        Segment ends, px.
    magnitudes : ndarray, shape (S,), float64
        Mean normalised magnitude M >= 1 (used in G^L).
    totals : ndarray, shape (S,), float64
        Magnitude of the whole segment (summed over its points; used in G^P).
    start_distances, end_distances, mean_distances : ndarray, shape (S,), float64
        Distances from L: of the segment's two ends, and the mean over its points, px.
    counts : ndarray, shape (S,), float64
        Number of points.
    tail : ndarray, shape (2, 2), float64
        First and last point of L, px.
    """

    starts: Floats
    ends: Floats
    magnitudes: Floats
    totals: Floats
    start_distances: Floats
    end_distances: Floats
    mean_distances: Floats
    counts: Floats
    tail: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Path:
    """A chain of candidates.

    Attributes
    ----------
    members : ndarray, shape (N,), intp
        Indices into the candidates, from L's start to its end.
    goodness : float
        G^P.
    """

    members: Ints
    goodness: float


def path_goodness(
    magnitudes: Floats,
    dt1_px: float,
    dt2_px: float,
    d_px: Floats,
    alpha1: Floats,
    alpha2: Floats,
    *,
    weights: tuple[float, float, float] = PATH_WEIGHTS,
) -> float:
    """Return G^P(P), the goodness of a path of N segments with N - 1 joints.

    ``sum M_i / (w1 DT1 + w2 DT2 + w3 sum D_i (1 + sin a_i1 + sin a_i2))``

    Parameters
    ----------
    magnitudes : ndarray, shape (N,), float64
        Magnitude of each segment.
    dt1_px : float
        Distance of the path's ends from the ends of L, px (sum of both).
    dt2_px : float
        Mean distance of the path's points from L, px.
    d_px, alpha1, alpha2 : ndarray, shape (N - 1,), float64
        Bridge length (px) and the two angles (radians) of each joint.  An angle above a right
        angle counts as a right angle, so that a sharper kink never scores better.

    Returns
    -------
    float
        Goodness; the denominator is at least ``LEAST_DISTANCE_PX``.

    References
    ----------
    Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method section 4, step 6.
    """
    right = np.pi / 2
    kinks = 1.0 + np.sin(np.minimum(alpha1, right)) + np.sin(np.minimum(alpha2, right))
    w1, w2, w3 = weights
    cost = w1 * dt1_px + w2 * dt2_px + w3 * float(np.sum(d_px * kinks))
    return float(np.sum(magnitudes)) / max(cost, LEAST_DISTANCE_PX)


def best_successors(
    near: Candidates, *, longest_bridge_px: float, smoothness_rad: float = SMOOTHNESS_RAD
) -> tuple[Ints, Ints]:
    """Link both ends of every segment to the neighbour of greatest G^L.

    Parameters
    ----------
    near : Candidates
    longest_bridge_px : float
        Bridges longer than this are not admissible.
    smoothness_rad : float
        T_sm, radians.

    Returns
    -------
    following, preceding : ndarray, shape (S,), intp
        Best neighbour at the end and at the start of each segment; -1 where none is admissible.

    Notes
    -----
    G^L depends on the pair alone, so the growth of every path follows these two pointers.

    References
    ----------
    Method section 4, step 5.
    """
    vectors = near.ends - near.starts
    size = len(vectors)
    if size == 0:
        return np.zeros(0, np.intp), np.zeros(0, np.intp)
    s1, s2 = np.broadcast_arrays(vectors[:, None], vectors[None])
    alpha1, alpha2, d1 = bridge(s1, s2, near.starts[None] - near.ends[:, None])
    allowed = is_admissible(s1, s2, alpha1, alpha2, smoothness_rad=smoothness_rad)
    allowed &= (d1 <= longest_bridge_px) & ~np.eye(size, dtype=bool)
    forward = link_goodness(alpha1, alpha2, d1, near.end_distances[None], near.magnitudes[None])
    # Seen from S2 backwards the same joint has S1 as its newcomer: D2 and M2 are S1's.
    backward = link_goodness(alpha1, alpha2, d1, near.start_distances[:, None], near.magnitudes[:, None])
    forward = np.where(allowed, forward, 0.0)
    backward = np.where(allowed, backward, 0.0)
    following, preceding = forward.argmax(axis=1), backward.argmax(axis=0)
    following[forward.max(axis=1) <= 0.0] = -1
    preceding[backward.max(axis=0) <= 0.0] = -1
    return following, preceding


def grow_path(seed: int, following: Ints, preceding: Ints) -> tuple[int, ...]:
    """Return the path that grows from one segment until no admissible link is left.

    A segment is used once: meeting it again would be a loop, and ends the growth.
    """
    used = {seed}
    path = [seed]
    for pointers, at_end in ((following, True), (preceding, False)):
        at = seed
        while (at := int(pointers[at])) >= 0 and at not in used:
            used.add(at)
            path.append(at) if at_end else path.insert(0, at)
    return tuple(path)


def score_path(members: Ints, near: Candidates) -> float:
    """Return G^P of a chain of candidates."""
    vectors = near.ends[members] - near.starts[members]
    alpha1, alpha2, d = bridge(vectors[:-1], vectors[1:], near.starts[members[1:]] - near.ends[members[:-1]])
    ends = np.stack([near.starts[members[0]], near.ends[members[-1]]])
    dt1 = float(np.linalg.norm(ends - near.tail, axis=1).sum())
    counts = near.counts[members]
    dt2 = float((near.mean_distances[members] * counts).sum() / counts.sum())
    return path_goodness(near.totals[members], dt1, dt2, d, alpha1, alpha2)


def best_path(near: Candidates, *, longest_bridge_px: float, smoothness_rad: float = SMOOTHNESS_RAD) -> Path | None:
    """Return P* = argmax G^P over the paths grown from every segment.

    Parameters
    ----------
    near : Candidates
        Segments in the vicinity band of L, directed along L.
    longest_bridge_px : float
        Longest admissible bridge, px.
    smoothness_rad : float
        T_sm, radians.

    Returns
    -------
    Path or None
        None where the band holds no segment.

    References
    ----------
    Method section 4, steps 5 and 6.
    """
    following, preceding = best_successors(near, longest_bridge_px=longest_bridge_px, smoothness_rad=smoothness_rad)
    grown = {grow_path(seed, following, preceding) for seed in range(len(following))}
    best: Path | None = None
    for chain in sorted(grown):
        members = np.array(chain, dtype=np.intp)
        goodness = score_path(members, near)
        if best is None or goodness > best.goodness:
            best = Path(members, goodness)
    return best
