"""Grow candidate paths of edge segments along a feature segment and choose the best.

References
----------
W.-S. Lee, J. Gu, N. Magnenat-Thalmann, "Generating Animatable 3D Virtual Humans from
Photographs", Eurographics 2000, section 3.5; method note section 4, steps 2, 5 and 6.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.vision.linking import (
    SMOOTHNESS_RAD,
    bridge,
    is_admissible,
    link_goodness,
)

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]

#: Weights w1, w2, w3 of G^P, as printed.
PATH_WEIGHTS = (0.2, 0.2, 0.8)
#: A bridge is at least so long as that share of what it skips of L: fingers and bays are not cut short.
SKIP = 0.5
#: Links kept from either end of a segment.
MOST_LINKS = 6
#: Turns of Dinkelbach's iteration; it converges in three or four.
MOST_TURNS = 12


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
    places : ndarray, shape (S,), float64
        Where along L the middle of each lies, px.
    length : float
        Length of L, px.
    doubt_px : float
        How little L is known, px: added to the denominator of G^P.
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
    places: Floats
    length: float
    doubt_px: float

    @property
    def reach(self) -> Floats:
        """Half the length of each segment, px."""
        return np.asarray(self.counts / 2.0)


@dataclass(frozen=True, slots=True, eq=False)
class Links:
    """Admissible links between candidates.

    Attributes
    ----------
    first, second : ndarray, shape (K,), intp
        Candidates at both sides of each.
    cost : ndarray, shape (K,), float64
        Of ``joint_cost``.
    """

    first: Ints
    second: Ints
    cost: Floats


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


def joint_cost(d_px: Floats, alpha1: Floats, alpha2: Floats) -> Floats:
    """Return D (1 + sin a1 + sin a2) of joints, px; an angle above a right angle counts as one."""
    right = np.pi / 2
    return np.asarray(d_px * (1.0 + np.sin(np.minimum(alpha1, right)) + np.sin(np.minimum(alpha2, right))))


def path_goodness(
    magnitudes: Floats,
    dt1_px: float,
    dt2_px: float,
    d_px: Floats,
    alpha1: Floats,
    alpha2: Floats,
    *,
    doubt_px: float,
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
        Goodness.

    Notes
    -----
    Departure: ``doubt_px`` is added to the denominator, which a perfect path leaves at zero: with little of it the
    smoothest path nearest to L wins, however weak its edges.

    References
    ----------
    Lee, Gu and Magnenat-Thalmann 2000, section 3.5; method section 4, step 6.
    """
    w1, w2, w3 = weights
    cost = w1 * dt1_px + w2 * dt2_px + w3 * float(joint_cost(d_px, alpha1, alpha2).sum())
    return float(np.sum(magnitudes)) / (cost + doubt_px)


def links_of(near: Candidates, *, longest_bridge_px: float, smoothness_rad: float = SMOOTHNESS_RAD) -> Links:
    """Link both ends of every segment to the neighbours of greatest G^L.

    Parameters
    ----------
    near : Candidates
    longest_bridge_px : float
        Bridges longer than this are not admissible.
    smoothness_rad : float
        T_sm, radians.

    Returns
    -------
    Links
        ``MOST_LINKS`` at most from each end; a link goes on along L.

    Notes
    -----
    Departure: the paper follows the one best link from each end.  One wrong link then loses the outline for good, so
    several are kept, and G^P decides.

    References
    ----------
    Method section 4, step 5.
    """
    vectors = near.ends - near.starts
    later = near.places[None] - near.places[:, None]
    first, second = np.nonzero(
        (later > 0.0) & (later <= 2.0 * longest_bridge_px + near.reach[:, None] + near.reach[None])
    )
    gap = near.starts[second] - near.ends[first]
    close = np.linalg.norm(gap, axis=1) <= longest_bridge_px
    first, second, gap = first[close], second[close], gap[close]
    alpha1, alpha2, d1 = bridge(vectors[first], vectors[second], gap)
    allowed = is_admissible(vectors[first], vectors[second], alpha1, alpha2, smoothness_rad=smoothness_rad)
    first, second = first[allowed], second[allowed]
    alpha1, alpha2, d1 = alpha1[allowed], alpha2[allowed], d1[allowed]
    forward = link_goodness(alpha1, alpha2, d1, near.end_distances[second], near.magnitudes[second])
    # Seen from S2 backwards the same joint has S1 as its newcomer: D2 and M2 are S1's.
    backward = link_goodness(alpha1, alpha2, d1, near.start_distances[first], near.magnitudes[first])
    kept = (_rank(first, forward) < MOST_LINKS) | (_rank(second, backward) < MOST_LINKS)
    first, second, d1 = first[kept], second[kept], d1[kept]
    skipped = later[first, second] - near.reach[first] - near.reach[second]
    return Links(first, second, joint_cost(np.maximum(d1, SKIP * skipped), alpha1[kept], alpha2[kept]))


def _rank(groups: Ints, values: Floats) -> Ints:
    """Return each row's place among the rows of its group, the greatest value first."""
    order = np.lexsort((-values, groups))
    ordered = groups[order]
    begins = np.flatnonzero(np.append(True, ordered[1:] != ordered[:-1])) if len(order) else order
    rank = np.empty(len(order), dtype=np.intp)
    rank[order] = np.arange(len(order)) - np.repeat(begins, np.diff(np.append(begins, len(order))))
    return rank


def score_path(members: Ints, near: Candidates) -> float:
    """Return G^P of a chain of candidates."""
    vectors = near.ends[members] - near.starts[members]
    alpha1, alpha2, d = bridge(vectors[:-1], vectors[1:], near.starts[members[1:]] - near.ends[members[:-1]])
    d = np.maximum(d, SKIP * (np.diff(near.places[members]) - near.reach[members[1:]] - near.reach[members[:-1]]))
    ends = np.stack([near.starts[members[0]], near.ends[members[-1]]])
    dt1 = float(np.linalg.norm(ends - near.tail, axis=1).sum())
    dt2 = float((near.mean_distances[members] * near.counts[members]).sum() / near.length)
    return path_goodness(near.totals[members], dt1, dt2, d, alpha1, alpha2, doubt_px=near.doubt_px)


def best_path(near: Candidates, *, longest_bridge_px: float, smoothness_rad: float = SMOOTHNESS_RAD) -> Path | None:
    """Return P* = argmax G^P over all paths through the best links of every segment.

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

    Notes
    -----
    G^P is a ratio of two sums over the path, so its greatest value is the root of max(sum M - g * cost) = 0 in g, which
    Dinkelbach's iteration finds in a few turns; each turn is one pass over the links in their order along L.

    References
    ----------
    Method section 4, steps 5 and 6; W. Dinkelbach, "On nonlinear fractional programming", Management Science 1967.
    """
    if len(near.starts) == 0:
        return None
    links = links_of(near, longest_bridge_px=longest_bridge_px, smoothness_rad=smoothness_rad)
    best = Path(np.array([int(np.argmax(near.totals))], dtype=np.intp), 0.0)
    for _ in range(MOST_TURNS):
        members = _dearest(near, links, best.goodness)
        goodness = score_path(members, near)
        if goodness <= best.goodness * (1.0 + 1e-9):
            break
        best = Path(members, goodness)
    return best


def _dearest(near: Candidates, links: Links, price: float) -> Ints:
    """Return the path of greatest sum M - price * cost."""
    w1, w2, w3 = (price * weight for weight in PATH_WEIGHTS)
    own = near.totals - w2 * near.mean_distances * near.counts / near.length
    opening = -w1 * np.linalg.norm(near.starts - near.tail[0], axis=1)
    closing = -w1 * np.linalg.norm(near.ends - near.tail[1], axis=1)
    order = np.argsort(near.places[links.first], kind="stable")
    value, before = opening + own, np.full(len(own), -1)
    # Plain lists: one pass over a few hundred links is faster than NumPy's calls.
    reached, gain, back = value.tolist(), own.tolist(), before.tolist()
    rows = zip(
        links.first[order].tolist(), links.second[order].tolist(), (w3 * links.cost[order]).tolist(), strict=True
    )
    for i, j, cost in rows:
        through = reached[i] - cost + gain[j]
        if through > reached[j]:
            reached[j], back[j] = through, i
    at = int(np.argmax(np.array(reached) + closing))
    members = [at]
    while (at := back[at]) >= 0:
        members.append(at)
    return np.array(members[::-1], dtype=np.intp)
