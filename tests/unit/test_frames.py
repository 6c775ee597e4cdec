"""Units, cameras and names: there and back, and numbers known beforehand."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cloner.frames import BODY_VIEWS, FACE_VIEWS, ViewId, focal_px_from_35mm, m_from_cm, m_from_mm, mm_from_m
from cloner.records.views import Camera
from cloner.registry import Registry
from kit import studio


@given(st.floats(-1e4, 1e4))
def test_millimetres_there_and_back(length_m):
    assert m_from_mm(mm_from_m(length_m)) == pytest.approx(length_m, rel=1e-12, abs=1e-12)


def test_known_lengths():
    assert mm_from_m(1.58) == pytest.approx(1580.0)
    assert m_from_cm(158) == pytest.approx(1.58)
    # 36 mm of film are the long side, however the photo is held
    assert focal_px_from_35mm(36.0, 1200, 1800) == focal_px_from_35mm(36.0, 1800, 1200) == 1800.0


def test_views_are_bodies_or_faces():
    assert {*BODY_VIEWS, *FACE_VIEWS} == set(ViewId)
    assert all(view.is_body and not view.is_face for view in BODY_VIEWS)
    assert all(view.is_face and not view.is_body for view in FACE_VIEWS)


def test_a_point_ahead_lies_where_the_pinhole_says():
    matrix = np.eye(4)
    matrix[2, 3] = 2.0
    camera = Camera(101, 201, 100.0, matrix)
    # 0.5 m right and 1 m down at 2 m: 25 and 50 px from the centre (50, 100)
    assert camera.project(np.array([[0.5, 1.0, 0.0]]))[0] == pytest.approx([75.0, 150.0])
    assert camera.metres_per_pixel(np.zeros(3)) == pytest.approx(0.02)
    assert camera.position_m == pytest.approx([0.0, 0.0, -2.0])


@pytest.mark.parametrize("seen_by", [studio.camera(30.0), studio.orthographic(200.0)], ids=["perspective", "parallel"])
def test_projecting_and_back_returns_the_point(seen_by):
    points = np.random.default_rng(2).uniform([-0.4, 0.0, -0.3], [0.4, 1.8, 0.3], size=(40, 3))
    assert seen_by.back_project(seen_by.project(points), points) == pytest.approx(points, abs=1e-9)


def test_a_pixel_is_as_large_as_it_says():
    for seen_by in (studio.camera(0.0), studio.orthographic(0.0)):
        point = np.array([0.1, 0.9, 0.05])
        right = seen_by.camera_from_model[0, :3]
        moved = seen_by.project((point + seen_by.metres_per_pixel(point) * right)[None]) - seen_by.project(point[None])
        assert moved[0] == pytest.approx([1.0, 0.0], abs=1e-6)


def test_registry_loads_on_use_and_refuses_doubles():
    parts = Registry("part")
    parts.add("root", "math:sqrt")
    parts.add("later", "no_such_module:thing")
    assert parts.get("root")(16.0) == 4.0
    assert list(parts) == ["root", "later"]
    with pytest.raises(ValueError, match="twice"):
        parts.add("root", "math:sin")
    with pytest.raises(ValueError, match="module:attribute"):
        parts.add("wrong", "math.sin")
    with pytest.raises(KeyError, match="known: root, later"):
        parts.get("branch")
