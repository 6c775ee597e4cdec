"""Joints lie in the middle of the person's own limbs, and the skin bends well about them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.geometry.articulation.fingers import palm_normal
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.motion.flesh.rest import t_pose
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import SIDES, Body, below, body_of
from cloner.motion.limbs.rig import BY_AXIS, RINGED, centre_joints, joint_ring, limb_ring, middle
from cloner.motion.limbs.twist import shared_twist
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from kit.clones import toy_clone

GENERIC = load_generic()


def posed(clone: Clone, rotations) -> tuple[np.ndarray, np.ndarray]:
    """Return the posed vertices and joints."""
    transforms = joint_transforms(clone.joints_m, GENERIC.joint_parents.astype(int), rotations)
    joints = np.einsum("jab,jb->ja", transforms[:, :3, :3], clone.joints_m) + transforms[:, :3, 3]
    return linear_blend_skinning(
        clone.vertices_m, transforms, GENERIC.skin_joints, GENERIC.skin_weights.astype(float)
    ), joints


def enclosed(points: np.ndarray) -> float:
    """Return the area inside a ring of points."""
    away = points - points.mean(axis=0)
    return float(np.linalg.norm(np.cross(away, np.roll(away, -1, axis=0)).sum(axis=0)) / 2.0)


def bent(name: str, degrees: float) -> np.ndarray:
    """Return rotations that bend both limbs at a joint as it bends in life, about the person's left-right axis."""
    rotations = np.zeros((94, 3))
    for side in SIDES:
        rotations[GENERIC.joint(f"{side}_{name}"), 0] = np.radians(degrees if name == "knee" else -degrees)
    return rotations


@pytest.fixture(scope="module", params=[1.20, 1.85])
def clone(request) -> Clone:
    """A clone whose joints lie off: trousers wider on the outside, a fit that missed."""
    made = toy_clone(request.param)
    joints = made.joints_m.copy()
    for name, shift in (("l_knee", (0.012, 0.02, 0.0)), ("r_elbow", (0.0, 0.0, -0.012)), ("l_shoulder", (0, 0, 0.01))):
        joints[GENERIC.joint(name)] += shift
    return replace(made, joints_m=joints)


@pytest.mark.parametrize("name", list(RINGED))
def test_joints_lie_in_the_middle_of_the_limb_at_rest_and_when_bent(clone: Clone, name: str) -> None:
    own = centre_joints(clone)
    for degrees, most_m in ((0.0, 0.002), (90.0, 0.010)):
        vertices, joints = posed(own, bent(name, degrees))
        for side in SIDES:
            place = joints[GENERIC.joint(f"{side}_{name}")]
            before, _, after = (joints[GENERIC.joint(f"{side}_{joint}")] for joint in RINGED[name])
            along = (place - before) / np.linalg.norm(place - before) + (after - place) / np.linalg.norm(after - place)
            across = middle(joint_ring(side, name).points(vertices)) - place
            across -= across @ along * along / (along @ along)
            away = np.linalg.norm(across)
            assert away < most_m, f"{side}_{name} at {degrees}: {1000 * away:.1f} mm off"


def test_shoulders_and_ankles_lie_beside_their_limb_as_in_the_generic_human(clone: Clone) -> None:
    own, usual = centre_joints(clone), toy_clone(clone.stature_m)
    for name in BY_AXIS:
        for side in SIDES:
            joint = GENERIC.joint(f"{side}_{name}")
            assert np.linalg.norm(own.joints_m[joint] - usual.joints_m[joint]) < 0.002


def test_centring_moves_neither_skin_nor_other_joints_and_is_done_once(clone: Clone) -> None:
    own = centre_joints(clone)
    assert own.vertices_m is clone.vertices_m or (own.vertices_m == clone.vertices_m).all()
    moved = [GENERIC.joint(f"{side}_{name}") for side in SIDES for name in (*RINGED, *BY_AXIS)]
    still = np.setdiff1d(np.arange(94), moved)
    assert (own.joints_m[still] == clone.joints_m[still]).all()
    assert np.abs(centre_joints(own).joints_m - own.joints_m).max() < 0.0015


@pytest.mark.parametrize(("name", "degrees", "first", "last", "share"), [
    ("knee", 120.0, "hip", "knee", 0.85), ("elbow", 120.0, "shoulder", "elbow", 0.75),
])  # fmt: skip
def test_thighs_and_upper_arms_keep_their_thickness_beside_a_bent_joint(name, degrees, first, last, share) -> None:
    own = centre_joints(toy_clone())
    ring = limb_ring("l", first, last, share)
    vertices, _ = posed(own, bent(name, degrees))
    assert enclosed(ring.points(vertices)) > 0.8 * enclosed(ring.points(own.vertices_m))


def test_weights_are_four_at_most_sum_to_one_and_change_smoothly() -> None:
    weights = GENERIC.skin_weights.astype(float)
    assert weights.shape[1] == 4
    assert weights.min() >= 0.0
    assert np.abs(weights.sum(axis=1) - 1.0).max() < 1e-5
    dense = np.zeros((len(weights), 94))
    np.add.at(dense, (np.arange(len(weights))[:, None], GENERIC.skin_joints.astype(int)), weights)
    limbs = [k for k, name in enumerate(GENERIC.segment_names) if name.endswith(("_arm", "forearm", "thigh", "calf"))]
    skin_of_limbs = np.isin(GENERIC.vertex_segment, limbs) & (GENERIC.vertex_part == 0)
    triangles, _ = GENERIC.triangles()
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]]])
    edges = edges[skin_of_limbs[edges].all(axis=1)]
    jump = np.abs(dense[edges[:, 0]] - dense[edges[:, 1]]).sum(axis=1) / 2.0
    assert np.percentile(jump, 99) < 0.4, "no neighbour takes over half of the weight"


def fist(body: Body) -> np.ndarray:
    """Return rotations of two fists."""
    rotations = np.zeros((94, 3))
    for side in SIDES:
        for finger in ("index", "middle", "ring", "pinky"):
            knuckles = [body.joint(f"{side}_{finger}{number}") for number in (1, 2, 3)]
            axis = np.cross(body.joints_m[knuckles[2]] - body.joints_m[knuckles[0]], palm_normal(body, side))
            for knuckle, degrees in zip(knuckles, (80, 95, 65), strict=True):
                rotations[knuckle] = axis / np.linalg.norm(axis) * np.radians(degrees)
    return rotations


def test_fingers_close_to_a_fist_before_the_palm() -> None:
    clone = toy_clone()
    body = body_of(clone)
    _, joints = posed(clone, fist(body))
    for side in SIDES:
        wrist, knuckle = joints[body.joint(f"{side}_wrist")], joints[body.joint(f"{side}_middle1")]
        for finger in ("index", "middle", "ring", "pinky"):
            tip = body.joint(f"{side}_{finger}3")
            assert np.linalg.norm(joints[tip] - wrist) < 0.9 * np.linalg.norm(knuckle - wrist), finger
            before_palm = (joints[tip] - knuckle) @ palm_normal(body, side)
            assert 0.01 < before_palm < 0.06, finger


def test_a_hand_turned_a_quarter_no_longer_wrings_the_wrist() -> None:
    clone = centre_joints(toy_clone())
    body = body_of(clone)
    world = turns.world_from_local(t_pose(body)[None], body.parents)
    for side in SIDES:
        elbow, wrist = body.joint(f"{side}_elbow"), body.joint(f"{side}_wrist")
        forearm = world[0, elbow] @ (body.joints_m[wrist] - body.joints_m[elbow])
        hand = below(body, wrist)
        turn = turns.matrices(forearm / np.linalg.norm(forearm) * np.pi / 2.0)
        world[:, hand] = turn @ world[:, [elbow]]
    rotations = turns.local_from_world(world, body.parents)
    wrung, eased = (
        Motion("turn", np.zeros(1), np.zeros((1, 3)), own) for own in (rotations, shared_twist(body, rotations))
    )
    ring = joint_ring("l", "wrist")
    rest = enclosed(ring.points(clone.vertices_m))
    before, after = (enclosed(ring.points(posed(clone, motion.rotations[0])[0])) for motion in (wrung, eased))
    assert before < 0.65 * rest
    assert after > 0.8 * rest
    hand = body.joint("l_wrist")
    assert np.abs(body.world(wrung)[0, hand] - body.world(eased)[0, hand]).max() < 1e-9, "the hand itself stays"
    assert np.abs(body.places(wrung) - body.places(eased)).max() < 1e-9
