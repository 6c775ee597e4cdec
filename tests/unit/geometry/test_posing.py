"""Chosen vertices of a linear shape model in a pose, and cameras moved about a pivot, worked by hand."""

import math

import numpy as np
import pytest

from cloner.geometry.posing import Chosen, moved_camera

QUARTER = math.pi / 2


@pytest.fixture
def arm():
    """Return one vertex beyond an elbow; the only coefficient lengthens the arm, the only angle bends the elbow."""
    bend = np.zeros((6, 1))
    bend[5, 0] = 1.0  # the elbow's z angle
    return Chosen(
        mean_m=np.array([[2.0, 0.0, 0.0]]),
        basis_m=np.array([[0.5, 0.0, 0.0]]),
        joints_mean_m=np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
        joints_basis_m=np.array([[0.0, 0.0, 0.0, 0.2, 0.0, 0.0]]),
        parents=np.array([-1, 0], dtype=np.int32),
        skin_joints=np.array([[1, 0]], dtype=np.int32),
        skin_weights=np.array([[1.0, 0.0]]),
        pose=bend,
    )


def test_rest_is_the_mean(arm):
    vertices, joints = arm.posed(np.zeros(1), np.zeros(1))
    assert vertices[0] == pytest.approx([2.0, 0.0, 0.0])
    assert joints[1] == pytest.approx([1.0, 0.0, 0.0])


def test_shape_and_pose_act_together(arm):
    # two standard deviations: elbow at 1.4, hand at 3.0; a quarter turn lifts the 1.6 m beyond the elbow
    vertices, joints = arm.posed(np.array([2.0]), np.array([QUARTER]))
    assert joints[1] == pytest.approx([1.4, 0.0, 0.0])
    assert vertices[0] == pytest.approx([1.4, 1.6, 0.0])


def test_fewer_coefficients_than_the_basis_mean_zero(arm):
    assert arm.posed(np.zeros(0), np.zeros(1))[0][0] == pytest.approx([2.0, 0.0, 0.0])


def test_a_camera_turns_about_its_pivot_and_then_shifts():
    camera = np.eye(4)
    camera[:3, 3] = [0.1, 0.2, 3.0]
    pivot = np.array([0.0, 1.0, 0.0])
    turned = moved_camera(camera, np.array([0.0, 0.0, QUARTER, 0.0, 0.0, 0.0]), pivot)
    shifted = moved_camera(camera, np.array([0.0, 0.0, QUARTER, 0.01, 0.02, 0.03]), pivot)
    before = camera[:3, :3] @ pivot + camera[:3, 3]
    assert turned[:3, :3] @ pivot + turned[:3, 3] == pytest.approx(before)
    assert shifted[:3, 3] - turned[:3, 3] == pytest.approx([0.01, 0.02, 0.03])
    beside = pivot + [1.0, 0.0, 0.0]
    assert turned[:3, :3] @ beside + turned[:3, 3] == pytest.approx(before + [0.0, 1.0, 0.0])


def test_no_motion_leaves_the_camera():
    camera = np.eye(4)
    camera[:3, 3] = [0.0, 0.0, 2.0]
    assert np.array_equal(moved_camera(camera, np.zeros(6), np.array([0.3, 0.4, 0.5])), camera)
