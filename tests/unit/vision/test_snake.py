"""The structured snake: edges pull, structure holds."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from cloner.vision.contours.snake import Curve, SnakeParams, find_edges, normals, run_snake, snake_picture


def disc(radius: float, centre: tuple[float, float] = (100.3, 99.6), noise: float = 2.0) -> np.ndarray:
    """Return a (200, 200, 1) picture of a bright disc with a soft edge exactly at the radius."""
    y, x = np.mgrid[:200, :200]
    away = np.hypot(x - centre[0], y - centre[1])
    picture = 60.0 + 120.0 / (1.0 + np.exp(np.clip((away - radius) / 0.6, -40, 40)))
    picture += np.random.default_rng(0).normal(0.0, noise, picture.shape)
    return cv2.GaussianBlur(picture.astype(np.float32), (0, 0), 1.0)[..., None]


def ring(radius: float, centre: tuple[float, float] = (100.3, 99.6), count: int = 48) -> np.ndarray:
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.array(centre) + radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)


def radii(points: np.ndarray, centre: tuple[float, float] = (100.3, 99.6)) -> np.ndarray:
    return np.hypot(*(points - centre).T)


@pytest.mark.parametrize("start", [44.0, 46.0, 54.0, 57.0])
def test_a_ring_finds_the_edge_to_a_tenth_of_a_pixel(start):
    curve = Curve(ring(start), True, np.zeros(48), "any")
    found, trust = run_snake(disc(50.0), curve, SnakeParams(reach_px=10.0, spring=0.05, turns=8))
    assert np.median(np.abs(radii(found) - 50.0)) < 0.12
    assert trust.mean() > 0.8


def test_the_normal_lies_to_the_right_of_the_direction_and_signs_tell_edges_apart():
    across = normals(np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), closed=False)
    assert across == pytest.approx(np.array([[0.0, 1.0]] * 3))
    picture = np.full((60, 60, 1), 50.0, np.float32)
    picture[20:40] = 200.0  # a bright band: rising at row 19.5, falling at 39.5, going down
    line = np.stack([np.linspace(10, 50, 9), np.full(9, 30.0)], axis=1)
    for sign, row in (("rising", 19.5), ("falling", 39.5)):
        offset, trust = find_edges(picture, line, np.tile([0.0, 1.0], (9, 1)), 14.0, sign)
        assert 30.0 + offset == pytest.approx(np.full(9, row), abs=0.3)
        assert trust.min() > 0.5


def test_a_dark_line_is_found_in_its_middle():
    picture = np.full((60, 60, 1), 180.0, np.float32)
    picture[33:36] = 40.0
    picture = cv2.GaussianBlur(picture, (0, 0), 1.2)[..., None]
    line = np.stack([np.linspace(10, 50, 9), np.full(9, 30.0)], axis=1)
    found, _ = run_snake(picture, Curve(line, False, np.zeros(9), "line"), SnakeParams(reach_px=8.0, spring=0.5))
    assert found[:, 1] == pytest.approx(np.full(9, 34.0), abs=0.35)


def test_structure_bridges_what_has_no_edge():
    """Half the disc's edge is painted over; the springs carry the rest on by the same amount."""
    picture = disc(50.0)
    picture[:100] = 60.0
    start = ring(45.0)
    free, _ = run_snake(
        picture, Curve(start, True, np.zeros(48), "any"), SnakeParams(reach_px=8.0, spring=1.5, turns=8)
    )
    below = start[:, 1] > 110.0
    assert np.median(np.abs(radii(free)[below] - 50.0)) < 0.8
    shape = np.linalg.norm(np.diff(free, axis=0), axis=1) / np.linalg.norm(np.diff(start, axis=0), axis=1)
    assert shape.min() > 0.6
    assert shape.max() < 1.6


def test_nothing_is_pulled_over_an_even_picture_and_anchors_hold():
    even = np.full((200, 200, 3), 90.0, np.float32)
    start = ring(45.0)
    still, trust = run_snake(even, Curve(start, True, np.zeros(48), "any"), SnakeParams(reach_px=8.0))
    assert np.abs(still - start).max() < 1e-6
    assert trust.max() < 1e-6
    anchors = np.zeros(48)
    anchors[0] = 1000.0
    held, _ = run_snake(disc(50.0), Curve(start, True, anchors, "any"), SnakeParams(reach_px=8.0))
    assert np.linalg.norm(held[0] - start[0]) < 0.05
    assert abs(radii(held)[24] - 50.0) < 1.0


def test_the_snakes_picture_maps_photo_pixels_onto_its_own():
    rgb = np.zeros((400, 300, 3), np.uint8)
    rgb[200:, :] = 200
    points = np.array([[100.0, 200.0], [180.0, 205.0]])
    picture, to_small = snake_picture(rgb, points, unit_px=120.0, unit=40.0)
    edge = np.array([140.0, 199.5]) @ to_small[:, :2].T + to_small[:, 2]
    column = picture[:, round(edge[0]), 0]
    assert np.interp(100.0, column, np.arange(len(column))) == pytest.approx(edge[1], abs=0.15)
