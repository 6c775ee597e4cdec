"""An operator's point lies on the outline, and only its surroundings follow it."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.vision.contours.fixed_points import LEAST_REACH_PX, REACH_PER_HEIGHT, bend_through
from cloner.vision.contours.outlines import extract_outline
from kit.drawn import AXES, CENTRE, SKIN, WALL, draw, ellipse, photograph, rough_mask, with_noise

Points = NDArray[np.float64]


def on_ellipse(*degrees: float, out_px: float = 0.0) -> Points:
    t = np.deg2rad(np.array(degrees))
    return CENTRE + (AXES + out_px) * np.column_stack([np.cos(t), np.sin(t)])


def gap_px(polygon: Points, points: Points) -> Points:
    """Return each point's distance from a closed polygon's sides."""
    ahead = np.roll(polygon, -1, axis=0) - polygon
    away = points[:, None] - polygon[None]
    share = np.clip((away * ahead).sum(-1) / np.maximum((ahead**2).sum(-1), 1e-12), 0, 1)
    return np.asarray(np.linalg.norm(away - share[..., None] * ahead, axis=-1).min(axis=1))


def sharpest_turn(polygon: Points, *, step: int = 3) -> float:
    """Return the largest change of direction over ``2 * step`` vertices, degrees."""
    chord = np.roll(polygon, -step, axis=0) - polygon
    course = np.arctan2(chord[:, 1], chord[:, 0])
    return float(np.rad2deg(np.abs(np.angle(np.exp(1j * (course - np.roll(course, step)))))).max())


def test_bend_passes_through_the_point_and_ends_within_its_reach() -> None:
    polygon = ellipse(1200)
    target = on_ellipse(30.0, out_px=8.0)
    bent = bend_through(polygon, target)
    assert gap_px(bent, target)[0] < 1e-9
    far = np.linalg.norm(polygon - target, axis=1) > REACH_PER_HEIGHT * 8.0 + 8.0
    np.testing.assert_array_equal(bent[far], polygon[far])
    assert sharpest_turn(bent) < 45.0


def test_neighbours_moved_alike_move_what_lies_between_alike() -> None:
    x = np.arange(400.0)
    polygon = np.vstack([np.column_stack([x, np.zeros(400)]), [[400.0, 300.0], [-1.0, 300.0]]])
    # 100 px up at x = 150 and 200: each alone would reach farther than the other point.
    bent = bend_through(polygon, np.array([[150.0, -100.0], [200.0, -100.0]]))
    # the vertex nearest to each is straight below it
    np.testing.assert_allclose(bent[150:201, 1], -100.0, atol=1e-9)


def test_bends_do_not_disturb_each_other_or_the_given_polygon() -> None:
    polygon = ellipse(1200)
    before = polygon.copy()
    targets = on_ellipse(10.0, 14.0, 200.0, out_px=-6.0)
    bent = bend_through(polygon, targets)
    assert gap_px(bent, targets).max() < 1e-9
    np.testing.assert_array_equal(polygon, before)
    np.testing.assert_array_equal(bend_through(polygon, np.zeros((0, 2))), polygon)


def test_a_small_move_makes_no_tooth() -> None:
    bent = bend_through(ellipse(1200), on_ellipse(45.0, out_px=1.0))
    assert LEAST_REACH_PX >= 4.0
    assert sharpest_turn(bent) < 45.0


@pytest.mark.parametrize("out_px", [-12.0, -3.0, 2.0, 14.0, 30.0])
def test_outline_passes_through_a_corrected_point_and_is_left_alone_elsewhere(out_px: float) -> None:
    photo, mask = photograph(), rough_mask()
    points = on_ellipse(0.0, 60.0, 120.0, 180.0, 240.0, 300.0)
    points[1] = on_ellipse(60.0, out_px=out_px)[0]
    free = extract_outline(photo, mask, points)
    held = extract_outline(photo, mask, points, fixed=np.arange(6) == 1)
    polygon = held.loops[0].polygon
    assert gap_px(polygon, points[1:2])[0] < 0.1
    away = np.linalg.norm(polygon - points[1], axis=1) > 4.0 * abs(out_px) + 20.0
    assert gap_px(free.loops[0].polygon, polygon[away]).max() < 1.0
    assert sharpest_turn(polygon) < 60.0
    assert (held.filled != free.filled).sum() < 6.0 * out_px**2 + 60


def test_a_corrected_point_leads_the_search_to_the_right_edge() -> None:
    # A bag behind the person adds 14 px to the mask, and has an edge of its own.
    t = np.deg2rad(np.linspace(-20, 20, 200))
    unit = np.column_stack([np.cos(t), np.sin(t)])
    bag = np.vstack([CENTRE + 0.5 * AXES * unit, (CENTRE + (AXES + 14) * unit)[::-1]])
    wall = np.full((600, 400, 3), WALL, np.uint8)
    photo = with_noise(draw(draw(wall, bag, (230, 220, 60)), ellipse(), SKIN), 2.0, 4)
    bagged = draw(np.zeros((600, 400, 3), np.uint8), bag, (1, 1, 1))[..., 0]
    mask = np.maximum(rough_mask(shift=0.0, blur=2.0), bagged)
    corrected = on_ellipse(-14.0, -7.0, 0.0, 7.0, 14.0)
    outline = extract_outline(photo, mask.astype(np.float32), corrected, fixed=np.ones(5, dtype=bool))
    between = outline.loops[0].polygon
    between = between[np.abs(np.rad2deg(np.arctan2(*((between - CENTRE) / AXES).T[::-1]))) < 14.0]
    assert cKDTree(ellipse(20000)).query(between)[0].mean() < 1.0


def test_point_beside_a_hole_bends_the_hole() -> None:
    wall = (90, 130, 150)
    canvas = draw(photograph(noise=0.0), ellipse(scale=0.4), wall)
    hole = draw(np.zeros((600, 400, 3), np.uint8), ellipse(scale=0.4), (1, 1, 1))[..., 0]
    mask = (rough_mask(shift=0.0, blur=1.0) - hole).astype(np.float32)
    target = CENTRE + np.array([[0.4 * AXES[0] + 5.0, 0.0]])
    outline = extract_outline(with_noise(canvas, 2.0, 2), np.clip(mask, 0, 1), target, fixed=np.array([True]))
    assert [loop.is_hole for loop in outline.loops] == [False, True]
    assert gap_px(outline.loops[1].polygon, target)[0] < 0.1
    assert 0 in outline.loops[1].feature_rows
