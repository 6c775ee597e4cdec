"""A statue rests in its pose and can still walk."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.statues.poses import ARMS, REST, standing
from kit.clones import toy_clone


def _way(clone, first: str, last: str) -> np.ndarray:
    generic = load_generic()
    way = clone.joints_m[generic.joint(last)] - clone.joints_m[generic.joint(first)]
    return way / np.linalg.norm(way)


@pytest.fixture(scope="module")
def person():
    return toy_clone()


def test_at_rest_nothing_moves(person) -> None:
    assert standing(person, REST) is person


def test_arms_hang_or_are_lifted_as_the_pose_says(person) -> None:
    hanging, guard, hail = (standing(person, pose) for pose in ("standing", "guard", "hail"))
    assert _way(hanging, "r_shoulder", "r_elbow")[1] < -0.95
    assert _way(guard, "r_elbow", "r_wrist")[2] > 0.95  # the forearm points ahead
    assert _way(guard, "r_shoulder", "r_elbow")[1] < -0.9
    assert _way(guard, "l_shoulder", "l_elbow")[1] < -0.9
    assert hail.joints_m[load_generic().joint("r_wrist"), 1] > hail.joints_m[load_generic().joint("r_shoulder"), 1]


@pytest.mark.parametrize("pose", tuple(ARMS))
def test_it_walks_out_of_every_pose_as_out_of_rest(person, pose: str) -> None:
    generic, still = load_generic(), standing(person, pose)
    assert still.vertices_m[:, 1].min() == pytest.approx(person.vertices_m[:, 1].min(), abs=1e-9)
    wrists = []
    for clone in (centre_joints(person), centre_joints(still)):
        walk = own_motions(clone)[0]
        places = [
            joint_transforms(clone.joints_m, generic.joint_parents, frame)[generic.joint("r_wrist")]
            @ np.append(clone.joints_m[generic.joint("r_wrist")], 1.0)
            for frame in walk.rotations[::6]
        ]
        wrists.append(np.array(places)[:, :3])
    assert np.abs(wrists[0] - wrists[1])[:, [0, 2]].max() < 0.06  # metres; arms keep clear of what they were beside


def test_an_unknown_pose_is_refused(person) -> None:
    with pytest.raises(ClonerError, match="lotus"):
        standing(person, "lotus")
