"""Six numbers say where a camera stands and looks."""

import math

import numpy as np
import pytest

from cloner.geometry.cameras.stands import STAND_NAMES, camera_from_stand, project_from_stand, stand_from_camera
from cloner.records.views import Camera
from cloner.stages.views import level_rotation, pitch_rotation
from kit import studio

LIKE = Camera(1200, 1800, 3100.0, np.eye(4))


def stand(**values):
    return np.array([values.get(name, 0.0) for name in STAND_NAMES])


def test_the_camera_stands_where_it_is_told():
    camera = camera_from_stand(stand(azimuth=math.radians(90.0), height=1.3, distance=3.0), LIKE)
    assert camera.position_m == pytest.approx([3.0, 1.3, 0.0]), "at the person's left"
    assert camera.project(np.array([[0.0, 1.3, 0.0]]))[0] == pytest.approx(camera.centre_px), "and looks at him"
    # seen from his left, what lies in front of him is at the picture's left
    assert camera.project(np.array([[0.0, 1.3, 0.2]]))[0, 0] < camera.centre_px[0] - 100.0


def test_facing_pitch_and_roll_move_the_picture_the_way_they_say():
    person = np.array([[0.0, 1.2, 0.0]])
    level = camera_from_stand(stand(height=1.2, distance=3.0), LIKE).project(person)[0]
    down = camera_from_stand(stand(height=1.2, distance=3.0, pitch=0.1), LIKE).project(person)[0]
    assert down - level == pytest.approx([0.0, -3100.0 * math.tan(0.1)]), "looking down, the person moves up"
    over = np.array([[0.0, 1.7, 0.0]])
    rolled = camera_from_stand(stand(height=1.2, distance=3.0, roll=0.1), LIKE).project(over)[0]
    assert rolled[0] > level[0] + 10.0


def test_a_stand_is_the_one_of_its_camera():
    wanted = stand(azimuth=2.1, height=1.3, distance=3.2, facing=0.1, pitch=0.2, roll=-0.05)
    assert stand_from_camera(camera_from_stand(wanted, LIKE)) == pytest.approx(wanted)
    known = studio.camera(-90.0, height_m=1.4)
    found = stand_from_camera(known)
    assert camera_from_stand(found, known).camera_from_model == pytest.approx(known.camera_from_model)
    assert dict(zip(STAND_NAMES, found, strict=True))["height"] == pytest.approx(1.4)


def test_headings_agree_with_the_first_cameras():
    camera = camera_from_stand(stand(azimuth=0.4, height=1.0, distance=3.0, pitch=0.2), LIKE)
    assert camera.camera_from_model[:3, :3] == pytest.approx(pitch_rotation(level_rotation(0.4), 0.2))


@pytest.mark.parametrize("pixels_per_m", [None, 900.0])
def test_derivatives_agree_with_differences(pixels_per_m):
    like = Camera(1200, 1800, 3100.0, np.eye(4), pixels_per_m)
    at = stand(azimuth=2.1, height=1.3, distance=3.2, facing=0.1, pitch=0.2, roll=-0.05)
    points = np.random.default_rng(0).uniform([-0.4, 0.0, -0.3], [0.4, 1.7, 0.3], size=(12, 3))
    pixels, by_point, by_stand = project_from_stand(at, like, points)
    assert pixels == pytest.approx(camera_from_stand(at, like).project(points))
    step = 1e-6
    for axis in range(6):
        change = step * np.eye(6)[axis]
        ahead, behind = (camera_from_stand(at + sign * change, like).project(points) for sign in (1.0, -1.0))
        assert by_stand[..., axis] == pytest.approx((ahead - behind) / (2.0 * step), abs=1e-3)
    for axis in range(3):
        change = step * np.eye(3)[axis]
        ahead, behind = (camera_from_stand(at, like).project(points + sign * change) for sign in (1.0, -1.0))
        assert by_point[..., axis] == pytest.approx((ahead - behind) / (2.0 * step), abs=1e-3)
