"""A clone whose photos misjudged the spine is still scored in the truth's pose."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.body.hands import scale_hands
from cloner.evaluate.measures.posing import JOINTS, fit_rotations, hand_vertices, pose_clone, truth_from_body
from cloner.evaluate.truths.baselines import generic_clone
from cloner.generic.load import load_generic
from cloner.records.bodies import BodyMesh
from kit import people

STATURE_M = 1.70


def known_clone(seed):
    generic, person = load_generic(), people.known_person(seed, stature_m=STATURE_M, spread=0.4)
    features = {name: person.vertices_m[generic.feature(name)] for name in generic.feature_names}
    plain = generic_clone(generic, STATURE_M)
    return replace(plain, vertices_m=person.vertices_m, joints_m=person.joints_m, features_m=features)


def leaning(degrees):
    """Return a standing pose whose trunk leans forward while the head looks ahead."""
    generic, pose = load_generic(), people.known_pose(3, spread=0.0)
    for joint, share in (("vl5", 0.5), ("vl3", 0.5), ("vc4", -1.0)):
        pose[generic.joint(joint), 0] += share * np.deg2rad(degrees)
    return pose


@pytest.mark.parametrize("degrees", [-10.0, 10.0])
def test_a_leaning_trunk_is_found_though_the_limbs_have_other_lengths(degrees):
    generic = load_generic()
    clone, other = known_clone(23), known_clone(24)
    truth = pose_clone(other, generic, leaning(degrees))
    joints = {name: truth.joints_m[generic.joint(ours)] for name, ours in JOINTS.items()}
    trunk = generic.segment_weights[:, generic.segment_names.index("torso")] > 0.9

    def away_mm(rotations):
        posed = pose_clone(clone, generic, rotations)
        posed = posed.moved(truth_from_body(posed, generic, joints, truth.features_m))
        return 1000 * float(np.linalg.norm(posed.vertices_m[trunk] - truth.vertices_m[trunk], axis=1).mean())

    best, before = away_mm(leaning(degrees)), away_mm(leaning(0.0))
    after = away_mm(fit_rotations(clone, generic, joints, truth.features_m, leaning(0.0)))
    assert before > best + 8.0, "the lean is seen"
    assert after < best + 8.0, f"{before:.1f} -> {after:.1f} mm; in the true pose {best:.1f}"


def true_marks(posed, generic):
    """Return joints and marks of a posed body under the truth's names, hands and feet included."""
    joints = {name: posed.joints_m[generic.joint(ours)] for name, ours in JOINTS.items()}
    hands = {name: posed.vertices_m[vertex] for name, vertex in hand_vertices(generic).items()}
    return joints, {**posed.features_m, **hands}


def tips_turned(pose, wrist_degrees, roll_degrees):
    """Return a pose with both hands turned about the arm and both feet rolled over."""
    generic, turned = load_generic(), pose.copy()
    for side in "lr":
        turned[generic.joint(f"{side}_wrist"), 1] += np.deg2rad(wrist_degrees)
        turned[generic.joint(f"{side}_ankle"), 2] += np.deg2rad(roll_degrees)
    return turned


@pytest.mark.parametrize("segment", ["left_hand", "right_hand", "left_foot", "right_foot"])
def test_a_true_body_in_a_wrong_pose_gets_the_truths_hands_and_feet(segment):
    generic, clone = load_generic(), known_clone(23)
    standing = leaning(0.0)
    truth = pose_clone(clone, generic, standing)
    joints, marks = true_marks(truth, generic)
    rows = generic.vertex_segment == generic.segment_names.index(segment)
    found = fit_rotations(clone, generic, joints, marks, tips_turned(standing, 20.0, 8.0))
    posed = pose_clone(clone, generic, found)
    posed = posed.moved(truth_from_body(posed, generic, joints, marks))
    away_mm = 1000 * np.linalg.norm(posed.vertices_m[rows] - truth.vertices_m[rows], axis=1)
    assert float(away_mm.mean()) < 3.0, f"{segment}: {away_mm.mean():.1f} mm"


def test_hands_of_a_wrong_length_stay_wrong():
    generic, clone = load_generic(), known_clone(23)
    truth = pose_clone(clone, generic, leaning(0.0))
    joints, marks = true_marks(truth, generic)
    longer = scale_hands(BodyMesh(clone.vertices_m, clone.joints_m), np.array([1.2, 1.0]))
    wrong = replace(clone, vertices_m=longer.vertices_m, joints_m=longer.joints_m)
    posed = pose_clone(wrong, generic, fit_rotations(wrong, generic, joints, marks, leaning(0.0)))
    posed = posed.moved(truth_from_body(posed, generic, joints, marks))
    tip = generic.feature("fingertip_left")
    assert 1000 * float(np.linalg.norm(posed.vertices_m[tip] - truth.vertices_m[tip])) > 20.0
