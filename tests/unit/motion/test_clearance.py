"""Arms hang clear of wide people, and close to slim ones."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.evaluate.measures.crossings import buried_depths, self_intersections
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_triangles
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.motion.flesh.rest import hanging_pose, t_pose
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.clearance import LEAST_DEG, MOST_DEG
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.gait import walk
from kit.clones import toy_clone


def widened(factor):
    """Return a toy clone whose trunk and thighs are wider than the generic human's."""
    generic = load_generic()
    clone = toy_clone(hair=False)
    share = generic.segment_weights[:, [generic.segment_names.index(name) for name in ("torso", "pelvis")]].sum(axis=1)
    vertices = clone.vertices_m.copy()
    vertices[:, 0] *= 1.0 + (factor - 1.0) * share
    return centre_joints(replace(clone, vertices_m=vertices))


def posed(clone, rotations):
    generic = load_generic()
    transforms = joint_transforms(clone.joints_m, generic.joint_parents, rotations)
    return linear_blend_skinning(
        clone.vertices_m, transforms, generic.skin_joints, generic.skin_weights.astype(np.float64)
    )


def skin_only():
    triangles = load_triangles()
    return triangles[(load_generic().vertex_part[triangles] == 0).all(axis=1)]


def test_wider_people_hold_their_arms_farther_out():
    angles = [np.degrees(body_of(widened(factor)).arm_clearance_rad) for factor in (0.9, 1.0, 1.15, 1.6)]
    assert angles == sorted(angles)
    assert angles[0] < angles[2]
    assert all(LEAST_DEG - 1e-9 <= angle <= MOST_DEG + 1e-9 for angle in angles)


@pytest.mark.parametrize("factor", [1.0, 1.15])
def test_no_forearm_or_hand_lies_in_the_trunk(factor):
    generic, clone = load_generic(), widened(factor)
    body = body_of(clone)
    segments = [f"{side}_{part}" for side in ("left", "right") for part in ("forearm", "hand")]
    arms = np.isin(generic.vertex_segment, [generic.segment_names.index(name) for name in segments])
    for rotations in (hanging_pose(body), walk(body).rotations[0], walk(body).rotations[8]):
        points = posed(clone, rotations)
        depths = buried_depths(points, skin_only(), self_intersections(points, skin_only()))
        # fingers of one hand touch each other
        assert depths[arms & ~generic.region("hand_left") & ~generic.region("hand_right")].max() < 0.003


def test_wide_trouser_legs_stand_apart_and_slim_ones_straight():
    generic, slim = load_generic(), widened(1.0)
    vertices = slim.vertices_m.copy()
    for side in ("left", "right"):
        row, joint = generic.segment_names.index(f"{side}_thigh"), generic.joint(f"{side[0]}_hip")
        share = generic.segment_weights[:, row].astype(float)
        vertices[:, 0] += 0.25 * share * (vertices[:, 0] - slim.joints_m[joint, 0])
    wide = replace(slim, vertices_m=vertices)
    assert body_of(slim).leg_clearance_rad < body_of(wide).leg_clearance_rad
    for clone, most_m in ((slim, 0.25), (wide, 0.45)):
        points = posed(clone, t_pose(body_of(clone)))
        heels = points[[generic.feature("heel_left"), generic.feature("heel_right")], 0]
        assert 0.1 < heels[0] - heels[1] < most_m
        thighs = [generic.segment_names.index(f"{side}_thigh") for side in ("left", "right")]
        legs = skin_only()[np.isin(generic.vertex_segment[skin_only()], thighs).all(axis=1)]
        assert buried_depths(points, legs, self_intersections(points, legs)).max() < 0.001, "they may touch"


def test_rest_and_t_pose_cross_nothing_but_closed_lips():
    generic, clone = load_generic(), widened(1.0)
    for rotations in (np.zeros((94, 3)), t_pose(body_of(clone))):
        points = posed(clone, rotations)
        found = self_intersections(points, skin_only())
        mouth = (generic.region("lips") | generic.region("mouth_interior"))[skin_only()].any(axis=1)
        toes = (generic.region("foot_left") | generic.region("foot_right"))[skin_only()].any(axis=1)
        elsewhere = ~(mouth | toes)[found.pairs].all(axis=1)
        assert elsewhere.sum() == 0, "naked toes and lips touch in the generic human"
