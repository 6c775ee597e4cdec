"""Where a photo shows arms: by the joints that the label net sees, also where the pose net sees none."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.generic.seen_points import combined_pose
from cloner.vision.photographs.arms import arm_zone
from kit import net as known_net
from kit import people

SHOWN = {
    view: known_net.seen(people.known_person(1), people.known_pose(1), view) for view in ("body_front", "body_side")
}
JOINTS = [11, 12, 13, 14, 15, 16, 23, 24, 25, 26, 27, 28]
NEAR, FAR = 1, 0  # side photos show the person's right


def hidden_wrists(view):
    """Return a proposal whose pose net sees no wrist, as with hands in pockets, and the true pose (33, 2)."""
    mask, pose, *_ = SHOWN[view]
    given = known_net.proposal(view, mask, pose)
    visibility = given.pose_visibility.copy()
    visibility[[15, 16, 17, 18, 19, 20, 21, 22]] = 0.1
    visibility[[11, 13, 23, 25, 27]] -= 0.2
    return replace(given, pose_visibility=visibility), pose


@pytest.mark.parametrize("view", ["body_front", "body_side"])
def test_joints_seen_under_clothes_stand_for_the_pose_s(view):
    given, pose = hidden_wrists(view)
    seen = np.vstack([pose[JOINTS] + 3.0, np.zeros((9, 2))])
    places, visibility = combined_pose(replace(given, seen_px=seen))
    np.testing.assert_array_equal(places[JOINTS], seen[:12])
    np.testing.assert_array_equal(places[:11], given.pose_px[:11])
    assert (visibility[JOINTS[NEAR::2]] == 1.0).all()
    told = 1.0 if view == "body_front" else given.pose_visibility[JOINTS[FAR::2]]
    np.testing.assert_array_equal(visibility[JOINTS[FAR::2]], told)


def test_an_arm_whose_hand_is_hidden_is_an_arm():
    given, pose = hidden_wrists("body_side")
    shape, height = given.mask.shape, 1000.0
    assert not arm_zone(combined_pose(given), height, shape).any()
    seen = replace(given, seen_px=np.vstack([pose[JOINTS], np.zeros((9, 2))]))
    zone, lower = (
        arm_zone(combined_pose(seen), height, shape),
        arm_zone(combined_pose(seen), height, shape, below_shoulder=0.5),
    )
    column, row = np.rint(pose[[12, 14, 16]]).astype(int).T
    assert zone[row, column].all()
    assert not lower[row[0], column[0]]
    assert lower[row[1:], column[1:]].all()
