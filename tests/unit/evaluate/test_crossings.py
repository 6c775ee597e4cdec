"""Meshes that go through themselves or each other are told, with how deep; sound ones are not."""

import numpy as np
import pytest
import trimesh

from cloner.evaluate.measures.crossings import (
    buried_depths,
    intersections_between,
    self_intersections,
    visible_triangles,
    winding_numbers,
)
from cloner.geometry.cameras.viewpoints import framing_camera


def ball(radius_m, centre_m, count=3):
    """Return points and outward triangles of a ball."""
    made = trimesh.creation.icosphere(subdivisions=count, radius=radius_m)
    return np.asarray(made.vertices) + centre_m, np.asarray(made.faces)


def two_balls(apart_m):
    """Return one mesh of two balls of 10 cm whose middles are so far apart, slightly askew."""
    first, faces = ball(0.1, [0.0, 0.0, 0.0])
    second, _ = ball(0.1, [apart_m, 0.003, 0.002])
    return np.vstack([first, second]), np.vstack([faces, faces + len(first)])


def test_a_ball_does_not_cross_itself():
    points, faces = ball(0.1, [0.3, 0.2, 0.1])
    assert len(self_intersections(points, faces).pairs) == 0


@pytest.mark.parametrize("apart_m", [0.15, 0.18])
def test_two_balls_in_each_other_cross_in_a_ring_of_known_size(apart_m):
    points, faces = two_balls(apart_m)
    found = self_intersections(points, faces)
    assert len(found.pairs) > 20
    ring = np.sqrt(0.1**2 - (apart_m / 2) ** 2)
    away = np.linalg.norm(found.places_m - points.mean(axis=0), axis=1)
    assert away == pytest.approx(ring, abs=0.004)
    depths = buried_depths(points, faces, found)
    assert depths.max() == pytest.approx(0.2 - apart_m, abs=0.005)
    assert 0 < (depths > 0).sum() < len(points) / 4


def test_balls_apart_do_not_cross():
    points, faces = two_balls(0.21)
    assert len(self_intersections(points, faces).pairs) == 0


def test_small_triangles_find_the_large_one_that_they_pierce():
    small, faces = ball(0.01, [0.01, 0.02, 0.0])
    large = np.array([[[-1.0, -1.0, 0.001], [1.0, -1.0, 0.001], [0.0, 1.5, 0.001]]])
    found = intersections_between(small[faces], large)
    assert len(found.pairs) > 10
    assert set(found.pairs[:, 1]) == {0}
    assert found.places_m[:, 2] == pytest.approx(0.001, abs=1e-9)
    assert len(intersections_between(small[faces], large + [0.0, 0.0, 0.02]).pairs) == 0


def test_windings_count_the_parts_around_a_place():
    points, faces = two_balls(0.15)
    places = np.array([[0.075, 0.0, 0.0], [-0.08, 0.0, 0.0], [0.2, 0.02, 0.0], [0.0, 0.2, 0.0]])
    assert winding_numbers(places, points[faces]).tolist() == [2, 1, 1, 0]


def test_an_onlooker_sees_the_nearer_ball():
    points, faces = two_balls(0.3)
    camera = framing_camera(points, 90.0, 200, 200)
    rows, depth = visible_triangles(points, faces, camera)
    seen = rows[rows >= 0]
    assert (seen >= len(faces) // 2).all(), "the ball at +x hides the other"
    assert np.isinf(depth[rows < 0]).all()
    assert depth[rows >= 0].min() == pytest.approx(camera.to_camera(points)[:, 2].min(), abs=0.002)
