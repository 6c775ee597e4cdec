"""What people do while they stand: feet still, hands where the act needs them, closed into a circle."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.motion.limbs.body import SIDES, Body, body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.acts import ACTS
from cloner.records.motions import Motion
from kit.clones import toy_clone


@pytest.fixture(scope="module", params=[None, 1.10, 1.98])
def body(request: pytest.FixtureRequest) -> Body:
    if request.param is None:
        return body_of(toy_clone())
    vertices, joints = load_generic().shape(
        np.random.default_rng(round(100 * request.param)).normal(size=20), request.param
    )
    return body_of(centre_joints(replace(toy_clone(request.param, hair=False), vertices_m=vertices, joints_m=joints)))


def of(body: Body, motion: Motion, name: str) -> np.ndarray:
    """(F, 3) a joint's places in arms' lengths, before, above and left of the skull base."""
    places = body.places(motion)
    rest = [body.joints_m[body.joint(f"r_{part}")] for part in ("shoulder", "elbow", "wrist")]
    arm = np.linalg.norm(rest[1] - rest[0]) + np.linalg.norm(rest[2] - rest[1])
    return np.asarray((places[:, body.joint(name)] - places[:, body.joint("skullbase")]) / arm)


@pytest.mark.parametrize("name", ACTS)
def test_an_act_closes_and_its_feet_stand_still(body: Body, name: str) -> None:
    motion = ACTS[name](body)
    assert (motion.name, motion.cyclic, motion.speed_m_s) == (name, True, 0.0)
    places = body.places(motion)
    assert np.abs(places[0] - places[-1]).max() < 1e-6
    for side in SIDES:
        assert np.ptp(places[:, body.joint(f"{side}_ankle")], axis=0).max() < 1e-3
    assert np.abs(np.diff(places, axis=0)).max() < 0.12, "metres a thirtieth of a second: nothing jumps"


def test_hands_are_where_the_act_needs_them(body: Body) -> None:
    done = {name: act(body) for name, act in ACTS.items()}
    assert of(body, done["point"], "r_wrist")[:, 2].min() > 0.8
    assert np.abs(of(body, done["point"], "r_wrist")[:, 1]).max() < 0.4
    assert of(body, done["wave"], "r_wrist")[:, 1].max() > -0.25, "the hand at the face's height"
    wrists = [of(body, done["photograph"], f"{side}_wrist") for side in SIDES]
    assert all((one[:, 2] > 0.4).all() and (np.abs(one[:, 1]) < 0.3).all() for one in wrists), "before the face"
    chin = of(body, done["look"], "r_wrist")
    assert np.linalg.norm(chin, axis=1).max() < 0.6
    given = of(body, done["pay"], "r_wrist")[:, 2]
    assert np.ptp(given) > 0.3, "out and back"
    lifted = body.places(done["lift"])[:, body.joint("r_wrist"), 1]
    assert lifted.min() < 0.27, "on the ground"
    assert of(body, done["lift"], "r_wrist")[:, 1].max() > -0.25, "before the face"


def test_hands_clap_four_times_in_two_seconds(body: Body) -> None:
    motion = ACTS["applaud"](body)
    left, right = (of(body, motion, f"{side}_wrist") for side in SIDES)
    apart = np.linalg.norm(left - right, axis=1)[:-1]
    nearest = (apart <= np.roll(apart, 1)) & (apart < np.roll(apart, -1))
    assert nearest.sum() == 4
    assert motion.times_s[-1] == 2.0
    assert apart.min() < 0.4 < 0.55 < apart.max()
