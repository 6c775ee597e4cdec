"""Cameras among the unknowns: derivatives against differences, a camera found with an outlier among its points."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.fit.cameras import CameraUnknowns, resect
from cloner.geometry.articulation.skinning import rotation_axes, rotation_matrices, skew
from cloner.geometry.cameras.motions import motion_jacobian, moved_camera, projection_derivatives
from cloner.records.views import Camera

PLACES = np.random.default_rng(5).uniform(-0.1, 0.1, (30, 3))
MOTION = np.array([0.3, -0.5, 0.2, 0.02, -0.03, 0.05])
STEP = 1e-6


def camera(pixels_per_m: float | None = None) -> Camera:
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = [0.02, 0.01, 1.3]
    return Camera(900, 1200, 2600.0, pose, pixels_per_m)


def differences(function, start: np.ndarray) -> np.ndarray:
    """Return central differences of a function, its inputs last."""
    steps = STEP * np.eye(len(start))
    return np.stack([(function(start + s) - function(start - s)) / (2.0 * STEP) for s in steps], axis=-1)


@pytest.mark.parametrize("pixels_per_m", [None, 1500.0])
def test_pixels_follow_points_and_the_cameras_motion(pixels_per_m: float | None) -> None:
    seen, by_points, by_step = projection_derivatives(camera(pixels_per_m), PLACES)
    moved = differences(lambda step: moved_camera(camera(pixels_per_m), step).project(PLACES), np.zeros(6))
    shifted = differences(lambda shift: camera(pixels_per_m).project(PLACES + shift), np.zeros(3))
    np.testing.assert_allclose(seen, camera(pixels_per_m).project(PLACES))
    np.testing.assert_allclose(by_step, moved, atol=1e-3)
    np.testing.assert_allclose(by_points, shifted, atol=1e-3)


@pytest.mark.parametrize("pivot", [np.zeros(3), np.array([0.1, -0.2, 1.1])])
def test_a_motion_far_from_its_start_is_differentiated_exactly(pivot: np.ndarray) -> None:
    there = moved_camera(camera(), MOTION, pivot)
    by_motion = projection_derivatives(there, PLACES)[2] @ motion_jacobian(MOTION, pivot)
    told = differences(lambda motion: moved_camera(camera(), motion, pivot).project(PLACES), MOTION)
    np.testing.assert_allclose(by_motion, told, atol=1e-3)


def test_a_camera_turns_about_its_pivot_and_then_shifts() -> None:
    pivot = np.array([0.3, 0.2, 2.0])
    turned = moved_camera(camera(), np.array([0.0, 0.0, np.pi / 2.0, 0.0, 0.0, 0.0]), pivot)
    shifted = moved_camera(camera(), np.array([0.0, 0.0, np.pi / 2.0, 0.01, 0.02, 0.03]), pivot)
    there = camera().camera_from_model[:3, :3].T @ (pivot - camera().camera_from_model[:3, 3])
    assert turned.to_camera(there[None])[0] == pytest.approx(pivot)
    assert shifted.to_camera(PLACES) - turned.to_camera(PLACES) == pytest.approx(np.tile([0.01, 0.02, 0.03], (30, 1)))
    beside = there + [1.0, 0.0, 0.0]
    assert turned.to_camera(beside[None])[0] == pytest.approx(pivot + [0.0, 1.0, 0.0])


def test_a_zoom_keeps_the_size_of_what_lies_at_its_depth() -> None:
    aim = CameraUnknowns(camera(), 1.3)
    pixels, by_points, by_aim = aim.project(PLACES, MOTION, 0.2)
    np.testing.assert_allclose(pixels, aim.camera(MOTION, 0.2).project(PLACES))
    told = differences(lambda x: aim.camera(x[:6], x[6]).project(PLACES), np.append(MOTION, 0.2))
    np.testing.assert_allclose(by_aim, told, atol=1e-3)
    shifted = differences(lambda shift: aim.camera(MOTION, 0.2).project(PLACES + shift), np.zeros(3))
    np.testing.assert_allclose(by_points, shifted, atol=1e-3)
    far = np.array([[0.1, 0.0, 0.0], [-0.1, 0.0, 0.0]])
    sizes = [np.ptp(aim.camera(np.zeros(6), zoom).project(far)[:, 0]) for zoom in (0.0, 0.2)]
    assert sizes[1] == pytest.approx(sizes[0], rel=1e-9)


def test_turning_axes_are_those_about_which_a_rotation_turns() -> None:
    for rotation in (np.zeros(3), MOTION[:3]):
        turned = differences(lambda r: rotation_matrices(r[None])[0], rotation)
        around = np.einsum("abk,cb->ack", turned, rotation_matrices(rotation[None])[0])
        for axis in range(3):
            np.testing.assert_allclose(around[..., axis], skew(rotation_axes(rotation)[:, axis]), atol=1e-6)


def test_a_camera_is_found_from_far_and_in_spite_of_a_wrong_point() -> None:
    true = moved_camera(camera(), np.array([0.2, 0.5, -0.3, 0.05, 0.02, 0.2]), np.array([0.0, 0.0, 1.3]))
    seen = true.project(PLACES)
    seen[4] += 300.0
    found = resect(PLACES, seen, camera(), iterations=60)
    np.testing.assert_allclose(found.camera_from_model, true.camera_from_model, atol=2e-4)


def test_a_turn_that_points_do_not_tell_stays_as_expected() -> None:
    """One point cannot tell a turn: all of its way is a shift."""
    place = PLACES[:1]
    turns = np.full(3, 1e-4)
    found = resect(place, camera().project(place) + 20.0, camera(), rotation_sigma=turns)
    np.testing.assert_allclose(found.camera_from_model[:3, :3], camera().camera_from_model[:3, :3], atol=1e-4)
    np.testing.assert_allclose(found.project(place), camera().project(place) + 20.0, atol=0.01)
