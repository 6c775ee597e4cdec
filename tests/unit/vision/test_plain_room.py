"""Outlines from feature points alone: the generic human before a plain wall, whose silhouette is known exactly."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.geometry.rims import fill_triangles
from cloner.stages.outlined import body_triangles
from cloner.vision.loops import mask_loops, place_feature_points
from cloner.vision.plain_room import outline_from_points
from kit.drawn import ellipse, photograph, with_noise

HEIGHT, WIDTH, FIGURE = 900, 700, 760.0
CLOTHES = ((190, 150, 130), (60, 80, 150), (70, 60, 50))


def person(turn_degrees: float) -> NDArray[np.bool_]:
    """Return the generic human's silhouette, seen by a camera infinitely far away."""
    vertices = load_generic().vertices_m
    turn = np.deg2rad(turn_degrees)
    across = vertices[:, 0] * np.cos(turn) + vertices[:, 2] * np.sin(turn)
    scale = FIGURE / np.ptp(vertices[:, 1])
    pixels = np.column_stack(
        [WIDTH / 2 + scale * across, HEIGHT - 70 - scale * (vertices[:, 1] - vertices[:, 1].min())]
    )
    return np.asarray(fill_triangles(pixels, body_triangles(), (HEIGHT, WIDTH)) > 0)


def dressed(inside: NDArray[np.bool_], wall: tuple[int, int, int]) -> NDArray[np.uint8]:
    """Return a photo of three colours one below another before one wall, a little blurred and noisy."""
    photo = np.full((HEIGHT, WIDTH, 3), wall, np.uint8)
    for part, colour in enumerate(CLOTHES):
        rows = np.zeros_like(inside)
        rows[HEIGHT * part // 3 : HEIGHT * (part + 1) // 3] = True
        photo[inside & rows] = colour
    return with_noise(cv2.GaussianBlur(photo, (0, 0), 0.6), 2.0, 3)


@pytest.mark.parametrize("turn", [0.0, 40.0, 90.0])
@pytest.mark.parametrize("wall", [(225, 222, 215), (90, 130, 110)])
def test_a_person_s_outline_comes_from_points_two_pixels_off(turn: float, wall: tuple[int, int, int]) -> None:
    truth = person(turn)
    contour = mask_loops(cv2.GaussianBlur(truth.astype(np.float32), (0, 0), 0.7), height_px=FIGURE)[0]
    at = place_feature_points(contour, spacing_px=0.1 * FIGURE, smooth_px=0.01 * FIGURE)
    points = contour.points[at] + np.random.default_rng(5).normal(0.0, 2.0, (len(at), 2))
    outline = outline_from_points(dressed(truth, wall), points)
    overlap = (outline.filled & truth).sum() / (outline.filled | truth).sum()
    assert overlap > 0.97
    away = cKDTree(contour.points).query(outline.loops[0].polygon)[0]
    assert np.median(away) < 0.5


def test_the_points_polygon_alone_would_not_do() -> None:
    points = ellipse(6)
    outline = outline_from_points(photograph(), points)
    away = cKDTree(ellipse(20000)).query(outline.loops[0].polygon)[0]
    assert away.mean() < 0.5
    chords = (points + np.roll(points, -1, axis=0)) / 2
    assert cKDTree(ellipse(20000)).query(chords)[0].mean() > 15.0


def test_two_points_bound_no_outline() -> None:
    with pytest.raises(ValueError, match="three feature points, 2 were given"):
        outline_from_points(photograph(), ellipse(2))
