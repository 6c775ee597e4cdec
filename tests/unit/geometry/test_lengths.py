"""Lengths over known shapes, and of the generic human."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.lengths import tape_path_mm
from cloner.geometry.measurement.measuring import ALL_KEYS, bare_rows, measures_mm
from cloner.records.measures import BY_KEY, Cover

BALL = trimesh.creation.icosphere(subdivisions=5, radius=0.2)
POINTS, FACES = np.asarray(BALL.vertices), np.asarray(BALL.faces, dtype=np.int32)


def test_a_tape_over_a_ball_is_an_arc() -> None:
    pole, side = np.array([0.0, 0.2, 0.0]), np.array([0.2, 0.0, 0.0])
    assert tape_path_mm(POINTS, FACES, np.array([pole, side]), np.array([1.0, 1.0, 0.0])) == pytest.approx(
        100 * np.pi, rel=2e-3
    )
    halves = np.array([side, -side])
    below = tape_path_mm(POINTS, FACES, halves, np.array([0.0, -1.0, 0.0]), beyond=True)
    assert below == pytest.approx(200 * np.pi, rel=2e-3)


def test_a_tape_bridges_hollows_and_is_straight_where_nothing_is_in_its_way() -> None:
    ends = np.array([[0.0, 0.2, 0.0], [0.2, 0.0, 0.0]])
    assert tape_path_mm(POINTS, FACES, ends, np.array([-1.0, -1.0, 0.0])) > 100 * np.pi, "round the far side"
    away = ends + [0.0, 0.0, 0.5]
    assert tape_path_mm(POINTS, FACES, away, np.array([1.0, 1.0, 0.0])) == pytest.approx(1e3 * 0.2 * np.sqrt(2))
    pair = np.concatenate([POINTS - [0.3, 0, 0], POINTS + [0.3, 0, 0]])
    both = np.concatenate([FACES, FACES + len(POINTS)]).astype(np.int32)
    tops = np.array([[-0.3, 0.2, 0.0], [0.3, 0.2, 0.0]])
    assert tape_path_mm(pair, both, tops, np.array([0.0, 1.0, 0.0])) == pytest.approx(600.0, abs=1.0)


def test_measures_of_the_generic_human_are_human_and_scale_with_it() -> None:
    generic, rules = load_generic(), load_tape_rules()
    small, tall = (measures_mm(*generic.shape(np.zeros(0), stature_m), rules) for stature_m in (1.5, 1.8))
    assert tuple(small) == ALL_KEYS
    for key in ALL_KEYS:
        assert tall[key] == pytest.approx(1.2 * small[key], rel=0.02), key
    #: Shares of the stature, 5th woman to 95th man of adult surveys, a little widened.
    shares = {
        "back_neck_height": (0.83, 0.89), "shoulder_height": (0.79, 0.85), "waist_height": (0.57, 0.66),
        "hip_height": (0.45, 0.55), "inside_leg_height": (0.42, 0.50), "knee_height": (0.25, 0.31),
        "shoulder_width": (0.21, 0.28), "biacromial_breadth": (0.20, 0.25), "chest_depth": (0.11, 0.18),
        "arm_length": (0.30, 0.37), "back_waist_length": (0.21, 0.28), "total_crotch_length": (0.33, 0.48),
        "head_length": (0.10, 0.13), "head_breadth": (0.08, 0.10), "face_length": (0.06, 0.075),
        "hand_length": (0.09, 0.12), "foot_length": (0.13, 0.165), "head_girth": (0.29, 0.36),
        "wrist_girth": (0.08, 0.11), "ankle_girth": (0.12, 0.18), "knee_girth": (0.19, 0.25),
    }  # fmt: skip
    for key, (low, high) in shares.items():
        assert low < tall[key] / 1800 < high, f"{key}: {tall[key]:.0f} mm"
    assert tall["narrowest_waist_girth"] <= tall["waist_girth"] < tall["hip_girth"]
    assert tall["biacromial_breadth"] < tall["shoulder_width"] < 1.2 * tall["biacromial_breadth"]


def test_heights_are_counted_from_the_naked_soles() -> None:
    generic, rules = load_generic(), load_tape_rules()
    vertices, joints = generic.shape(np.zeros(0), 1.7)
    bare, shod = (measures_mm(vertices + [0, up, 0], joints + [0, up, 0], rules, up) for up in (0.0, 0.03))
    for key in ("inside_leg_height", "waist_height", "knee_height", "hip_girth"):
        assert shod[key] == pytest.approx(bare[key], abs=0.5), key


def test_only_what_is_bare_on_both_sides_counts_as_bare() -> None:
    bare, sleeve = Cover((False,) * 8, 0.9), Cover((True,) * 4 + (False,) * 4, 0.9)
    row = {key: place for place, key in enumerate(ALL_KEYS)}
    both = bare_rows({"left_forearm": bare, "right_forearm": bare, "left_upper_arm": sleeve, "right_upper_arm": sleeve})
    assert both[row["wrist_girth"]]
    assert not both[row["upper_arm_slice_30"]]
    assert both[row["upper_arm_slice_70"]]
    assert not both[row["bust_girth"]], "nobody saw the trunk bare"
    assert not bare_rows({"left_forearm": bare, "right_forearm": sleeve})[row["forearm_slice_15"]]
    assert not bare_rows({"left_forearm": Cover((None,) * 8, 0.0)}).any()
    assert set(BY_KEY) <= set(ALL_KEYS)
