"""A clone whose photos misjudged the spine is still scored in the truth's pose."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.evaluate.baselines import generic_clone
from cloner.evaluate.posing import JOINTS, pose_clone, rotations_towards, truth_from_body
from cloner.generic.load import load_generic
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
    after = away_mm(rotations_towards(clone, generic, joints, truth.features_m, leaning(0.0)))
    assert before > best + 8.0, "the lean is seen"
    assert after < best + 8.0, f"{before:.1f} -> {after:.1f} mm; in the true pose {best:.1f}"
