"""Levels along the body: what is seen narrows them, and what contradicts the rest is refused."""

import numpy as np
import pytest

from cloner.detectors.body.levels import LevelModel, infer_levels, load_levels, load_offsets

#: Three joints on a common scale and a feature halfway between the last two.
SCALE = np.array([0.8, 0.55, 0.3, 0.1, 0.42])
MODEL = LevelModel(
    ("net_shoulder", "net_hip", "net_knee", "net_ankle", "thigh"),
    SCALE,
    0.02**2 * np.outer(SCALE, SCALE) / 0.25 + 0.005**2 * np.eye(5),
)


def test_what_is_seen_moves_and_narrows_what_is_not():
    before = infer_levels(MODEL, {})
    after = infer_levels(MODEL, dict(zip(MODEL.names[:4], 1.05 * SCALE[:4], strict=True)))
    assert before.level["thigh"] == pytest.approx(0.42)
    assert after.level["thigh"] == pytest.approx(1.05 * 0.42, abs=0.006)
    assert after.sigma["thigh"] < 0.5 * before.sigma["thigh"]
    assert after.refused == ()


@pytest.mark.parametrize("wrong", MODEL.names[:4])
def test_a_level_that_contradicts_the_others_is_refused(wrong):
    seen = dict(zip(MODEL.names[:4], SCALE[:4], strict=True))
    seen[wrong] += 0.08
    found = infer_levels(MODEL, seen)
    assert found.refused == (wrong,)
    assert found.level["thigh"] == pytest.approx(0.42, abs=0.006)


def test_shipped_levels_are_in_anthropometric_order():
    for kind in ("front", "back"):
        level = infer_levels(load_levels(kind), {}).level
        order = ("neck_base", "joint_shoulder", "armpit", "waist", "joint_hip", "hip", "joint_knee", "ankle_outer")
        heights = [level[name] for name in order]
        assert heights == sorted(heights, reverse=True), (kind, dict(zip(order, heights, strict=True)))
    level = infer_levels(load_levels("side"), {}).level
    order = ("neck_back", "back", "waist_back", "buttock", "thigh_back", "knee_back", "calf", "ankle_back")
    heights = [level[name] for name in order]
    assert heights == sorted(heights, reverse=True)


def test_every_usual_error_is_small_and_told():
    for kind in ("front", "side", "back"):
        offsets = load_offsets(kind)
        assert np.abs(offsets.offset).max() < 0.04
        assert ((offsets.error > 0.001) & (offsets.error < 0.025)).all()
