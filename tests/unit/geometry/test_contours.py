"""A disc's outline: distances, normals and hair known in advance."""

import numpy as np
import pytest

from cloner.geometry.outlines.contours import outline_field

CENTRE, RADIUS = np.array([150.0, 120.0]), 80.0


def disc(reduction=1.0, hair=None):
    rows, columns = np.mgrid[0:240, 0:300]
    mask = (columns - CENTRE[0]) ** 2 + (rows - CENTRE[1]) ** 2 <= RADIUS**2
    turn = np.linspace(0.0, 2 * np.pi, 720, endpoint=False)
    contour = CENTRE + RADIUS * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    none = np.zeros_like(mask)
    return outline_field((contour,), mask, none if hair is None else hair, step_px=2.0, reduction=reduction)


@pytest.mark.parametrize("reduction", [1.0, 2.0])
def test_distance_of_a_disc(reduction):
    field = disc(reduction)
    away = np.array([-60.0, -20.0, -5.0, 0.0, 5.0, 20.0])
    turn = np.deg2rad([0.0, 40.0, 90.0, 200.0, 310.0])
    for angle in turn:
        points = CENTRE + (RADIUS + away[:, None]) * [np.cos(angle), np.sin(angle)]
        # OpenCV's 5 x 5 distances are good to 2 %; a cell is one pixel of uncertainty
        assert field.signed_distance(points) == pytest.approx(away, abs=1.5 * reduction)


def test_distance_goes_on_beyond_the_picture():
    field = disc()
    inside_edge, beyond = np.array([[299.0, 120.0]]), np.array([[399.0, 120.0]])
    assert field.signed_distance(beyond) - field.signed_distance(inside_edge) == pytest.approx(100.0, abs=0.1)


def test_normals_point_outwards_whichever_way_the_contour_runs():
    field = disc()
    radial = (field.samples_px - CENTRE) / RADIUS
    assert np.einsum("ka,ka->k", field.normals, radial).min() > 0.99
    spacing = np.linalg.norm(np.diff(field.samples_px, axis=0), axis=1)
    assert spacing == pytest.approx(np.full(len(spacing), 2.0), abs=0.05)


def test_hair_veils_only_the_samples_it_touches():
    hair = np.zeros((240, 300), dtype=bool)
    hair[:80] = True
    field = disc(hair=hair)
    top, bottom = np.array([[150.0, 38.0]]), np.array([[150.0, 203.0]])
    assert field.is_veiled(top)[0]
    assert not field.is_veiled(bottom)[0]
    assert 0.1 < field.veiled.mean() < 0.5


def test_nearest_rim_prefers_a_like_normal_over_a_nearer_point():
    field = disc()
    rightmost = int(np.argmax(field.samples_px[:, 0]))
    points = field.samples_px[rightmost] + np.array([[3.0, 0.0], [8.0, 0.0]])
    index, distance = field.nearest_rim(points, np.array([[-1.0, 0.0], [1.0, 0.0]]), 30.0)
    assert index[rightmost] == 1
    assert distance[rightmost] == pytest.approx(8.0, abs=0.7)
