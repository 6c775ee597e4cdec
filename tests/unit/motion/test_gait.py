"""The walk and the idle that every clone leaves with."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.motion.limbs.body import SIDES, Body, body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves import contact
from cloner.motion.moves.gait import idle, walk
from cloner.motion.moves.slide import step_slides_m
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from kit.clones import toy_clone


def of_random_shape(stature_m: float, seed: int) -> Clone:
    """Return a toy clone of random proportions."""
    vertices, joints = load_generic().shape(np.random.default_rng(seed).normal(size=20), stature_m)
    return replace(toy_clone(stature_m, hair=False), vertices_m=vertices, joints_m=joints)


@pytest.fixture(scope="module", params=["mean", "child", 1.50, 1.62, 1.74, 1.86, 1.98])
def body(request) -> Body:
    """The mean adult, a child of 1.10 m and five more people of random proportions, their joints centred."""
    if request.param == "mean":
        return body_of(toy_clone())
    stature = 1.10 if request.param == "child" else request.param
    return body_of(centre_joints(of_random_shape(stature, round(100 * stature))))


@pytest.fixture(scope="module")
def walking(body: Body) -> Motion:
    return walk(body)


def test_the_walk_closes_after_one_second(body: Body, walking: Motion) -> None:
    assert walking.times_s[-1] == 1.0
    assert np.abs(walking.rotations[0] - walking.rotations[-1]).max() < 1e-9
    assert np.abs(walking.root_m[0] - walking.root_m[-1]).max() < 1e-9
    places = body.places(walking)
    assert np.abs(places[0] - places[-1]).max() < 0.001, "metres"


def test_a_sole_is_always_on_the_floor_and_none_below_it(body: Body, walking: Motion) -> None:
    left, right = body.sole_points(body.world(walking), walking.root_m)
    low = np.minimum(left[..., 1].min(axis=1), right[..., 1].min(axis=1))
    assert np.abs(low).max() < 0.003


def test_standing_feet_go_with_the_ground_at_the_speed_of_a_walk(body: Body, walking: Motion) -> None:
    assert 0.75 < walking.speed_m_s < 2.1
    slid = step_slides_m(body, walking)
    assert len(slid) == 2, "a left and a right step"
    assert slid.mean() < 0.005
    assert slid.max() < 0.015
    for stands in contact.foot_contacts(body, walking):
        assert 0.4 < stands.mean() < 0.75, "a foot stands for about six tenths of the cycle"


def test_left_and_right_do_the_same_half_a_cycle_apart(body: Body, walking: Motion) -> None:
    places = body.places(walking)
    left, right = (places[:-1, body.joint(f"{side}_ankle")] for side in SIDES)
    assert np.abs(left - np.roll(right, 30, axis=0) * (-1.0, 1.0, 1.0)).max() < 0.02


def test_arms_swing_against_the_legs_and_hang_at_the_sides(body: Body, walking: Motion) -> None:
    places = body.places(walking)
    for side, sign in (("l", 1.0), ("r", -1.0)):
        wrist, ankle = (places[:, body.joint(f"{side}_{name}"), 2] for name in ("wrist", "ankle"))
        assert np.corrcoef(wrist, ankle)[0, 1] < -0.8
        aside = sign * places[:, body.joint(f"{side}_wrist"), 0]
        hip = sign * places[:, body.joint(f"{side}_hip"), 0]
        assert (aside > hip).all()


def test_knees_never_bend_forwards(body: Body, walking: Motion) -> None:
    places = body.places(walking)
    for side in SIDES:
        hip, knee, ankle = (places[:, body.joint(f"{side}_{name}")] for name in ("hip", "knee", "ankle"))
        ahead = np.cross(ankle - hip, knee - hip)[:, 0]  # of a knee in front of the line from hip to ankle
        assert (ahead < 0.01).all()


def test_idle_closes_breathes_and_blinks(body: Body) -> None:
    motion = idle(body)
    assert np.abs(motion.rotations[0] - motion.rotations[-1]).max() < 1e-9
    assert motion.weights["eyeBlinkLeft"].max() > 0.8
    assert motion.weights["eyeBlinkLeft"][[0, -1]].max() == 0.0
    chest = body.places(motion)[:, body.joint("vt3")]
    assert 0.001 < np.ptp(chest, axis=0).max() < 0.05
    feet = body.places(motion)[:, body.joint("l_ankle")]
    assert np.ptp(feet, axis=0).max() < 1e-3


def test_the_ruler_of_slides_counts_a_scuffing_toe_that_nobody_calls_standing(body: Body, walking: Motion) -> None:
    """Told by hand: over ground that runs 10 mm a second faster, each foot's .6 s on it are 6 mm longer."""
    off = step_slides_m(body, replace(walking, speed_m_s=walking.speed_m_s + 0.01))
    assert off == pytest.approx(step_slides_m(body, walking) + 0.006, abs=0.0015)


def test_a_lifted_foot_clears_the_ground(body: Body, walking: Motion) -> None:
    for sole, stands in zip(
        body.sole_points(body.world(walking), walking.root_m), contact.foot_contacts(body, walking), strict=True
    ):
        height = sole[..., 1].min(axis=1)
        between = (height > 0.0041) & ~stands
        assert height[between].min() > 0.005
        assert (height < 0.0001).mean() == pytest.approx(0.6, abs=0.03), "exactly on the floor while it stands"
