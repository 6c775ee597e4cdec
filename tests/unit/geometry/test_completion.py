"""Piecewise affine completion: key points carry all others along, triangle by triangle."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.detectors.face.face_points import complete_face
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.deformation.completion import complete_points, move_neighbours
from cloner.records.photos import Photo
from cloner.records.points import Correction, ViewPoints
from cloner.stages.points import apply_corrections

FACE = {
    "eye_outer_R": (-45, 0), "eye_upper_R": (-33, -5), "eye_lower_R": (-33, 5), "eye_inner_R": (-20, 1),
    "eye_inner_L": (20, 1), "eye_upper_L": (33, -5), "eye_lower_L": (33, 5), "eye_outer_L": (45, 0),
    "nose_tip": (0, 35), "ala_R": (-17, 40), "ala_L": (17, 40), "mouth_corner_R": (-25, 65),
    "mouth_corner_L": (25, 65), "chin_bottom": (0, 105),
}  # fmt: skip
NAMES = tuple(FACE)
GENERIC = np.array([FACE[name] for name in NAMES], dtype=np.float64)
ROWS = {name: row for row, name in enumerate(NAMES)}


def test_an_affine_motion_of_three_keys_moves_every_point_by_it():
    linear, shift = np.array([[2.1, 0.3], [-0.4, 1.8]]), np.array([300.0, 500.0])
    keys = np.array([ROWS[n] for n in ("eye_outer_R", "eye_outer_L", "chin_bottom")])
    true = GENERIC @ linear + shift
    assert complete_points(GENERIC, keys, true[keys]) == pytest.approx(true)


@pytest.mark.parametrize("count", [1, 2])
def test_one_key_shifts_and_two_turn_and_scale(count):
    turn = np.array([[0.0, 3.0], [-3.0, 0.0]]) if count == 2 else np.eye(2)
    true = GENERIC @ turn + [100.0, 50.0]
    keys = np.array([ROWS["eye_outer_R"], ROWS["chin_bottom"]])[:count]
    assert complete_points(GENERIC, keys, true[keys]) == pytest.approx(true)


def test_keys_are_kept_and_a_triangle_is_affine_inside():
    rng = np.random.default_rng(0)
    generic = np.vstack([[[0, 0], [90, 0], [0, 90], [90, 90]], [[20, 20], [30, 25], [25, 40], [35, 35]]]).astype(float)
    goals = generic[:4] + rng.normal(0, 8, (4, 2))
    out = complete_points(generic, np.arange(4), goals)
    assert out[:4] == pytest.approx(goals)
    # the four inner points lie in one triangle: their images hang together by one affine map
    inner = np.column_stack([generic[4:], np.ones(4)])
    _, rest, _, _ = np.linalg.lstsq(inner, out[4:], rcond=None)
    assert rest == pytest.approx(0.0, abs=1e-9)


def test_distinct_keys_are_wanted():
    with pytest.raises(ValueError, match="distinct"):
        complete_points(GENERIC, np.array([1, 1]), GENERIC[[1, 1]])


def test_a_dragged_eye_corner_brings_the_lids_along_and_leaves_the_other_eye():
    px = 400.0 + 4.0 * GENERIC
    moved = np.array([name == "eye_outer_L" for name in NAMES])
    out = move_neighbours(px, moved, px[moved] + [24.0, -16.0])
    shift = {name: np.linalg.norm(out[ROWS[name]] - px[ROWS[name]]) for name in NAMES}
    assert shift["eye_outer_L"] == pytest.approx(np.hypot(24, 16))
    assert 5.0 < shift["eye_upper_L"] < shift["eye_outer_L"]
    assert 5.0 < shift["eye_lower_L"] < shift["eye_outer_L"]
    assert max(shift[n] for n in ("eye_outer_R", "mouth_corner_R", "chin_bottom", "nose_tip")) < 1e-9


def test_corrections_of_a_face_take_neighbours_with_them_but_do_not_fix_them():
    px = 400.0 + 4.0 * GENERIC
    photo = Photo(ViewId.FACE_FRONT, np.zeros((1000, 800, 3), np.uint8), None, "", "face_front.jpg")
    points = ViewPoints(ViewId.FACE_FRONT, NAMES, px, np.full(len(NAMES), 0.7), np.zeros(len(NAMES), dtype=bool))
    goal = px[ROWS["eye_outer_L"]] + [20.0, 0.0]
    out = apply_corrections(points, {"eye_outer_L": Correction(*goal)}, photo)
    assert out.get("eye_outer_L") == pytest.approx(goal)
    assert out.get("eye_upper_L")[0] > px[ROWS["eye_upper_L"], 0] + 4.0
    assert out.corrected.sum() == 1
    assert out.proposed is points


@pytest.mark.parametrize("facing", [1.0, -1.0])
def test_three_key_points_make_a_whole_profile_either_way_round(facing):
    generic = load_generic()
    names = ("nasion", "nose_tip", "subnasale", "stomion", "chin_front", "chin_bottom")
    flat = np.array([generic.vertices_m[generic.feature(name)] for name in names], dtype=np.float64)
    true = 500.0 + 4000.0 * (flat[:, [2, 1]] - flat[1, [2, 1]]) * [facing, -1.0]
    keys = {name: true[row] for row, name in enumerate(names) if name in ("nasion", "nose_tip", "chin_bottom")}
    found = complete_face(ViewId.FACE_SIDE, keys)
    for row, name in enumerate(names):
        assert found.get(name) == pytest.approx(true[row], abs=0.5)
    assert complete_face(ViewId.FACE_SIDE, {"nasion": true[0]}).names == ()
