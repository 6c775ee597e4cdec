"""Cameras of a shape fit: what is asked of people holds loosely once a photo clearly says otherwise."""

import numpy as np
import pytest

from cloner.fit.shapes import Evidence, ShapeFit, fit_shape
from cloner.records.views import Camera

PLACES = np.random.default_rng(3).uniform(-0.09, 0.09, (40, 3))


def camera(yaw_deg: float) -> Camera:
    c, s = np.cos(np.radians(yaw_deg)), np.sin(np.radians(yaw_deg))
    pose = np.eye(4)
    pose[:3, :3] = np.array([[c, 0, -s], [0, -1, 0], [-s, 0, -c]])
    pose[:3, 3] = [0.0, 0.0, 1.2]
    return Camera(900, 1200, 2600.0, pose)


def found_yaw_deg(true_deg: float, sigma_px: float, expected_deg: float) -> float:
    """Return the yaw found from points seen by a camera at ``true_deg`` when 0 is expected within ``expected_deg``."""
    target = camera(true_deg).project(PLACES)

    def gather(fit, iteration):
        return [Evidence(0, PLACES, np.zeros((1, 40, 3)), target, np.full(40, sigma_px), outlier=1e6)]

    turns = np.array([[np.inf, np.radians(expected_deg), np.inf]])
    fit = fit_shape(
        ShapeFit(np.zeros(1), (camera(0.0),), np.zeros((1, 3))), gather, rotation_sigma=turns, iterations=40
    )
    axis = fit.cameras[0].camera_from_model[2, :3]
    return float(np.degrees(np.arctan2(-axis[0], -axis[2])))


def test_a_photo_that_is_clearly_turned_is_believed_to_be():
    """Points tell the turn to 1.2 degrees: held without tails 15 degrees would be pulled back to 9."""
    assert found_yaw_deg(15.0, 15.0, 1.5) == pytest.approx(15.0, abs=0.6)


def test_a_small_turn_is_held_as_expected_when_points_say_little():
    """Points so vague that they tell the turn worse than what is expected of it."""
    assert abs(found_yaw_deg(1.0, 900.0, 1.0)) < 0.35


@pytest.mark.parametrize(("true", "found"), [(-0.5, 0.0), (0.6, 0.6)])
def test_a_bounded_coefficient_stays_within_and_lets_the_others_explain(true, found):
    """Two shifts along x, of half the places each; the first may not become negative."""
    basis = np.zeros((2, 40, 3))
    basis[0, :20, 0], basis[1, 20:, 0] = 0.01, 0.01
    target = camera(0.0).project(PLACES + true * basis[0] + 0.4 * basis[1])

    def gather(fit, iteration):
        return [Evidence(0, PLACES, basis, target, np.full(40, 0.1), outlier=1e6)]

    held = np.full((1, 3), 1e-9)
    start = ShapeFit(np.zeros(2), (camera(0.0),), np.zeros((1, 3)))
    fit = fit_shape(start, gather, lower=np.array([0.0, -np.inf]), rotation_sigma=held)
    assert fit.coefficients[0] >= 0.0
    if found:
        assert fit.coefficients[0] - fit.coefficients[1] == pytest.approx(0.2, abs=0.02)
    else:
        assert fit.coefficients[0] == 0.0


@pytest.mark.parametrize(("turns", "depth_m"), [(1, 0.6), (20, 1.2 / 3.5)])
def test_a_camera_that_must_come_nearer_never_passes_the_face(turns, depth_m):
    """Points seen three and a half times as large: the first straight step would end behind the face."""
    centre = np.array([450.0, 600.0])
    flat = PLACES * [1.0, 1.0, 0.0]
    target = centre + 3.5 * (camera(0.0).project(flat) - centre)

    def gather(fit, iteration):
        return [Evidence(0, flat, np.zeros((1, 40, 3)), target, np.full(40, 1.0), outlier=1e6)]

    start = ShapeFit(np.zeros(1), (camera(0.0),), np.zeros((1, 3)))
    fit = fit_shape(start, gather, rotation_sigma=np.full((1, 3), 1e-9), iterations=turns)
    assert fit.cameras[0].camera_from_model[2, 3] == pytest.approx(depth_m, rel=1e-3)
