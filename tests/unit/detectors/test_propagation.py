"""A placed point mends its neighbours, wherever the face lies in the photo, and never moves what was placed."""

import numpy as np
import pytest

from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.propagation import errors_in_view, propagate_corrections, propagate_to_net
from cloner.frames import ViewId
from cloner.records.points import ViewPoints, expected_face_error, face_confidence

FRONT, SIDE = ViewId.FACE_FRONT, ViewId.FACE_SIDE
IOD_PX = 150.0


def named(view, facing=1):
    """Return the names of a photo's points; who looks to the image's right shows the right ear."""
    side = "R" if facing > 0 else "L"
    names = errors_in_view(view).names
    return tuple(f"{name}_{side}" if view is SIDE and name.startswith("ear") else name for name in names)


def photo_of(view, seed, facing=1):
    """Return a face's points as a detector that errs as measured proposes them, and where they truly are."""
    errors, rng = errors_in_view(view), np.random.default_rng(seed)
    expected = np.full(len(errors.names), 0.05)
    away = rng.multivariate_normal(np.zeros(len(errors.moment)), errors.moment).reshape(-1, 2) * expected[:, None]
    flip = np.array([facing, 1.0])
    proposed_px = 500.0 + IOD_PX * errors.layout_iod * flip
    points = ViewPoints(
        view, named(view, facing), proposed_px, face_confidence(expected), np.zeros(len(expected), dtype=bool)
    )
    return points, proposed_px + IOD_PX * away * flip


def placing(points, *names):
    return np.array([name.removesuffix("_L").removesuffix("_R") in names or name in names for name in points.names])


@pytest.mark.parametrize(
    ("view", "names"), [(FRONT, ("glabella", "ear_top_L", "lip_bottom")), (SIDE, ("ear_top", "stomion", "nasion"))]
)
def test_three_placed_points_mend_a_quarter_of_what_the_others_err(view, names):
    before, after = [], []
    for seed in range(20):
        points, true_px = photo_of(view, seed)
        fixed = placing(points, *names)
        places, confidence = propagate_corrections(points, fixed, true_px[fixed])
        assert np.array_equal(places[fixed], true_px[fixed])
        assert (confidence >= points.confidence - 1e-12).all()
        before.append(((points.points_px - true_px)[~fixed] ** 2).sum())
        after.append(((places - true_px)[~fixed] ** 2).sum())
    assert np.mean(after) < 0.75 * np.mean(before)


def test_the_doubt_that_is_left_is_what_the_others_still_err():
    told, true = [], []
    for seed in range(60):
        points, true_px = photo_of(FRONT, seed)
        fixed = placing(points, "nose_tip", "ear_top_L", "ear_top_R")
        places, confidence = propagate_corrections(points, fixed, true_px[fixed])
        told.append(expected_face_error(confidence[~fixed]) ** 2 * _honest(FRONT)[~fixed])
        true.append(((places - true_px)[~fixed] ** 2).sum(axis=1) / IOD_PX**2)
    assert np.sqrt(np.sum(told) / np.sum(true)) == pytest.approx(1.0, abs=0.15)


def _honest(view):
    """Return how large squared errors are against what the detectors expect."""
    return np.diag(errors_in_view(view).moment).reshape(-1, 2).sum(axis=1)


def test_a_tilted_larger_photo_is_taught_alike():
    points, true_px = photo_of(FRONT, 3)
    fixed = placing(points, "nose_tip", "mouth_corner_L")
    turn = 1.7 * np.array([[np.cos(0.4), -np.sin(0.4)], [np.sin(0.4), np.cos(0.4)]])
    tilted = ViewPoints(FRONT, points.names, points.points_px @ turn.T + 40.0, points.confidence, points.corrected)
    plain, _ = propagate_corrections(points, fixed, true_px[fixed])
    places, _ = propagate_corrections(tilted, fixed, true_px[fixed] @ turn.T + 40.0)
    assert places == pytest.approx(plain @ turn.T + 40.0, abs=1e-6)


def test_who_looks_left_is_taught_as_who_looks_right():
    (right, right_true), (left, left_true) = photo_of(SIDE, 4, 1), photo_of(SIDE, 4, -1)
    fixed = placing(right, "nose_tip", "ear_lobe")
    mirrored = propagate_corrections(left, fixed, left_true[fixed])[0] * [-1.0, 1.0] + [1000.0, 0.0]
    assert mirrored == pytest.approx(propagate_corrections(right, fixed, right_true[fixed])[0], abs=1e-6)


def test_a_point_left_where_it_was_proposed_says_nothing():
    points, _ = photo_of(FRONT, 5)
    fixed = placing(points, "nose_tip")
    places, confidence = propagate_corrections(points, fixed, points.points_px[fixed])
    assert np.array_equal(places, points.points_px)
    assert np.array_equal(confidence[~fixed], points.confidence[~fixed])


def test_the_net_follows_what_its_named_points_were_told():
    points, _ = photo_of(FRONT, 6)
    net = load_face_net()
    net_px = np.random.default_rng(0).normal(500.0, 60.0, (468, 2))
    fixed = placing(points, "glabella")  # the nose's tip is found without the net and tells less of it
    goal = points.points_px + np.array([0.0, 20.0])
    moved = points.points_px.copy()
    moved[fixed] = goal[fixed]
    after = ViewPoints(FRONT, points.names, moved, points.confidence, fixed, points)
    shift = net.rules @ (propagate_to_net(net_px, after) - net_px)
    rows = {name: row for row, name in enumerate(net.names)}
    assert shift[rows["glabella"], 1] > 10.0
    assert shift[rows["glabella"], 1] > 2.0 * abs(shift[rows["mouth_corner_L"], 1])
    untouched = ViewPoints(FRONT, points.names, points.points_px, points.confidence, points.corrected)
    assert np.array_equal(propagate_to_net(net_px, untouched), net_px)
