"""An operator is led first to the point whose true place mends most."""

import numpy as np
import pytest

from cloner.detectors.propagation import errors_in_view
from cloner.editing.order import by_expected_gain
from cloner.frames import ViewId
from cloner.records.points import ViewPoints, confidence_of, face_confidence


def face(view=ViewId.FACE_FRONT, unsure=(), placed=()):
    errors = errors_in_view(view)
    expected = np.array([0.3 if name in unsure else 0.03 for name in errors.names])
    fixed = np.array([name in placed for name in errors.names])
    return ViewPoints(view, errors.names, 500.0 + 100.0 * errors.layout_iod, face_confidence(expected), fixed)


def body(*confidence):
    names = tuple(f"waist_{row}" for row in range(len(confidence)))
    places = np.arange(2.0 * len(names)).reshape(-1, 2)
    return ViewPoints(ViewId.BODY_BACK, names, places, np.array(confidence), np.zeros(len(names), dtype=bool))


def order(*sets):
    return by_expected_gain({one.view: one for one in sets})


def test_every_point_comes_once_and_placed_ones_last():
    shown = face(placed=("nose_tip",)), body(0.5, 0.9)
    found = order(*shown)
    assert sorted(found) == sorted((one.view, name) for one in shown for name in one.names)
    assert found[-1] == (ViewId.FACE_FRONT, "nose_tip")


def test_a_point_that_tells_of_others_comes_before_one_as_unsure_that_tells_of_itself():
    ears = [f"ear_{name}_{side}" for name in ("top", "lobe", "outer") for side in "LR"]
    found = [name for _, name in order(face(unsure=ears))]
    first, second = found[:2]
    assert {first[-1], second[-1]} == {"L", "R"}, "one point an ear before a second one of the same ear"


def test_a_body_point_comes_before_a_face_only_when_it_is_likely_to_lie_far_off():
    usual, lost = confidence_of(0.01), confidence_of(0.2)
    found = order(face(), body(usual, lost))
    assert found[0] == (ViewId.BODY_BACK, "waist_1")
    assert found.index((ViewId.BODY_BACK, "waist_0")) > 3


def test_the_small_face_of_the_body_photo_is_left_to_the_large_one():
    small = face()
    small = ViewPoints(ViewId.BODY_FRONT, small.names, small.points_px, small.confidence, small.corrected)
    assert {view for view, _ in order(face(), small)} == {ViewId.FACE_FRONT}
    assert len(order(small)) == len(small.names), "it is all there is"


def test_a_body_s_point_waits_until_it_is_likely_to_lie_where_the_fit_would_ask():
    """Elbows, hips and knees took five of the first twelve drags of a visitor, heels and toes four: for nothing."""
    names = ("r_elbow", "waist_left")

    def first(error):
        sure = np.full(2, confidence_of(error))
        points = ViewPoints(ViewId.BODY_BACK, names, np.eye(2), sure, np.zeros(2, dtype=bool))
        return [name for _, name in order(face(), points)]

    usual = first(0.01)
    assert usual.index("mouth_corner_L") < min(usual.index(name) for name in names)
    lost = first(0.2)
    assert set(lost[:2]) == set(names)


def test_an_ear_in_the_back_photo_is_left_to_the_face_photo():
    back = ViewPoints(ViewId.BODY_BACK, ("ear_outer_L",), np.zeros((1, 2)), np.full(1, 0.4), np.zeros(1, dtype=bool))
    assert (ViewId.BODY_BACK, "ear_outer_L") not in order(face(), back)
    assert order(back) == [(ViewId.BODY_BACK, "ear_outer_L")]


@pytest.mark.parametrize("confidence", [(), (0.4,)])
def test_few_points_are_no_trouble(confidence):
    assert len(order(body(*confidence))) == len(confidence)
