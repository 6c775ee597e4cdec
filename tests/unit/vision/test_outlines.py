"""Drawn figures whose outline is known, photographed badly."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.vision.contours.band import LinkParams, band_reach
from cloner.vision.contours.edges import detect_edges, refine_subpixel
from cloner.vision.contours.loops import fill_polygon, fill_polygons, mask_loops, signed_area
from cloner.vision.contours.outlines import Outline, extract_outline
from kit.drawn import AXES, CENTRE, HEIGHT, SKIN, WALL, WIDTH, draw, ellipse, photograph, rough_mask, with_noise


def distances(outline: Outline) -> NDArray[np.float64]:
    return np.asarray(cKDTree(ellipse(20000)).query(outline.loops[0].polygon)[0])


@pytest.mark.parametrize("noise", [0.0, 3.0, 8.0])
def test_outline_lies_on_the_edge_in_spite_of_a_wavy_mask_and_noise(noise: float) -> None:
    photo, mask = photograph(noise=noise), rough_mask()
    before = photo.copy(), mask.copy()
    outline = extract_outline(photo, mask)
    assert distances(outline).mean() < 0.35
    assert np.percentile(distances(outline), 95) < 1.0
    assert set(outline.loops[0].sources) == {"edges"}
    np.testing.assert_array_equal(photo, before[0])
    np.testing.assert_array_equal(mask, before[1])


def test_given_feature_points_bound_the_segments() -> None:
    points = ellipse(8) + np.array([2.0, -1.0])
    outline = extract_outline(photograph(), rough_mask(), points)
    loop = outline.loops[0]
    assert sorted(loop.feature_rows.tolist()) == list(range(8))
    assert len(loop.sources) == len(loop.goodness) == len(loop.covered) == 8
    assert np.linalg.norm(loop.feature_points - points[loop.feature_rows], axis=1).max() < 8.0
    assert distances(outline).mean() < 0.35


def test_gap_in_the_edge_is_bridged() -> None:
    photo = photograph()
    # The wall takes the skin's colour beside a fifteenth of the outline.
    photo[290:330, 300:] = with_noise(np.full((40, 100, 3), SKIN, np.uint8), 3.0, 1)
    outline = extract_outline(photo, rough_mask())
    assert np.percentile(distances(outline), 95) < 1.5
    # In the gap the mask's contour, 3 px off at most, stands in.
    assert distances(outline).max() < 4.5


def test_crossing_background_lines_do_not_lead_away() -> None:
    canvas = np.full((HEIGHT, WIDTH, 3), WALL, np.uint8)
    for y in range(40, HEIGHT, 60):
        canvas[y : y + 14] = (245, 245, 245)
    photo = with_noise(draw(canvas, ellipse(), SKIN), 3.0, 3)
    outline = extract_outline(photo, rough_mask())
    assert distances(outline).mean() < 0.6
    assert distances(outline).max() < 5.0


@pytest.mark.parametrize("offset", [5.0, -5.0])
def test_parallel_decoy_edge_is_refused(offset: float) -> None:
    # A strong line just outside (a poster) or just inside (a seam); the mask lies between.
    photo = photograph(noise=0.0)
    t = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    line = CENTRE + (AXES + offset) * np.column_stack([np.cos(t), np.sin(t)])
    colour = (20, 20, 20) if offset > 0 else (250, 240, 235)
    fixed = np.rint(line * 16).astype(np.int32)
    cv2.polylines(photo, [fixed], True, colour, 1, cv2.LINE_AA, 4)
    outline = extract_outline(with_noise(photo, 2.0, 5), rough_mask(shift=1.5))
    assert np.median(distances(outline)) < 1.0


def test_mask_stands_in_where_there_is_no_edge() -> None:
    photo = photograph(wall=SKIN, noise=3.0)
    mask = rough_mask(shift=0.0)
    outline = extract_outline(photo, mask)
    assert set(outline.loops[0].sources) == {"mask"}
    assert distances(outline).max() < 1.5


def test_holes_are_contours_of_their_own() -> None:
    canvas = draw(photograph(noise=0.0), ellipse(scale=0.4), WALL)
    hole = fill_polygon(ellipse(scale=0.42), (HEIGHT, WIDTH)).astype(np.float32)
    mask = rough_mask(shift=2.0) - cv2.GaussianBlur(hole, (0, 0), 4.0)
    outline = extract_outline(with_noise(canvas, 3.0, 2), np.clip(mask, 0, 1).astype(np.float32))
    assert [loop.is_hole for loop in outline.loops] == [False, True]
    gaps = cKDTree(ellipse(20000, scale=0.4)).query(outline.loops[1].polygon)[0]
    assert gaps.mean() < 0.4
    assert not outline.filled[301, 200]
    area = np.pi * AXES.prod() * (1 - 0.16)
    assert outline.filled.sum() == pytest.approx(area, rel=0.005)


def test_figure_cut_by_the_picture_s_border_is_closed_there() -> None:
    photo, mask = photograph()[:300], rough_mask()[:300]
    outline = extract_outline(photo, mask)
    polygon = outline.loops[0].polygon
    assert polygon[:, 1].max() == pytest.approx(299.5, abs=0.51)
    truth = fill_polygon(ellipse(), (HEIGHT, WIDTH))[:300]
    overlap = (outline.filled & truth).sum() / (outline.filled | truth).sum()
    assert overlap > 0.99


def test_nobody_in_the_mask_gives_no_outline() -> None:
    outline = extract_outline(photograph(), np.zeros((HEIGHT, WIDTH), np.float32))
    assert outline.loops == ()
    assert not outline.filled.any()


def test_filled_polygon_holds_the_pixels_whose_centres_it_encloses() -> None:
    square = np.array([[1.5, 1.5], [4.5, 1.5], [4.5, 3.5], [1.5, 3.5]])
    filled = fill_polygon(square, (6, 7))
    expected = np.zeros((6, 7), dtype=bool)
    expected[2:4, 2:5] = True
    np.testing.assert_array_equal(filled, expected)
    np.testing.assert_array_equal(fill_polygons([square[::-1]], [False], (6, 7)), expected)


def test_mask_contour_walks_with_the_person_on_one_side() -> None:
    mask = rough_mask(shift=0.0) * (1 - fill_polygon(ellipse(scale=0.4), (HEIGHT, WIDTH)))
    outer, hole = mask_loops(mask.astype(np.float32), height_px=480.0)
    assert signed_area(outer.points) > 0 > signed_area(hole.points)
    for loop, outward in ((outer, 1.0), (hole, -1.0)):
        radial = (loop.points - CENTRE) / AXES**2
        assert ((radial * loop.inward).sum(axis=1) * outward < 0).all()


@pytest.mark.parametrize("shift", [0.0, 0.3, 0.5, 0.8])
def test_sub_pixel_edge_position(shift: float) -> None:
    rgb = np.full((40, 60, 3), 60, np.uint8)
    edge = np.array([[30 + shift, -5.0], [80.0, -5.0], [80.0, 60.0], [30 + shift, 60.0]])
    rgb = draw(rgb, edge, (60, 200, 60))
    edges = detect_edges(rgb)
    rows, columns = np.nonzero(edges.edges)
    points = refine_subpixel(edges, np.column_stack([columns, rows]).astype(float))
    inner = (points[:, 1] > 4) & (points[:, 1] < 35)
    assert inner.sum() >= 25
    assert np.abs(points[inner, 0] - (30 + shift)).max() < 0.12


def test_red_on_green_of_equal_brightness_is_an_edge() -> None:
    rgb = np.zeros((40, 60, 3), np.uint8)
    rgb[:, :30, 0] = 120
    rgb[:, 30:, 1] = 120
    assert detect_edges(rgb).edges[5:35, 28:32].any(axis=1).all()


def test_band_is_wide_only_where_the_mask_is_in_doubt() -> None:
    figure = fill_polygon(ellipse(), (HEIGHT, WIDTH)).astype(np.float32)
    sure, vague = cv2.GaussianBlur(figure, (0, 0), 0.8), cv2.GaussianBlur(figure, (0, 0), 6.0)
    mask = np.where(np.arange(HEIGHT)[:, None] < 300, sure, vague).astype(np.float32)
    loop = mask_loops(mask, height_px=480.0)[0]
    params = LinkParams()
    reach = band_reach(mask, loop, height_px=480.0, params=params)
    above, below = reach[loop.points[:, 1] < 270], reach[loop.points[:, 1] > 330]
    assert above.max() < 3.0
    assert below.min() > 0.8 * params.band * 480.0


@pytest.mark.parametrize("radius", [60.3, 151.7])
@pytest.mark.parametrize("noise", [0.0, 3.0])
def test_disc_comes_back_to_a_tenth_of_a_pixel(radius: float, noise: float) -> None:
    centre = np.array([180.37, 190.61])
    t = np.linspace(0, 2 * np.pi, 6000, endpoint=False)
    disc = centre + radius * np.column_stack([np.cos(t), np.sin(t)])
    photo = with_noise(draw(np.full((380, 360, 3), WALL, np.uint8), disc, SKIN), noise, 11)
    coarse = fill_polygon(centre + np.array([1.5, -1.0]) + 1.005 * (disc - centre), (380, 360)).astype(np.float32)
    outline = extract_outline(photo, cv2.GaussianBlur(coarse, (0, 0), 2.5))
    error = np.linalg.norm(outline.loops[0].polygon - centre, axis=1) - radius
    assert np.abs(error).mean() < 0.12
    assert abs(error.mean()) < 0.06  # neither fat nor thin


@pytest.mark.parametrize("step", [8, 14])
def test_on_low_contrast_the_links_are_nearer_than_the_mask(step: int) -> None:
    wall = (SKIN[0] - step, SKIN[1] - step, SKIN[2] - step)
    photo, mask = photograph(wall=wall, noise=2.0), rough_mask(shift=3.0, blur=4.0)
    outline = extract_outline(photo, mask)
    mask_error = cKDTree(ellipse(20000)).query(mask_loops(mask, height_px=480.0)[0].points)[0].mean()
    assert distances(outline).mean() < 0.8 * mask_error


def test_canny_thresholds_follow_the_photo_s_noise() -> None:
    quiet, loud = (detect_edges(photograph(noise=noise)) for noise in (2.0, 6.0))
    assert loud.low > 1.5 * quiet.low
    assert loud.high == pytest.approx(2.0 * loud.low)
    for found in (quiet, loud):
        assert found.edges[5:55, 5:100].mean() < 0.002  # the flat wall
        rows, columns = np.nonzero(found.edges)
        on = cKDTree(np.column_stack([columns, rows])).query(ellipse(600))[0] < 1.5
        assert on.mean() > 0.98
