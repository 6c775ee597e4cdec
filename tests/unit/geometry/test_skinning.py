"""Joint transforms and linear blend skinning against positions worked by hand."""

import math

import numpy as np
import pytest

from cloner.geometry.articulation.skinning import (
    blend_transforms,
    joint_transforms,
    linear_blend_skinning,
    rotation_matrices,
)

#: A root at the origin, an elbow one metre to the left, a wrist two metres to the left.
CHAIN = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]])
PARENTS = np.array([-1, 0, 1])
QUARTER = math.pi / 2


def turned(**joints):
    rotations = np.zeros((3, 3))
    for name, vector in joints.items():
        rotations[("root", "elbow", "wrist").index(name)] = vector
    return joint_transforms(CHAIN, PARENTS, rotations)


def moved(transform, point):
    return transform[:3, :3] @ point + transform[:3, 3]


def test_a_quarter_turn_takes_x_to_y():
    matrix = rotation_matrices(np.array([[0.0, 0.0, QUARTER]]))[0]
    assert matrix @ [1.0, 0.0, 0.0] == pytest.approx([0.0, 1.0, 0.0], abs=1e-12)
    assert matrix @ [0.0, 0.0, 1.0] == pytest.approx([0.0, 0.0, 1.0], abs=1e-12)


def test_no_turn_is_the_identity_and_any_turn_keeps_lengths():
    assert np.array_equal(rotation_matrices(np.zeros((1, 3)))[0], np.eye(3))
    vectors = np.random.default_rng(5).normal(size=(20, 3))
    matrices = rotation_matrices(vectors)
    assert matrices @ matrices.transpose(0, 2, 1) == pytest.approx(np.broadcast_to(np.eye(3), (20, 3, 3)), abs=1e-12)
    assert np.linalg.det(matrices) == pytest.approx(np.ones(20))


def test_an_elbow_bends_what_hangs_on_it_and_nothing_else():
    root, elbow, wrist = turned(elbow=[0.0, 0.0, QUARTER])
    assert np.array_equal(root, np.eye(4))
    assert moved(elbow, CHAIN[1]) == pytest.approx(CHAIN[1]), "a joint turns about itself"
    assert moved(wrist, CHAIN[2]) == pytest.approx([1.0, 1.0, 0.0])


def test_turns_add_along_the_chain():
    _, elbow, wrist = turned(root=[0.0, 0.0, QUARTER], elbow=[0.0, 0.0, QUARTER])
    assert moved(elbow, CHAIN[1]) == pytest.approx([0.0, 1.0, 0.0])
    assert moved(wrist, CHAIN[2]) == pytest.approx([-1.0, 1.0, 0.0])


def test_a_vertex_between_two_joints_goes_half_way():
    transforms = turned(elbow=[0.0, 0.0, QUARTER])
    vertex = np.array([[1.5, 0.0, 0.0]])
    # the root leaves it at (1.5, 0), the elbow takes it to (1, 0.5)
    placed = linear_blend_skinning(vertex, transforms, np.array([[0, 1]]), np.array([[0.5, 0.5]]))
    assert placed[0] == pytest.approx([1.25, 0.25, 0.0])
    assert blend_transforms(transforms, np.array([[0, 1]]), np.array([[1.0, 0.0]]))[0] == pytest.approx(np.eye(4)[:3])
