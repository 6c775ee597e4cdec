"""Limbs that bend keep their flesh; shapes known beforehand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.generic.morphs import target_offsets
from cloner.geometry.articulation.dual import dual_quaternion_skinning
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.motion.flesh.bending import BENDS, Flesh, bent_rotations, flesh
from cloner.motion.flesh.correctives import drive_correctives, with_correctives
from cloner.motion.flesh.rest import in_t_pose
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.records.motions import Motion
from kit.clones import toy_clone

#: The bar of the project: a joint holds what it holds at rest within this share.
BAR = 0.03


def test_dual_quaternions_keep_the_distance_from_a_bend_that_linear_skinning_halves() -> None:
    """Half carried by each of two joints a third of a turn apart: turned by a sixth, as far from the axis as before."""
    transforms = joint_transforms(np.zeros((2, 3)), np.array([-1, 0]), np.array([[0.0, 0, 0], [0, 0, 2 * np.pi / 3]]))
    point, joints, half = np.array([[1.0, 0.0, 0.3]]), np.array([[0, 1]]), np.array([[0.5, 0.5]])
    (kept,) = dual_quaternion_skinning(point, transforms, np.array([-1, 0]), joints, half)
    assert kept == pytest.approx([0.5, np.sqrt(0.75), 0.3])
    assert np.linalg.norm(linear_blend_skinning(point, transforms, joints, half)[0, :2]) == pytest.approx(0.5)


def test_the_volume_of_a_box_without_lid_and_bottom() -> None:
    box = np.array([[x, y, z] for z in (0.0, 3.0) for x, y in ((0, 0), (2, 0), (2, 1), (0, 1))], dtype=float) + 5.0
    walls = [[a, b, b + 4] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))]
    walls += [[a, b + 4, a + 4] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))]
    rim = [[0, 1], [1, 2], [2, 3], [3, 0], [5, 4], [6, 5], [7, 6], [4, 7]]
    open_box = Flesh(np.arange(8), np.array(walls), np.array(rim), np.array([0] * 4 + [1] * 4))
    assert open_box.volume(box) == pytest.approx(6.0)
    assert open_box.volume(2.0 * box) == pytest.approx(48.0)


@pytest.mark.parametrize("t_pose", [False, True], ids=["A", "T"])
def test_every_joint_keeps_its_flesh_over_its_range(t_pose: bool) -> None:
    clone, generic = centre_joints(toy_clone(1.70)), load_generic()
    clone = in_t_pose(clone) if t_pose else clone
    body, (shaped, drivers) = body_of(clone), with_correctives(clone)
    offsets = {name: own.copy() for name, own in target_offsets(shaped) if name.startswith("corrective")}
    joints, weights = generic.skin_joints.astype(np.int64), generic.skin_weights.astype(np.float64)
    lost = 0.0
    for bend in BENDS:
        around, angles = flesh("r", bend.joint), np.linspace(bend.degrees[0], bend.degrees[-1], 13)
        rest = around.volume(clone.vertices_m[around.rows])
        poses = bent_rotations(body, "r", bend, angles)
        motion = drive_correctives(Motion("bend", np.arange(13.0), np.zeros((13, 3)), poses), drivers)
        for frame, degrees in enumerate(angles):
            transforms = joint_transforms(clone.joints_m, body.parents, poses[frame])
            points = clone.vertices_m + sum(motion.weights[name][frame] * own[:-1] for name, own in offsets.items())
            held = [around.volume(linear_blend_skinning(own, transforms, joints, weights)[around.rows]) / rest
                    for own in (points, clone.vertices_m)]  # fmt: skip
            assert held[0] == pytest.approx(1.0, abs=BAR), (bend.joint, bend.way, degrees)
            lost = max(lost, 1.0 - held[1])
    assert lost > 0.3, "linear skinning alone loses a third and more"


def test_at_rest_nothing_is_corrected_and_the_face_s_targets_stay() -> None:
    clone = centre_joints(toy_clone(1.70))
    shaped, drivers = with_correctives(clone)
    still = drive_correctives(Motion("still", np.zeros(1), np.zeros((1, 3)), np.zeros((1, 94, 3))), drivers)
    assert max(float(np.abs(values).max()) for values in still.weights.values()) < 1e-6
    assert shaped.morph_names[: len(clone.morph_names)] == clone.morph_names
    assert (shaped.morph_delta_m[: len(clone.morph_delta_m)] == clone.morph_delta_m).all()


def test_below_a_skirt_neither_hip_nor_knee_is_corrected() -> None:
    clone = toy_clone(1.70)
    skirt = replace(clone.shells[0], kind="cloth")
    _, drivers = with_correctives(replace(clone, shells=(skirt,)))
    assert {driver.joint[2:] for driver in drivers} == {"shoulder", "elbow"}
