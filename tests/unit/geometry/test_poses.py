"""The pose vector reaches the joints it names, by the amounts it says."""

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.geometry.articulation.poses import FREEDOMS, SIGMAS, mirrored_freedoms, pose_matrix, standing_pose
from cloner.geometry.articulation.skinning import joint_transforms


def rotations(**angles):
    generic = load_generic()
    names = [freedom.name for freedom in FREEDOMS]
    pose = np.zeros(len(FREEDOMS))
    for name, angle in angles.items():
        pose[names.index(name)] = angle
    return (pose_matrix(generic.joint_names) @ pose).reshape(-1, 3)


def test_names_are_unique_and_spreads_are_of_a_standing_person():
    names = [freedom.name for freedom in FREEDOMS]
    assert len(set(names)) == len(names)
    assert SIGMAS.min() > np.deg2rad(1.0)
    assert SIGMAS.max() < np.deg2rad(30.0)


def test_a_knee_angle_moves_one_knee():
    generic = load_generic()
    found = rotations(l_knee_bend=0.3)
    assert found[generic.joint("l_knee")] == pytest.approx([0.3, 0.0, 0.0])
    assert np.count_nonzero(found) == 1


def test_the_spine_shares_its_angle_in_equal_parts():
    found = rotations(spine_y=0.6)
    assert found.sum(axis=0) == pytest.approx([0.0, 0.6, 0.0])
    assert np.unique(found[found[:, 1] != 0, 1]) == pytest.approx([0.1])


def test_a_mirrored_pose_places_the_joints_of_the_other_side():
    generic = load_generic()
    left, right, sign = mirrored_freedoms()
    pose = np.zeros(len(FREEDOMS))
    pose[left] = np.random.default_rng(3).normal(0.0, 0.2, len(left))
    pose[right] = sign * pose[left]
    joints = np.asarray(generic.joints_m, dtype=np.float64)
    turned = (pose_matrix(generic.joint_names) @ pose).reshape(-1, 3)
    moved = joint_transforms(joints, generic.joint_parents, turned)
    placed = np.einsum("jab,jb->ja", moved[:, :3, :3], joints) + moved[:, :3, 3]
    for name in ("elbow", "wrist", "knee", "ankle", "metatarsal"):
        ours, theirs = (placed[generic.joint(f"{side}_{name}")] for side in "lr")
        assert ours == pytest.approx(theirs * [-1.0, 1.0, 1.0], abs=1e-3), name


def test_a_skeleton_without_a_needed_joint_is_refused():
    names = [name for name in load_generic().joint_names if name != "l_knee"]
    with pytest.raises(ValueError, match="l_knee"):
        pose_matrix(names)


@pytest.mark.parametrize(("side", "sign"), [("l", 1.0), ("r", -1.0)])
def test_standing_arms_hang_as_described(side, sign):
    generic = load_generic()
    joints = np.asarray(generic.joints_m, dtype=np.float64)
    pose = standing_pose(generic.joint_names, joints)
    turned = (pose_matrix(generic.joint_names) @ pose).reshape(-1, 3)
    moved = joint_transforms(joints, generic.joint_parents, turned)
    placed = np.einsum("jab,jb->ja", moved[:, :3, :3], joints) + moved[:, :3, 3]
    shoulder, elbow, wrist = (placed[generic.joint(f"{side}_{name}")] for name in ("shoulder", "elbow", "wrist"))
    upper, fore = elbow - shoulder, wrist - elbow
    assert np.degrees(np.arctan2(sign * upper[0], -upper[1])) == pytest.approx(30.0, abs=0.1)
    assert upper[2] == pytest.approx(0.0, abs=1e-6)
    assert np.degrees(np.arctan2(sign * fore[0], -fore[1])) == pytest.approx(24.0, abs=0.5)
    assert np.degrees(np.arctan2(fore[2], -fore[1])) == pytest.approx(8.8, abs=0.5)
