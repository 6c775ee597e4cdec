"""Joints follow their key ancestor; parts follow their joints."""

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.stages.rough import follow_joints
from cloner.stages.skeleton import along_hierarchy
from kit import people


@pytest.fixture(scope="module")
def generic():
    return load_generic()


@pytest.fixture(scope="module")
def person():
    return people.known_person(41)


def test_what_hangs_on_a_key_joint_moves_with_it(generic, person):
    shift = np.array([0.01, -0.02, 0.005])
    moved = along_hierarchy(generic, person.joints_m, {"l_elbow": shift}) - person.joints_m
    below = {"l_elbow", "l_wrist", "l_index3", "l_thumb1"} & set(generic.joint_names)
    assert len(below) >= 3
    for name in below:
        assert moved[generic.joint(name)] == pytest.approx(shift), name
    for name in ("l_shoulder", "r_elbow", "HumanoidRoot", "skullbase"):
        assert not moved[generic.joint(name)].any(), name


def test_a_key_joint_below_has_its_own_motion(generic, person):
    own = {"l_elbow": np.array([0.01, 0.0, 0.0]), "l_wrist": np.array([0.0, 0.02, 0.0])}
    moved = along_hierarchy(generic, person.joints_m, own) - person.joints_m
    assert moved[generic.joint("l_wrist")] == pytest.approx(own["l_wrist"])
    assert moved[generic.joint("l_elbow")] == pytest.approx(own["l_elbow"])


def test_skin_stays_where_its_joints_stay(person):
    followed = follow_joints(person.vertices_m, person.joints_m, person.joints_m)
    np.testing.assert_allclose(followed, person.vertices_m, atol=1e-9)


def test_skin_shifts_with_all_joints(person):
    shift = np.array([0.02, -0.01, 0.03])
    followed = follow_joints(person.vertices_m, person.joints_m, person.joints_m + shift)
    np.testing.assert_allclose(followed, person.vertices_m + shift, atol=1e-9)


def test_a_longer_forearm_lengthens_forearm_and_moves_the_hand_only(generic, person):
    joints = person.joints_m.copy()
    elbow, wrist = generic.joint("l_elbow"), generic.joint("l_wrist")
    along = joints[wrist] - joints[elbow]
    shift = 0.1 * along
    longer = along_hierarchy(generic, joints, {"l_wrist": shift})
    moved = follow_joints(person.vertices_m, joints, longer) - person.vertices_m

    def whole(segment):
        return generic.segment_weights[:, generic.segment_names.index(segment)] > 0.999

    np.testing.assert_allclose(
        moved[whole("left_hand")], np.broadcast_to(shift, moved[whole("left_hand")].shape), atol=1e-6
    )
    assert np.abs(moved[whole("right_hand") | whole("torso") | whole("head")]).max() < 1e-9
    fore = np.flatnonzero(whole("left_forearm"))
    place = np.clip((person.vertices_m[fore] - joints[elbow]) @ along / (along @ along), 0.0, 1.0)
    # a tenth longer: a point moves by a tenth of its distance from the elbow
    np.testing.assert_allclose(moved[fore], place[:, None] * shift, atol=1e-4)
