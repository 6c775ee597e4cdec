"""Head and body become one, to the millimetre where the answer is known."""

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.records.bodies import BodyMesh
from cloner.records.heads import HeadFit
from cloner.stages import join
from kit import studio

STATURE_M = 1.70


@pytest.fixture(scope="module")
def generic():
    return load_generic()


@pytest.fixture(scope="module")
def body(generic):
    vertices, joints = generic.shape(np.zeros(0), STATURE_M)
    return BodyMesh(vertices, joints)


def head_moved(generic, body, shift):
    vertices = body.vertices_m[generic.head_vertices] + shift
    return HeadFit(vertices, {}, (), np.zeros((0, 3)), np.zeros(3), 0.006, "")


def test_a_head_of_the_bodys_own_changes_nothing(generic, body):
    blended = join.blend_head(generic, body, head_moved(generic, body, 0.0))
    np.testing.assert_allclose(blended, body.vertices_m, atol=1e-12)


def test_the_head_moves_whole_the_body_not_and_the_neck_by_its_share(generic, body):
    shift = np.array([0.0, 0.01, 0.02])
    moved = join.blend_head(generic, body, head_moved(generic, body, shift)) - body.vertices_m
    blend = generic.head_blend.astype(float)
    np.testing.assert_allclose(moved, blend[:, None] * shift, atol=1e-7)
    assert moved[generic.feature("nose_tip")] == pytest.approx(shift, abs=1e-6)
    assert not moved[generic.feature("crotch")].any()
    assert ((blend > 0.2) & (blend < 0.8)).sum() > 50, "there is a neck to blend over"


def test_treads_are_flat_nothing_lies_below_and_a_toes_spring_stays(generic, body):
    shod = body.vertices_m.copy()
    sole = np.flatnonzero(generic.region("sole"))
    shod[sole, 1] = -0.03 + np.linspace(-0.004, join.TREAD_M - 1e-4, len(sole))
    sprung = sole[np.argsort(shod[sole, 2])[-20:]]
    shod[sprung, 1] = -0.018
    flat = join.flat_soles(generic, shod, 0.03)
    assert np.ptp(flat[np.setdiff1d(sole, sprung), 1]) == 0.0
    assert np.array_equal(flat[sprung], shod[sprung]), "a shoe that rises towards its toe keeps doing so"
    assert flat[:, 1].min() == -0.03
    high = shod[:, 1] > 0.2
    assert np.array_equal(flat[high], shod[high])


@pytest.mark.parametrize("stature_m", [1.68, 1.72])
def test_the_skull_ends_at_the_stature_and_the_face_stays(generic, body, stature_m):
    stretched = join.to_stature(generic, body.vertices_m, stature_m)
    assert stretched[generic.feature("head_top"), 1] == pytest.approx(stature_m, abs=1e-9)
    below = body.vertices_m[:, 1] < body.vertices_m[generic.feature("glabella"), 1]
    assert np.array_equal(stretched[below], body.vertices_m[below])
    assert np.array_equal(stretched[:, [0, 2]], body.vertices_m[:, [0, 2]])


def test_raising_the_model_and_its_camera_keeps_the_picture(body):
    camera = studio.camera(30.0)
    raised = join.on_floor(camera, 0.025)
    before = camera.project(body.vertices_m)
    np.testing.assert_allclose(raised.project(body.vertices_m + [0.0, 0.025, 0.0]), before, atol=1e-6)
    assert raised.position_m - camera.position_m == pytest.approx([0.0, 0.025, 0.0])
