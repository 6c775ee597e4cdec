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
    return HeadFit(vertices, {}, np.zeros(3), 0.006, "")


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
def test_the_skull_ends_at_the_stature_by_lifting_the_head_and_by_stretching_its_vault(generic, body, stature_m):
    mesh, risen = join.to_stature(generic, body, stature_m)
    moved, lacks = mesh.vertices_m - body.vertices_m, stature_m - body.vertices_m[generic.feature("head_top"), 1]
    assert mesh.vertices_m[generic.feature("head_top"), 1] == pytest.approx(stature_m, abs=1e-9)
    for name in ("chin_bottom", "nose_tip", "pupil_L", "glabella"):
        assert moved[generic.feature(name), 1] == pytest.approx(risen, rel=1e-4), "the face keeps its shape"
    assert risen == pytest.approx(join.LIFTED * lacks)
    assert 0.0 < risen / lacks < 1.0
    assert not moved[:, [0, 2]].any(), "it rises straight"
    assert not moved[generic.feature("crotch")].any()


def test_the_joints_of_head_and_neck_rise_with_their_skin_and_no_others(generic, body):
    mesh, risen = join.to_stature(generic, body, 1.72)
    up = (mesh.joints_m - body.joints_m)[:, 1] / risen
    rows = {name: up[generic.joint(name)] for name in ("skullbase", "temporomandibular", "vc3", "vc5", "vc7", "vt1")}
    assert [rows["skullbase"], rows["temporomandibular"]] == pytest.approx([1.0, 1.0])
    assert 1.0 + 1e-9 >= rows["vc3"] >= rows["vc5"] > rows["vc7"] > 0.0
    assert rows["vt1"] == 0.0
    assert not up[generic.joint("l_shoulder")]
    assert not up[0]


def test_raising_the_model_and_its_camera_keeps_the_picture(body):
    camera = studio.camera(30.0)
    raised = join.lift_camera(camera, 0.025)
    before = camera.project(body.vertices_m)
    np.testing.assert_allclose(raised.project(body.vertices_m + [0.0, 0.025, 0.0]), before, atol=1e-6)
    assert raised.position_m - camera.position_m == pytest.approx([0.0, 0.025, 0.0])
