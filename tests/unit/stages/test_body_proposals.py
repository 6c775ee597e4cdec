"""Body points of several photos against each other, and what the operator is told of them."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from cloner.body.bone_checks import check_bones
from cloner.detectors.body.pose_order import mirrored_pose, pose_by_mirror
from cloner.detectors.nets import pose_rows as net
from cloner.detectors.nets.results import PoseResult
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.labels import Label
from cloner.records.points import PhotoState, StateKind, ViewPoints, confidence_of, expected_error
from cloner.records.proposals import Proposals
from cloner.stages.photo_checks import check_photos
from cloner.stages.points import body_proposals, point_warnings
from kit import net as known_net
from kit import people, studio

FRONT, SIDE, BACK = ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK
PERSON = people.known_person(1)


@pytest.fixture(scope="module")
def shown():
    """Return view -> (mask, pose) of one person seen from the front and behind."""
    return {view: known_net.seen(PERSON, people.known_pose(1), view.value)[:2] for view in (FRONT, BACK)}


def legs(view, *, knee_row=600.0):
    """Return two straight legs of 400 px; the figure is 1000 px tall."""
    names = ("l_hip", "l_knee", "l_ankle", "r_hip", "r_knee", "r_ankle", "knee_outer_left")
    rows = (400.0, knee_row, 800.0, 400.0, 600.0, 800.0, knee_row)
    places = np.array([[100.0 if "l" in name[:1] else 60.0, row] for name, row in zip(names, rows, strict=True)])
    return ViewPoints(view, names, places, np.full(len(names), 0.8), np.zeros(len(names), bool))


def test_confidence_and_expected_error_are_inverse():
    assert confidence_of(0.0) == 1.0
    assert expected_error(np.array([confidence_of(0.013)])) == pytest.approx([0.013])


def test_a_knee_that_stretches_its_bones_counts_little_and_the_rest_stays():
    body = {FRONT: legs(FRONT, knee_row=690.0), BACK: legs(BACK)}
    checked = check_bones(body, {FRONT: 1000.0, BACK: 1000.0})
    trust = dict(zip(checked[FRONT].names, checked[FRONT].confidence, strict=True))
    assert trust["l_knee"] < 0.1
    assert trust["knee_outer_left"] < 0.1
    assert trust["r_knee"] == trust["l_hip"] == trust["l_ankle"] == 0.8
    assert any("left knee" in state.sentence for state in checked[FRONT].states)
    assert checked[BACK].confidence.tolist() == body[BACK].confidence.tolist()
    assert checked[BACK].states == ()


def test_bones_of_one_length_are_left_alone():
    body = {FRONT: legs(FRONT, knee_row=615.0), BACK: legs(BACK)}
    checked = check_bones(body, {FRONT: 1000.0, BACK: 1000.0})
    assert all(points.states == () for points in checked.values())


def test_a_good_photo_has_nothing_to_tell(shown):
    body = body_proposals(Proposals({v: known_net.proposal(v.value, *shown[v]) for v in shown}))
    assert point_warnings(body) == ()


def test_a_skirt_is_a_state_and_its_outline_no_body_point(shown):
    skirted, rows = {}, {}
    for view, (mask, pose) in shown.items():
        drawn, hips, knees = mask.copy(), pose[list(net.HIPS)].mean(axis=0), pose[list(net.KNEES)].mean(axis=0)
        hem = 0.15 * hips + 0.85 * knees
        shape = [hips + [-62, -60], hips + [62, -60], hem + [125, 0], hem + [-125, 0]]
        cv2.fillPoly(drawn, [np.int32(shape)], 255)
        skirted[view], rows[view] = known_net.proposal(view.value, drawn, pose), float(hem[1])
    body = body_proposals(Proposals(skirted))
    for view, points in body.items():
        (loose,) = [state for state in points.states if state.kind is StateKind.LOOSE_OUTLINE]
        assert loose.rows_px[1] == pytest.approx(rows[view], abs=25.0)
        assert "crotch" not in points.names
        for name in ("hip_left", "hip_right"):
            if name in points.names:
                assert points.confidence[points.names.index(name)] < 0.15, (view, name)
    assert not any("thighs" in sentence for sentence in point_warnings(body)), (
        "a skirt is no reason to retake the photo"
    )


def test_states_are_told_with_the_photo_s_name():
    state = PhotoState(StateKind.CUT, "", "the picture's bottom border cuts the person; step back")
    points = ViewPoints(SIDE, (), np.zeros((0, 2)), np.zeros(0), np.zeros(0, bool), states=(state,))
    assert point_warnings({SIDE: points}) == ("body_side: the picture's bottom border cuts the person; step back",)


@pytest.mark.parametrize(
    ("toes_surer", "hairy", "refused"), [(True, False, True), (False, False, False), (True, True, False)]
)
def test_a_front_in_the_back_s_place_is_refused_but_exchanged_labels_are_not(shown, toes_surer, hairy, refused):
    mask, pose = shown[FRONT]
    given = known_net.proposal("body_back", mask, pose)
    if hairy:  # the net takes a back for a front now and then; a head that is all hair is seen from behind
        labels = np.zeros(mask.shape, np.uint8)
        labels[: len(mask) // 8][mask[: len(mask) // 8] > 127] = Label.HAIR
        given = replace(given, labels=labels)
    given.pose_visibility.setflags(write=True)
    given.pose_visibility[[*net.HEELS]] = 0.5 if toes_surer else 0.9
    photos = studio.photo_set({BACK: np.zeros((*mask.shape, 3), np.uint8)})
    if not refused:
        check_photos(Proposals({BACK: given}), photos)
        return
    with pytest.raises(ClonerError, match="front, not the back"):
        check_photos(Proposals({BACK: given}), photos)


@pytest.mark.parametrize("right_in_mirror", [True, False])
def test_a_back_read_as_a_front_is_read_again_in_the_mirror(shown, right_in_mirror):
    """The mirror's reading is taken if its sides are right, with all its joints; else the first one stays."""
    mask, pose = shown[BACK]
    height, width = mask.shape
    rgb = np.zeros((height, width, 3), np.uint8)
    seen = np.linspace(0.0, 1.0, 33)
    right = PoseResult(np.asarray(pose, float), seen, seen, 1.0, mask.astype(np.float32))
    swapped = right.points_px.copy()
    for left_row, right_row in net.TWINS:
        swapped[[left_row, right_row]] = right.points_px[[right_row, left_row]]
    wrong = replace(right, points_px=swapped)
    in_mirror = mirrored_pose(right if right_in_mirror else wrong, width)

    found = pose_by_mirror(rgb, BACK, wrong, lambda _: in_mirror)
    want = right if right_in_mirror else wrong
    assert found.points_px == pytest.approx(want.points_px)
    assert found.visibility == pytest.approx(want.visibility)
    assert np.array_equal(found.mask, want.mask)
    assert pose_by_mirror(rgb, BACK, right, lambda _: wrong) is right
