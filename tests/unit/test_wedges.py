"""Seams split the mesh, not its normals."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces, load_triangles, surface_normals
from cloner.geometry.meshes.wedges import split_seams, triangulate, vertex_normals


def test_a_quad_gives_two_triangles_and_a_repeated_corner_one():
    triangles, corners = triangulate(np.array([[0, 1, 2, 3], [4, 5, 6, 6]], dtype=np.int32))
    assert triangles.tolist() == [[0, 1, 2], [0, 2, 3], [4, 5, 6]]
    assert corners.tolist() == [[0, 1, 2], [0, 2, 3], [4, 5, 6]]


def test_a_vertex_with_two_texture_places_is_doubled():
    triangles = np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)
    uv = np.array([[0, 1, 2], [4, 2, 3]], dtype=np.int32)
    wedges = split_seams(triangles, uv)
    assert np.bincount(wedges.vertex).tolist() == [2, 1, 1, 1]
    assert (wedges.vertex[wedges.triangles] == triangles).all()
    assert (wedges.uv[wedges.triangles] == uv).all()


def test_normals_of_a_sphere_point_outwards():
    ball = trimesh.creation.icosphere(subdivisions=2)
    normals = vertex_normals(np.array(ball.vertices), np.array(ball.faces, dtype=np.int32))
    assert np.einsum("ij,ij->i", normals, ball.vertices).min() > np.cos(np.radians(1.0))


def test_normals_do_not_depend_on_how_a_cube_s_faces_are_cut():
    corner = np.array([[x, y, z] for x in (-1.0, 1) for y in (-1.0, 1) for z in (-1.0, 1)])
    quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]], np.int32)
    normals = vertex_normals(corner, triangulate(quads)[0])
    assert normals == pytest.approx(corner / np.sqrt(3))


def test_surfaces_hold_every_triangle_once_and_smooth_normals_over_seams():
    surfaces = load_surfaces()
    assert [surface.name for surface in surfaces] == ["body", "eyes", "mouth", "lashes"]
    assert sum(len(surface.triangles) for surface in surfaces) == len(load_triangles())
    body = surfaces[0]
    assert len(body.vertex) > len(np.unique(body.vertex)), "the atlas has seams"
    normals = surface_normals(load_generic().vertices_m.astype(float))
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1.0)
    assert all(((surface.uv >= 0) & (surface.uv <= 1)).all() for surface in surfaces)
