"""First cameras see head top and soles where the points say."""

import math

import numpy as np
import pytest

from cloner.frames import ViewId, focal_px_from_35mm
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import PointSet, ViewPoints
from cloner.records.views import Camera
from cloner.stages import views
from kit import studio

STATURE_M = 1.70
WIDTH, HEIGHT = 1200, 1800
FRONT, SIDE, BACK = ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK
PARAMS = views.Params()
TOP_M, BOTTOM_M = STATURE_M + PARAMS.hair_m, -PARAMS.sole_m


def photo(view, focal_35mm=62.0):
    return studio.photo_record(view, np.zeros((HEIGHT, WIDTH, 3), np.uint8), focal_35mm=focal_35mm)


def named(view, **places):
    count = len(places)
    return ViewPoints(view, tuple(places), np.array(list(places.values())), np.ones(count), np.zeros(count, bool))


def standing(view, *, top=200.0, bottom=1600.0, **more):
    soles = {"sole_left": (640.0, bottom), "sole_right": (580.0, bottom - 12.0)}
    return named(view, head_top=(610.0, top), **soles, **more)


def find(points, *, focal_35mm=62.0):
    photos = PhotoSet({view: photo(view, focal_35mm) for view in points})
    return views.run(
        photos=photos,
        body_points=PointSet(points),
        person=Person("p", "", STATURE_M),
        tick=lambda fraction: None,
    )


def seen(camera, *place):
    return camera.project(np.array([place]))[0]


def test_head_top_and_sole_are_seen_where_they_were_asked_for():
    camera = find({FRONT: standing(FRONT)}).values["views"].views[FRONT].camera
    top, bottom = (float(seen(camera, 0.0, height, 0.0)[1]) for height in (TOP_M, BOTTOM_M))
    # the camera looks down a little, which a first camera ignores: 1.3 % of the height
    assert top == pytest.approx(200.0, abs=18.0)
    assert bottom == pytest.approx(1600.0, abs=18.0)
    assert bottom - top == pytest.approx(1400.0, abs=8.0)
    middle = seen(camera, 0.0, (TOP_M + BOTTOM_M) / 2, 0.0)
    assert middle == pytest.approx([610.0, 900.0], abs=0.6), "the span's middle is exact"
    assert camera.position_m[1] == pytest.approx(PARAMS.camera_height_m, abs=0.02)
    assert camera.focal_px == pytest.approx(focal_px_from_35mm(62.0, WIDTH, HEIGHT))


@pytest.mark.parametrize(
    ("view", "more", "shown", "direction"),
    [
        (FRONT, {}, "front", (0, 1)),
        (BACK, {}, "back", (0, -1)),
        (SIDE, {"ear_outer_L": (600.0, 300.0)}, "left", (1, 0)),
        (SIDE, {"ear_outer_R": (600.0, 300.0)}, "right", (-1, 0)),
    ],
)
def test_cameras_stand_on_the_side_that_the_photo_shows(view, more, shown, direction):
    found = find({view: standing(view, **more)}).values["views"].views[view]
    assert found.side_shown == shown
    place = found.camera.position_m[[0, 2]]
    assert place / np.linalg.norm(place) == pytest.approx(direction, abs=0.05)
    # a level camera: the person's feet are below the head in the picture, and left is where it must be
    assert seen(found.camera, 0.0, 0.0, 0.0)[1] > seen(found.camera, 0.0, 1.0, 0.0)[1]


def test_the_persons_left_is_on_the_right_of_a_front_photo_only():
    found = find({FRONT: standing(FRONT), BACK: standing(BACK)}).values["views"].views
    assert seen(found[FRONT].camera, 0.3, 1.0, 0.0)[0] > seen(found[FRONT].camera, -0.3, 1.0, 0.0)[0]
    assert seen(found[BACK].camera, 0.3, 1.0, 0.0)[0] < seen(found[BACK].camera, -0.3, 1.0, 0.0)[0]


def test_one_stature_and_the_larger_picture_comes_from_nearer():
    views_found = find({FRONT: standing(FRONT), BACK: standing(BACK, top=165.0, bottom=1635.0)}).values["views"].views
    far, near = (views_found[view].camera for view in (FRONT, BACK))
    middle = np.array([[0.0, (TOP_M + BOTTOM_M) / 2, 0.0]])
    # the same person fills 1400 and 1470 pixels
    assert far.to_camera(middle)[0, 2] / near.to_camera(middle)[0, 2] == pytest.approx(1470.0 / 1400.0)


def test_a_missing_focal_length_is_assumed_and_said():
    found = find({FRONT: standing(FRONT)}, focal_35mm=None)
    assert found.values["views"].views[FRONT].camera.focal_px == pytest.approx(PARAMS.body_focal_35mm * HEIGHT / 36.0)
    assert not found.values["views"].views[FRONT].focal_known
    (warning,) = found.warnings
    assert "body_front" in warning
    assert "55 mm" in warning


def test_points_without_head_or_soles_are_a_mistake_of_the_caller():
    with pytest.raises(ValueError, match="no head top or sole"):
        find({FRONT: named(FRONT, crotch=(600.0, 900.0))})


def test_a_very_distant_camera_is_the_orthographic_one():
    top, bottom, focal = np.array([600.0, 200.0]), np.array([600.0, 1600.0]), 5e6
    far = views.level_camera(photo(FRONT), focal, 0.0, top, bottom, (BOTTOM_M, TOP_M), PARAMS.camera_height_m)
    scale = 1400.0 / (TOP_M - BOTTOM_M)
    flat = Camera(WIDTH, HEIGHT, focal, far.camera_from_model, scale)
    body = np.random.default_rng(3).uniform([-0.4, 0.0, -0.3], [0.4, 1.7, 0.3], size=(50, 3))
    assert far.project(body) == pytest.approx(flat.project(body), abs=0.2)
    assert seen(far, 0.0, TOP_M, 0.2)[1] == pytest.approx(200.0, abs=0.2)
    assert seen(far, 0.0, BOTTOM_M, -0.2)[1] == pytest.approx(1600.0, abs=0.2)
    assert far.metres_per_pixel(np.array([0.0, 1.0, 0.0])) == pytest.approx(1.0 / scale, rel=1e-3)


def test_pitching_down_lowers_the_view_axis():
    axis = views.pitch_rotation(views.level_rotation(0.0), math.radians(10.0))[2]
    assert axis == pytest.approx([0.0, -math.sin(math.radians(10.0)), -math.cos(math.radians(10.0))])
