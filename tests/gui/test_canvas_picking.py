"""What is picked, what comes next, and where a partner is expected: pure functions."""

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.records.points import ViewPoints
from cloner_gui.canvas.photos.hints import point_hint
from cloner_gui.canvas.photos.picking import (
    expected_mirror_px,
    mirrored_name,
    nearest_on_outline,
    next_in_order,
    worst_first,
)

FRONT, SIDE = ViewId.BODY_FRONT, ViewId.BODY_SIDE


def points(view, rows):
    names, places, sure, fixed = zip(*rows, strict=True)
    return ViewPoints(view, names, np.array(places, float), np.array(sure, float), np.array(fixed))


def test_worst_first_goes_through_all_photos_and_leaves_what_was_placed_for_last():
    shown = {
        FRONT: points(FRONT, [("a", (0, 0), 0.9, False), ("b", (0, 0), 0.1, True), ("c", (0, 0), 0.4, False)]),
        SIDE: points(SIDE, [("d", (0, 0), 0.3, False)]),
    }
    order = worst_first(shown)
    assert order == [(SIDE, "d"), (FRONT, "c"), (FRONT, "a"), (FRONT, "b")]
    assert next_in_order(order, None, 1) == (SIDE, "d")
    assert next_in_order(order, (FRONT, "b"), 1) == (SIDE, "d"), "round and round"
    assert next_in_order(order, (SIDE, "d"), -1) == (FRONT, "b")
    assert next_in_order([], None, 1) is None


def test_partners_by_name():
    pairs = [("eye_inner_L", "eye_inner_R"), ("waist_right", "waist_left"), ("l_knee", "r_knee")]
    for one, other in pairs:
        assert mirrored_name(one) == other
        assert mirrored_name(other) == one
    assert mirrored_name("nose_tip") == ""


@pytest.mark.parametrize("lean_degrees", [0.0, 7.0])
def test_a_partner_is_expected_in_the_mirror_of_a_person_who_leans(lean_degrees):
    half = {"waist": (60.0, 300.0), "hip": (80.0, 400.0), "knee_outer": (70.0, 600.0), "ankle_outer": (50.0, 800.0)}
    turn = np.deg2rad(lean_degrees)
    turned = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    rows = [
        (f"{name}_{side}", turned @ (sign * x, y) + (500.0, 20.0), 0.9, False)
        for name, (x, y) in half.items()
        for side, sign in (("left", 1.0), ("right", -1.0))
    ]
    rows[1] = ("waist_right", (400.0, 350.0), 0.2, False)  # the partner itself lies wrong and must not count
    place = expected_mirror_px(points(FRONT, rows), "waist_left")
    assert place == pytest.approx(turned @ (-60.0, 300.0) + (500.0, 20.0), abs=0.01)
    assert expected_mirror_px(points(SIDE, rows), "waist_left") is None, "a side photo mirrors nobody"


def test_the_nearest_place_on_an_outline_within_reach():
    square = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]])
    assert nearest_on_outline([square], (11.0, 9.0), 3.0).tolist() == [10.0, 10.0]
    assert nearest_on_outline([square], (20.0, 20.0), 3.0) is None
    assert nearest_on_outline([], (0.0, 0.0), 3.0) is None


def test_every_proposed_point_has_a_hint(qapp):
    from cloner.generic.load import load_generic

    unseen = ("nape", "fingertip", "acromion", "vertex_top")  # features of the model that no photo's points name
    marked = [name for name in load_generic().feature_names if not name.startswith(unseen)]
    names = [*marked, "l_knee", "r_hip", "outline_3", "hairline_top"]
    assert [name for name in names if not point_hint(name)] == []
    assert point_hint("knee_outer_left") != point_hint("l_knee"), "outline and joint are told apart"
