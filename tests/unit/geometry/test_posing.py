"""Chosen points of a linear shape model in a pose: worked by hand, and derivatives against differences."""

import math

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.geometry.articulation.poses import SIGMAS, pose_matrix, standing_pose
from cloner.geometry.articulation.posing import PointModel, descendants

QUARTER = math.pi / 2


@pytest.fixture
def arm():
    """Return one vertex beyond an elbow; the only coefficient lengthens the arm, the only angle bends the elbow."""
    bend = np.zeros((6, 1))
    bend[5, 0] = 1.0  # the elbow's z angle
    return PointModel(
        mean_m=np.array([[2.0, 0.0, 0.0]]),
        basis_m=np.array([[[0.5], [0.0], [0.0]]]),
        joints_mean_m=np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
        joints_basis_m=np.array([[[0.0], [0.0], [0.0]], [[0.2], [0.0], [0.0]]]),
        parents=np.array([-1, 0], dtype=np.int32),
        skin_joints=np.array([[1, 0]], dtype=np.int32),
        skin_weights=np.array([[1.0, 0.0]]),
        pose=bend,
    )


def test_rest_is_the_mean(arm):
    assert arm.posed(np.zeros(1), np.zeros(1))[0] == pytest.approx([2.0, 0.0, 0.0])


def test_shape_and_pose_act_together(arm):
    # two standard deviations: elbow at 1.4, hand at 3.0; a quarter turn lifts the 1.6 m beyond the elbow
    assert arm.posed(np.array([2.0]), np.array([QUARTER]))[0] == pytest.approx([1.4, 1.6, 0.0])


def test_fewer_coefficients_than_the_basis_mean_zero(arm):
    assert arm.posed(np.zeros(0), np.zeros(1))[0] == pytest.approx([2.0, 0.0, 0.0])


def test_derivatives_of_the_bent_arm(arm):
    # one more standard deviation moves the elbow by 0.2 along x and the hand 0.3 farther along y
    moved = arm.moved(np.array([2.0]), np.array([QUARTER]))
    assert moved.by_shape[0, :, 0] == pytest.approx([0.2, 0.3, 0.0])
    # the hand hangs 1.6 above the elbow: turning on about z moves it towards -x
    assert moved.by_pose[0, :, 0] == pytest.approx([-1.6, 0.0, 0.0])


def test_what_hangs_below_what():
    # 0 - 1 - 2, and 3 beside 1
    below = descendants(np.array([-1, 0, 1, 0]))
    assert below.tolist() == [[1, 1, 1, 1], [0, 1, 1, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


def test_derivatives_of_a_whole_person_agree_with_differences():
    generic, rng = load_generic(), np.random.default_rng(4)
    rows = rng.choice(len(generic.vertices_m), 40)
    whole = PointModel(
        generic.vertices_m[rows].astype(float),
        np.moveaxis(generic.shape_basis[:8, rows], 0, 2).astype(float),
        generic.joints_m.astype(float),
        np.moveaxis(generic.joint_basis[:8], 0, 2).astype(float),
        generic.joint_parents.astype(int),
        generic.skin_joints[rows].astype(int),
        generic.skin_weights[rows].astype(float),
        pose_matrix(generic.joint_names),
    )
    shape = rng.normal(size=8)
    pose = standing_pose(generic.joint_names, whole.joints_mean_m) + SIGMAS * rng.normal(size=len(SIGMAS))
    moved, step = whole.moved(shape, pose), 1e-5
    assert moved.points_m == pytest.approx(whole.posed(shape, pose))
    for axis in range(8):
        change = step * np.eye(8)[axis]
        slope = (whole.posed(shape + change, pose) - whole.posed(shape - change, pose)) / (2.0 * step)
        assert moved.by_shape[..., axis] == pytest.approx(slope, abs=1e-8)
    for axis in range(len(pose)):
        change = step * np.eye(len(pose))[axis]
        slope = (whole.posed(shape, pose + change) - whole.posed(shape, pose - change)) / (2.0 * step)
        assert moved.by_pose[..., axis] == pytest.approx(slope, abs=1e-8)
