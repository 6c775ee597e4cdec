"""Six manners of walking: planted feet for all, and told apart by what is known of feelings in walks."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cloner.behaviour.model import EMOTIONS
from cloner.generic.load import load_generic
from cloner.motion.limbs.body import SIDES, Body, body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.gait import walk
from cloner.motion.moves.slide import step_slides_m
from cloner.motion.moves.styles import REGULAR, RUN, STYLES, suited
from cloner.records.motions import Motion
from kit.clones import toy_clone

SHAPES = {"mean": None, "child": 1.10, "small": 1.50, "tall": 1.98}


@pytest.fixture(scope="module")
def bodies() -> dict[str, Body]:
    found = {}
    for name, stature in SHAPES.items():
        clone = toy_clone(stature or 1.70, hair=False)
        if stature:
            vertices, joints = load_generic().shape(
                np.random.default_rng(round(100 * stature)).normal(size=20), stature
            )
            clone = centre_joints(replace(clone, vertices_m=vertices, joints_m=joints))
        found[name] = body_of(clone)
    return found


@pytest.fixture(scope="module")
def walks(bodies: dict[str, Body]) -> dict[str, dict[str, Motion]]:
    return {who: {name: walk(body, style) for name, style in STYLES.items()} for who, body in bodies.items()}


def test_every_feeling_of_the_scenarios_has_a_walk_of_about_its_speed(walks: dict[str, dict[str, Motion]]) -> None:
    assert {one.walk for one in EMOTIONS} == set(STYLES)
    for one in EMOTIONS:
        share = 0.2 if one.name == "afraid" else 0.07  # the afraid walk faster still, or run
        assert walks["mean"][one.walk].speed_m_s == pytest.approx(one.speed, rel=share), one.name


@pytest.mark.parametrize("who", SHAPES)
@pytest.mark.parametrize("name", STYLES)
def test_feet_stay_where_they_stand_and_the_walk_closes(
    bodies: dict[str, Body], walks: dict[str, dict[str, Motion]], who: str, name: str
) -> None:
    body, motion = bodies[who], walks[who][name]
    slid = step_slides_m(body, motion)
    assert len(slid) == 2, "a left and a right step"
    assert slid.mean() < 0.005
    assert slid.max() < 0.015
    places = body.places(motion)
    assert np.abs(places[0] - places[-1]).max() < 1e-6
    for side in SIDES:
        hip, knee, ankle = (places[:, body.joint(f"{side}_{part}")] for part in ("hip", "knee", "ankle"))
        assert (np.cross(ankle - hip, knee - hip)[:, 0] < 0.01).all(), "knees bend backwards"


@pytest.mark.parametrize("who", SHAPES)
def test_running_is_faster_than_any_walk_and_no_foot_slides(
    bodies: dict[str, Body], walks: dict[str, dict[str, Motion]], who: str
) -> None:
    motion = walk(bodies[who], RUN)
    assert motion.name == "run"
    assert motion.speed_m_s > 1.15 * max(one.speed_m_s for one in walks[who].values())
    slid = step_slides_m(bodies[who], motion)
    assert len(slid) == 2
    assert slid.max() < 0.005


def swing_m(body: Body, motion: Motion) -> float:
    """How far a wrist goes to and fro against its shoulder."""
    places = body.places(motion)
    return float(np.ptp(places[:, body.joint("l_wrist"), 2] - places[:, body.joint("l_shoulder"), 2]))


def ahead_m(body: Body, motion: Motion, name: str) -> float:
    """How far a joint is before the hips on the whole."""
    places = body.places(motion)
    return float((places[:, body.joint(name), 2] - places[:, body.joint("sacroiliac"), 2]).mean())


def test_feelings_differ_as_they_do_in_people(bodies: dict[str, Body], walks: dict[str, dict[str, Motion]]) -> None:
    for who, body in bodies.items():
        own = walks[who]
        cadences = [own[name].times_s[-1] for name in ("sad", "calm", "regular", "happy", "explosive", "afraid")]
        assert all(after < before for before, after in pairwise(cadences))
        strides = {name: one.speed_m_s * one.times_s[-1] for name, one in own.items()}
        assert strides["sad"] < 0.85 * strides["regular"]
        assert strides["afraid"] < 0.95 * strides["regular"] < strides["happy"]
        swings = [swing_m(body, own[name]) for name in ("sad", "calm", "regular", "happy")]
        assert all(after > before + 0.01 for before, after in pairwise(swings))
        assert swing_m(body, own["afraid"]) < 0.6 * swings[2]
        lean = {name: ahead_m(body, one, "skullbase") for name, one in own.items()}
        assert min(lean["sad"], lean["explosive"], lean["afraid"]) > lean["regular"] + 0.02 > lean["happy"] + 0.02
        nose = {name: body.world(one)[:, body.joint("skullbase"), 1, 2].mean() for name, one in own.items()}
        assert nose["sad"] < -0.3 < -0.1 < nose["regular"] < nose["happy"], "how far up the face looks"


@pytest.mark.parametrize(("sex", "age", "steps", "longer"), [
    ("f", 30.0, 1.0, 1.0), ("m", 30.0, 1.0, 1.0), ("", 7.0, 1.18, 1.0), ("m", 80.0, 1.0, 0.84), ("", 0.0, 1.0, 1.0),
])  # fmt: skip
def test_sex_and_age_shape_a_walk(bodies: dict[str, Body], sex: str, age: float, steps: float, longer: float) -> None:
    body = bodies["mean"]
    usual, own = walk(body), walk(body, suited(REGULAR, sex, age))
    quick = usual.times_s[-1] / own.times_s[-1]
    stride = own.speed_m_s * own.times_s[-1] / (usual.speed_m_s * usual.times_s[-1])
    assert quick == pytest.approx(steps, abs=0.03)
    assert stride == pytest.approx(longer, abs=0.06)
    left, right = body.sole_points(body.world(own), own.root_m)
    assert min(left[..., 1].min(), right[..., 1].min()) > -0.002
    assert step_slides_m(body, own).max() < 0.015
    hips, chest = (np.ptp(Rotation.from_matrix(body.world(own)[:, body.joint(name)]).as_rotvec()[:, 1])
                   / np.ptp(Rotation.from_matrix(body.world(usual)[:, body.joint(name)]).as_rotvec()[:, 1])
                   for name in ("sacroiliac", "vt1"))  # fmt: skip
    assert (hips > 1.2) == (sex == "f")
    assert (chest > 1.1) == (sex == "m")
