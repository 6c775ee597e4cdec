"""T_i,m on a tube worked by hand: two silhouette pixels a slice, reproduced exactly."""

import numpy as np
import pytest

from cloner.geometry.outlines.contours import outline_field
from cloner.geometry.outlines.slices import (
    PosedBody,
    SlicePairs,
    aspect_shift,
    fine_shift,
    occluding_pairs,
    rest_lift,
    slice_weight,
)

PIXELS_PER_M = 1000.0
RADIUS_M = 0.10
LEVELS = np.array([0.25, 0.5, 0.75])
#: Silhouette of the photo: columns 370..590 are the person, the tube is drawn at 400..600.
LEFT_PX, RIGHT_PX = 369.5, 590.5


@pytest.fixture(scope="module")
def tube():
    """Return rest vertices (V, 3), s and theta of an upright tube of 9 rings with 24 vertices each."""
    s, theta = (grid.ravel() for grid in np.meshgrid(np.linspace(0.1, 0.9, 9), np.arange(24) * np.pi / 12))
    vertices = np.stack([RADIUS_M * np.sin(theta), 0.8 - 0.6 * s, RADIUS_M * np.cos(theta)], axis=1)
    return vertices, s, theta


@pytest.fixture(scope="module")
def body(tube):
    """Return the tube through an orthographic camera in front, 1 mm a pixel, axis on column 500."""
    vertices, _, _ = tube
    pixels = np.stack([500.0 + PIXELS_PER_M * vertices[:, 0], 1000.0 - PIXELS_PER_M * vertices[:, 1]], axis=1)
    rest = np.tile(np.eye(4)[:3], (len(vertices), 1, 1))
    lift = rest_lift(rest, np.diag([1.0, -1.0, -1.0]), np.full(len(vertices), 1.0 / PIXELS_PER_M))
    return PosedBody(pixels, np.zeros((94, 2)), np.ones(len(vertices), dtype=bool), lift)


@pytest.fixture(scope="module")
def photo():
    mask = np.zeros((1000, 1000), dtype=bool)
    mask[100:950, 370:591] = True
    corners = np.array([[369.5, 99.5], [590.5, 99.5], [590.5, 949.5], [369.5, 949.5]])
    return outline_field((corners,), mask, np.zeros_like(mask), step_px=2.0, reduction=1.0)


def find(tube, body, photo, reach_px=60.0):
    vertices, s, theta = tube
    axis = (np.array([500.0, 200.0]), np.array([500.0, 800.0]))
    return occluding_pairs(body, np.arange(len(vertices)), s, theta, axis, LEVELS, photo, reach_px)


def test_a_pixel_lifts_to_a_millimetre_in_the_plane(body):
    assert body.lift[0] @ [3.0, 4.0] == pytest.approx([0.003, -0.004, 0.0])


def test_occluding_points_are_the_leftmost_and_rightmost(tube, body, photo):
    pairs = find(tube, body, photo)
    assert pairs.valid.all()
    assert np.degrees(pairs.theta) % 360 == pytest.approx(np.tile([270.0, 90.0], (3, 1)))
    assert pairs.shift_m[:, 0] == pytest.approx(np.tile([LEFT_PX / 1000 - 0.4, 0, 0], (3, 1)), abs=1e-4)
    assert pairs.shift_m[:, 1] == pytest.approx(np.tile([RIGHT_PX / 1000 - 0.6, 0, 0], (3, 1)), abs=1e-4)


def test_slices_reproduce_both_silhouette_pixels(tube, body, photo):
    vertices, s, theta = tube
    moved = vertices + fine_shift(find(tube, body, photo), s, theta, smooth=0.0)
    columns = 500.0 + PIXELS_PER_M * moved[:, 0]
    for level in np.unique(s):
        ring = np.isclose(s, level)
        assert columns[ring].min() == pytest.approx(LEFT_PX, abs=0.1)
        assert columns[ring].max() == pytest.approx(RIGHT_PX, abs=0.1)
    assert moved[:, 1:] == pytest.approx(vertices[:, 1:], abs=1e-12), "a front photo moves nothing up or forwards"


def test_a_hidden_or_far_silhouette_is_not_believed(tube, body, photo):
    assert not find(tube, body, photo, reach_px=8.0).valid.any()
    hidden = PosedBody(body.pixels, body.joints_px, np.zeros(len(body.pixels), dtype=bool), body.lift)
    pairs = find(tube, hidden, photo)
    assert not pairs.valid.any()
    assert not fine_shift(pairs, tube[1], tube[2], smooth=1.0).any()


def test_weight_is_one_at_the_first_and_zero_at_the_second():
    first, second = np.full(5, np.deg2rad(270.0)), np.full(5, np.deg2rad(90.0))
    theta = np.deg2rad([270.0, 90.0, 0.0, 180.0, 315.0])
    assert slice_weight(theta, first, second) == pytest.approx([1.0, 0.0, 0.5, 0.5, 0.75], abs=1e-9)


def test_weight_on_unequal_arcs_goes_by_arc_length():
    # arcs of 120 and 240 degrees between the two points
    theta = np.deg2rad([60.0, 240.0, 300.0])
    weight = slice_weight(theta, np.zeros(3), np.full(3, np.deg2rad(120.0)))
    assert weight == pytest.approx([0.5, 0.5, 0.75])


def test_a_gap_is_filled_from_its_neighbours_and_an_unseen_side_stays():
    shift = np.zeros((3, 2, 3))
    shift[[0, 2], 0, 0] = 0.01, 0.03
    valid = np.array([[True, False], [False, False], [True, False]])
    pairs = SlicePairs(LEVELS, np.tile([0.0, np.pi], (3, 1)), shift, valid, np.zeros((3, 2), dtype=np.int64))
    found = fine_shift(pairs, np.array([0.5, 0.5, 0.25]), np.array([0.0, np.pi, 0.0]), smooth=0.0)
    assert found[:, 0] == pytest.approx([0.02, 0.0, 0.01])


def test_unseen_depth_grows_as_the_seen_width_about_the_same_axis(tube, body, photo):
    vertices, s, _ = tube
    pairs = find(tube, body, photo)
    moved = aspect_shift(pairs, vertices, vertices, s, smooth=0.0)
    # the tube is 200 mm wide and the photo shows 221 mm
    ratio = (RIGHT_PX - LEFT_PX) / 200.0
    assert moved[:, 2] == pytest.approx((ratio - 1.0) * vertices[:, 2], abs=2e-4)
    assert moved[:, :2] == pytest.approx(np.zeros((len(vertices), 2)), abs=1e-9)


def test_depth_stays_where_the_photo_shows_no_width(tube, body, photo):
    hidden = PosedBody(body.pixels, body.joints_px, body.pixels[:, 0] > 500.0, body.lift)
    pairs = find(tube, hidden, photo)
    assert pairs.valid.any(axis=0).tolist() == [False, True], "one side alone is no width"
    assert not aspect_shift(pairs, tube[0], tube[0], tube[1], smooth=0.0).any()
