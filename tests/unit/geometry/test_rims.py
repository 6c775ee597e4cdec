"""The rim of a sphere is its tangent circle."""

import numpy as np
import pytest
import trimesh

from cloner.geometry.rims import fill_triangles, rim_vertices, vertex_normals
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
    rim, _ = rim_vertices(pixels, vertices, triangles, camera.position_m, (401, 401), 3.0)
    # tangent rays touch where the vertex's angle to the camera direction is acos(1/3)
    heights = vertices[rim, 2]
    assert heights == pytest.approx(np.full(len(rim), RADIUS**2 / DISTANCE), abs=0.08)
    around = np.sort(np.arctan2(vertices[rim, 1], vertices[rim, 0]))
    assert np.diff(around).max() < np.deg2rad(12.0), "the rim closes"


def test_a_ball_before_a_bigger_one_has_no_rim(sphere, camera):
    vertices, triangles = sphere
    small = 0.2 * vertices + [0.0, 0.0, 1.5]
    both, faces = np.vstack([vertices, small]), np.vstack([triangles, triangles + len(vertices)])
    rim, _ = rim_vertices(camera.project(both), both, faces, camera.position_m, (401, 401), 3.0)
    assert len(rim) > 0
    assert rim.max() < len(vertices)
