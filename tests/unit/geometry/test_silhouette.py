"""The rim of a sphere is its tangent circle."""

import numpy as np
import pytest
import trimesh

from cloner.geometry.outlines.silhouette import fill_triangles, silhouette_vertices, vertex_normals
from cloner.records.views import Camera

RADIUS, DISTANCE, FOCAL = 1.0, 3.0, 300.0


@pytest.fixture(scope="module")
def sphere():
    mesh = trimesh.creation.icosphere(subdivisions=4, radius=RADIUS)
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


@pytest.fixture(scope="module")
def camera():
    matrix = np.diag([1.0, -1.0, -1.0, 1.0])
    matrix[2, 3] = DISTANCE
    return Camera(401, 401, FOCAL, matrix)


def test_normals_of_a_sphere_point_outwards(sphere):
    vertices, triangles = sphere
    normals = vertex_normals(vertices, triangles)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(np.ones(len(normals)))
    assert np.einsum("va,va->v", normals, vertices).min() > 0.999


def test_the_picture_of_a_sphere_has_its_area(sphere, camera):
    vertices, triangles = sphere
    picture = fill_triangles(camera.project(vertices), triangles, (401, 401))
    # a sphere seen from 3 radii fills asin(1/3) on each side; touched pixels add half a pixel
    radius = FOCAL * np.tan(np.arcsin(RADIUS / DISTANCE))
    assert set(np.unique(picture)) == {0, 255}
    assert np.pi * (radius - 1.0) ** 2 < (picture > 0).sum() < np.pi * (radius + 1.5) ** 2
    assert picture[200, 200] == 255
    assert picture[0, 0] == 0


def test_rim_vertices_lie_on_the_tangent_circle(sphere, camera):
    vertices, triangles = sphere
    pixels = camera.project(vertices)
    rim, _ = silhouette_vertices(pixels, vertices, triangles, camera.position_m, (401, 401), 3.0)
    # tangent rays touch where the vertex's angle to the camera direction is acos(1/3)
    heights = vertices[rim, 2]
    assert heights == pytest.approx(np.full(len(rim), RADIUS**2 / DISTANCE), abs=0.08)
    around = np.sort(np.arctan2(vertices[rim, 1], vertices[rim, 0]))
    assert np.diff(around).max() < np.deg2rad(12.0), "the rim closes"


def test_a_ball_before_a_bigger_one_has_no_rim(sphere, camera):
    vertices, triangles = sphere
    small = 0.2 * vertices + [0.0, 0.0, 1.5]
    both, faces = np.vstack([vertices, small]), np.vstack([triangles, triangles + len(vertices)])
    rim, _ = silhouette_vertices(camera.project(both), both, faces, camera.position_m, (401, 401), 3.0)
    assert len(rim) > 0
    assert rim.max() < len(vertices)


def test_the_rim_of_a_part_is_the_part_of_the_rim(sphere, camera):
    """A small ball stands beside a large one; asked for the small one's rim alone, nothing else is looked at."""
    vertices, triangles = sphere
    small = 0.3 * vertices + (0.9, 0.0, 0.0)
    both = np.concatenate([vertices, small])
    faces = np.concatenate([triangles, triangles + len(vertices)])
    seen = (camera.project(both), both, faces, camera.position_m, (401, 401), 3.0)
    part = np.arange(len(both)) >= len(vertices)
    whole, picture = silhouette_vertices(*seen)
    rim, filled = silhouette_vertices(*seen, among=part)
    assert 20 < len(rim) < len(whole)
    assert np.array_equal(rim, whole[part[whole]])
    assert 0 < np.count_nonzero(filled) < np.count_nonzero(picture), "the rest is not drawn"


def test_what_lies_beyond_the_picture_changes_nothing(sphere, camera):
    vertices, triangles = sphere
    pixels = camera.project(vertices)
    aside = np.concatenate([pixels, pixels + (500.0, 0.0), pixels - (0.0, 500.0)])
    faces = np.concatenate([triangles + k * len(vertices) for k in range(3)])
    assert np.array_equal(fill_triangles(aside, faces, (401, 401)), fill_triangles(pixels, triangles, (401, 401)))


def test_a_triangle_whose_corners_all_lie_outside_is_seen_where_it_crosses_the_picture():
    corners = np.array([[-300.0, -50.0], [500.0, -50.0], [100.0, 900.0]])
    assert fill_triangles(corners, np.array([[0, 1, 2]]), (60, 80)).all()


def test_layers_before_each_other_fill_one_picture():
    """A square before a larger one, and one that overlaps it by half: no hole where two are seen."""
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    corners = np.concatenate([10.0 + 40.0 * square, 20.0 + 10.0 * square, 40.0 + 40.0 * square])
    faces = np.concatenate([np.array([[0, 1, 2], [0, 2, 3]]) + 4 * k for k in range(3)])
    picture = fill_triangles(corners, faces, (100, 100)) > 0
    wanted = np.zeros((100, 100), dtype=bool)
    wanted[10:51, 10:51] = wanted[40:81, 40:81] = True
    assert np.array_equal(picture, wanted)
