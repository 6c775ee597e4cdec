"""G^L and G^P worked by hand, the walk, the split and the choice of a path."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from cloner.vision.contours.linking import (
    LEAST_DISTANCE_PX,
    bridge,
    is_admissible,
    link_goodness,
    split_curves,
    walk_curves,
)
from cloner.vision.contours.paths import Candidates, best_path, best_successors, grow_path, path_goodness


def test_link_goodness_of_a_straight_link() -> None:
    # cos = 1, log M = log e = 1, w D1 + (1 - w) D2 = 0.5 * 2 + 0.5 * 6 = 4: (1 + 1) / 4.
    assert link_goodness(0.0, 0.0, 2.0, 6.0, np.e, weight=0.5) == pytest.approx(0.5)


def test_link_goodness_of_a_bent_link() -> None:
    # cos 60 * cos 60 = 1/4, log e^2 = 2, 0.25 * 4 + 0.75 * 8 = 7: 1/4 * (1 + 1/2) / 7.
    value = link_goodness(np.pi / 3, np.pi / 3, 4.0, 8.0, np.e**2, weight=0.25)
    assert value == pytest.approx(0.375 / 7.0)


def test_link_goodness_has_no_zero_denominator_and_no_negative_logarithm() -> None:
    assert link_goodness(0.0, 0.0, 0.0, 0.0, 1.0) == pytest.approx(1.0 / LEAST_DISTANCE_PX)
    assert link_goodness(0.0, 0.0, 1.0, 1.0, 0.01) == pytest.approx(1.0)


def test_path_goodness_of_two_joined_segments() -> None:
    # Sum M = 5; 0.2 * 10 + 0.2 * 5 + 0.8 * 3 * (1 + sin 30 + sin 90) = 2 + 1 + 6 = 9.
    value = path_goodness(
        np.array([2.0, 3.0]),
        10.0,
        5.0,
        np.array([3.0]),
        np.array([np.pi / 6]),
        np.array([np.pi / 2]),
    )
    assert value == pytest.approx(5.0 / 9.0)


def test_path_goodness_of_a_perfect_path_is_finite() -> None:
    none = np.zeros(0)
    assert path_goodness(np.array([4.0]), 0.0, 0.0, none, none, none) == pytest.approx(4.0 / LEAST_DISTANCE_PX)


@pytest.mark.parametrize(
    ("s1", "s2", "c12", "expected"),
    [
        ((10, 0), (10, 0), (5, 0), True),
        ((10, 0), (-10, 1), (5, 0), False),  # turns back
        ((10, 0), (10, 0), (0, 8), False),  # steps aside: 90 degrees twice
        ((10, 0), (10, 10), (5, 2), True),
    ],
)
def test_admissible_links(s1: tuple[int, int], s2: tuple[int, int], c12: tuple[int, int], expected: bool) -> None:
    a, b, c = (np.array(v, dtype=float) for v in (s1, s2, c12))
    alpha1, alpha2, _ = bridge(a, b, c)
    assert bool(is_admissible(a, b, alpha1, alpha2)) is expected


def test_bridge_measures_both_angles_in_degrees_known_beforehand() -> None:
    alpha1, alpha2, d1 = bridge(np.array([10.0, 0.0]), np.array([0.0, 10.0]), np.array([3.0, 3.0 * np.sqrt(3.0)]))
    assert np.rad2deg([alpha1, alpha2]) == pytest.approx([60.0, 30.0])
    assert d1 == pytest.approx(6.0)


def test_walk_colours_every_pixel_once_and_keeps_a_crossing_line_straight() -> None:
    edges = np.zeros((21, 31), dtype=bool)
    edges[10, 2:29] = True
    edges[2:19, 15] = True
    curves = walk_curves(edges)
    pixels = np.concatenate(curves)
    assert len(np.unique(pixels, axis=0)) == len(pixels) == edges.sum()
    for curve in curves:
        steps = np.abs(np.diff(curve, axis=0)).max(axis=1)
        assert (steps == 1).all()
    assert max(len(curve) for curve in curves) >= 17


def test_split_bounds_length_and_bend() -> None:
    t = np.linspace(0, 2 * np.pi, 400)
    circle = 60.0 * np.column_stack([np.cos(t), np.sin(t)])
    corner = np.array([[x, 0.0] for x in range(20)] + [[19.0, y] for y in range(1, 20)])
    points, first = split_curves([circle, corner], longest_px=30)
    assert first[0] == 0
    assert first[-1] == len(points) == 439
    for a, b in itertools.pairwise(first):
        run = points[a:b]
        assert b - a <= 30
        chord = run[-1] - run[0]
        if np.linalg.norm(chord) > 1:
            off = np.abs(np.cross(np.append(chord, 0), np.c_[run - run[0], np.zeros(b - a)])[:, 2])
            assert off.max() / np.linalg.norm(chord) <= 1.0


def _candidates(rows: list[tuple[float, float, float, float, float]]) -> Candidates:
    """Return straight segments (x1, y1, x2, y2, M) near the feature segment y = 0, x = 0..100."""
    table = np.array(rows)
    starts, ends, magnitude = table[:, :2], table[:, 2:4], table[:, 4]
    counts = np.linalg.norm(ends - starts, axis=1)
    return Candidates(
        starts,
        ends,
        magnitude,
        magnitude * counts,
        np.abs(starts[:, 1]),
        np.abs(ends[:, 1]),
        np.abs((starts + ends)[:, 1] / 2),
        counts,
        np.array([[0.0, 0.0], [100.0, 0.0]]),
    )


def test_path_bridges_gaps_and_ignores_a_parallel_decoy_of_equal_strength() -> None:
    line = [(x, 0.5, x + 18.0, 0.5, 3.0) for x in (0.0, 20.0, 45.0, 65.0, 82.0)]
    decoy = [(x, 9.0, x + 18.0, 9.0, 3.0) for x in (0.0, 20.0, 40.0, 60.0, 80.0)]
    path = best_path(_candidates(line + decoy), longest_bridge_px=12.0)
    assert path is not None
    assert path.members.tolist() == [0, 1, 2, 3, 4]


def test_path_does_not_turn_on_to_a_crossing_line() -> None:
    line = [(x, 0.5, x + 19.0, 0.5, 3.0) for x in (0.0, 20.0, 40.0, 60.0, 80.0)]
    crossing = [(50.0, y, 50.0, y + 9.0, 9.0) for y in (-20.0, -10.0, 2.0, 12.0)]
    path = best_path(_candidates(line + crossing), longest_bridge_px=12.0)
    assert path is not None
    assert path.members.tolist() == [0, 1, 2, 3, 4]


def test_growth_ends_at_a_loop() -> None:
    following, preceding = np.array([1, 2, 0]), np.array([2, 0, 1])
    assert sorted(grow_path(0, following, preceding)) == [0, 1, 2]


def test_no_segment_gives_no_path() -> None:
    empty = _candidates([(0.0, 0.0, 1.0, 0.0, 1.0)])
    none = Candidates(
        *(getattr(empty, f)[:0] for f in (
            "starts", "ends", "magnitudes", "totals", "start_distances", "end_distances",
            "mean_distances", "counts",
        )),
        empty.tail,
    )  # fmt: skip
    assert best_path(none, longest_bridge_px=5.0) is None
    following, preceding = best_successors(none, longest_bridge_px=5.0)
    assert len(following) == len(preceding) == 0


def test_best_path_is_the_argmax_over_all_grown_paths() -> None:
    rng = np.random.default_rng(4)
    for _ in range(6):
        x = rng.uniform(0, 80, 14)
        y, rise = rng.uniform(-6, 6, 14), rng.uniform(-3, 3, 14)
        rows = [(a, b, a + rng.uniform(6, 18), b + c, rng.uniform(1, 4)) for a, b, c in zip(x, y, rise, strict=True)]
        near = _candidates(rows)
        following, preceding = best_successors(near, longest_bridge_px=15.0)
        scores = {}
        for seed in range(14):
            chain = list(grow_path(seed, following, preceding))
            joints = list(itertools.pairwise(chain))
            turns = [
                bridge(near.ends[a] - near.starts[a], near.ends[b] - near.starts[b], near.starts[b] - near.ends[a])
                for a, b in joints
            ]
            alpha1, alpha2, gaps = (np.array([turn[k] for turn in turns]) for k in range(3))
            tails = np.linalg.norm(near.starts[chain[0]]) + np.linalg.norm(near.ends[chain[-1]] - [100.0, 0.0])
            away = np.average(near.mean_distances[chain], weights=near.counts[chain])
            scores[tuple(chain)] = path_goodness(near.totals[chain], float(tails), float(away), gaps, alpha1, alpha2)
        best = best_path(near, longest_bridge_px=15.0)
        assert best is not None
        assert best.goodness == pytest.approx(max(scores.values()))
        assert scores[tuple(best.members.tolist())] == pytest.approx(best.goodness)
