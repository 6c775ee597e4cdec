"""A sphere settles on a larger circle, smoothly, and stays where nothing pulls."""

import numpy as np
import pytest
import trimesh

from cloner.geometry.outlines.settling import bending_matrix, settle, smoothed_directions, without_folds
from cloner.geometry.outlines.silhouette import triangle_normals, vertex_normals


@pytest.fixture(scope="module")
def sphere():
    mesh = trimesh.creation.icosphere(subdivisions=3, radius=1.0)
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


def settled(sphere, gap, *, anchor=1e-4, slope=1.0, weight=1.0, doubt=(np.inf, np.inf)):
    """Return heights after a front photo wants its rim (near z = 0) moved by ``gap``, one number or one each."""
    vertices, triangles = sphere
    rows = np.flatnonzero(np.abs(vertices[:, 2]) < 0.05)
    ones = np.ones(len(rows))
    heights = settle(
        rows, slope * ones, gap * ones, weight * ones, bending_matrix(triangles, len(vertices)),
        stiffness=1.0, anchor=np.full(len(vertices), anchor), doubt_m=doubt,
    )  # fmt: skip
    return heights, rows


def test_the_rim_reaches_the_larger_circle(sphere):
    vertices, _ = sphere
    heights, rows = settled(sphere, 0.1)
    grown = (1.0 + heights[:, None]) * vertices
    assert np.linalg.norm(grown[rows, :2], axis=1) == pytest.approx(np.full(len(rows), 1.1), abs=0.006)


def test_the_field_between_is_smooth_and_falls_off(sphere):
    vertices, _ = sphere
    heights, _ = settled(sphere, 0.1, anchor=0.01)
    z = np.abs(vertices[:, 2])
    bands = [heights[(z >= low) & (z < low + 0.2)].mean() for low in (0.0, 0.2, 0.4, 0.6, 0.8)]
    assert np.all(np.diff(bands) < 0), "farther from the rim, less motion"
    # a plate that bends swings a little through zero before it rests
    assert abs(bands[-1]) < 0.03


def test_nothing_wanted_nothing_moved(sphere):
    heights, _ = settled(sphere, 0.0)
    assert not heights.any()


def test_a_slope_of_half_needs_twice_the_height(sphere):
    heights, rows = settled(sphere, 0.05, slope=0.5, weight=10.0)
    assert heights[rows].mean() == pytest.approx(0.1, abs=0.005)


def test_a_strong_anchor_holds(sphere):
    heights, _ = settled(sphere, 0.1, anchor=1e4)
    assert np.abs(heights).max() < 1e-4


def test_what_stands_out_of_all_around_is_left_out(sphere):
    vertices, _ = sphere
    rows = np.flatnonzero(np.abs(vertices[:, 2]) < 0.05)
    beside = vertices[rows, 0] > 0.98
    wanted = np.where(beside, 0.4, 0.02)
    heights, _ = settled(sphere, wanted, doubt=(0.02, 0.02))
    assert 0 < beside.sum() < 0.2 * len(rows)
    assert heights[rows] == pytest.approx(np.full(len(rows), 0.02), abs=0.01)
    assert settled(sphere, wanted)[0][rows[beside]].min() > 0.1, "least squares follow it"


def test_of_two_outlines_that_contradict_each_other_the_inner_one_is_believed(sphere):
    vertices, triangles = sphere
    rim = np.flatnonzero(np.abs(vertices[:, 2]) < 0.05)
    rows = np.concatenate([rim, rim])
    wanted = np.where(np.arange(len(rows)) < len(rim), 0.05, -0.05)
    heights = settle(
        rows, np.ones(len(rows)), wanted, np.ones(len(rows)), bending_matrix(triangles, len(vertices)),
        stiffness=1.0, anchor=np.full(len(vertices), 1e-4), doubt_m=(0.02, 0.04),
    )  # fmt: skip
    assert heights[rim].mean() == pytest.approx(-0.05, abs=0.01)


def test_bending_is_blind_to_a_constant_and_sees_a_bump(sphere):
    vertices, triangles = sphere
    bending = bending_matrix(triangles, len(vertices))
    constant, bump = np.ones(len(vertices)), np.zeros(len(vertices))
    bump[0] = 1.0
    assert constant @ bending @ constant == pytest.approx(0.0, abs=1e-9)
    assert bump @ bending @ bump > 1.0


def grid(height):
    """Return vertices (V, 3) and triangles of a 21 x 21 sheet of 10 mm cells with z = height(x)."""
    x, y = (a.ravel() for a in np.meshgrid(np.arange(21) / 100.0, np.arange(21) / 100.0))
    corner = np.arange(441).reshape(21, 21)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]).astype(np.int32)
    return np.stack([x, y, height(x)], axis=1), triangles


def test_directions_out_of_a_crease_no_longer_meet():
    vertices, triangles = grid(lambda x: 1.5 * np.abs(x - 0.1))  # flanks of a valley, 113 degrees between their normals
    normals = vertex_normals(vertices, triangles)
    ways = smoothed_directions(normals, triangles, turns=20)
    assert np.linalg.norm(ways, axis=1) == pytest.approx(np.ones(len(ways)))
    row = np.flatnonzero(np.isclose(vertices[:, 1], 0.1))
    beside = row[np.isclose(np.abs(vertices[row, 0] - 0.1), 0.02)]

    def meet(directions):
        return float(directions[beside[0], 0] - directions[beside[1], 0])

    assert meet(normals) > 1.5
    assert meet(ways) < 0.7 * meet(normals)
    far = np.abs(vertices[:, 0] - 0.1) > 0.09
    assert np.einsum("va,va->v", ways, normals)[far].min() > 0.95, "away from the crease little changes"


def test_a_fold_is_taken_out_and_the_rest_stays():
    vertices, triangles = grid(np.zeros_like)
    moved = vertices + [0.0, 0.0, 0.003]
    middle = 10 * 21 + 10
    moved[middle, 0] += 0.025  # past its neighbour: triangles turn over

    def least_cosine(after):
        before, now = triangle_normals(vertices, triangles), triangle_normals(after, triangles)
        size = np.linalg.norm(before, axis=1) * np.maximum(np.linalg.norm(now, axis=1), 1e-12)
        return float((np.einsum("ta,ta->t", before, now) / size).min())

    assert least_cosine(moved) < 0.0
    flat = without_folds(vertices, moved, triangles)
    assert least_cosine(flat) > 0.5
    # the triangles around it and two rings more: three diagonals of 14 mm
    far = np.linalg.norm(vertices - vertices[middle], axis=1) > 0.043
    np.testing.assert_allclose(flat[far], moved[far], atol=1e-12)


def test_skin_without_folds_is_left_alone():
    vertices, triangles = grid(np.zeros_like)
    moved = vertices + 0.01 * np.sin(20.0 * vertices[:, :1]) * [0.0, 0.0, 1.0]
    np.testing.assert_allclose(without_folds(vertices, moved, triangles), moved, atol=1e-15)
