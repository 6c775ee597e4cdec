"""Corrections lie on top of proposals, and exchanged photos are refused."""

import numpy as np
import pytest

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.points import Correction, Corrections, ViewPoints
from cloner.records.proposals import Proposal, Proposals
from cloner.stages import points
from cloner.stages.photo_checks import check_photos
from kit import studio

WIDTH, HEIGHT = 80, 120
FRONT, SIDE, BACK, FACE, FACE_SIDE = ViewId
PHOTOS = studio.photo_set({view: np.zeros((HEIGHT, WIDTH, 3), np.uint8) for view in ViewId})


def proposed(view=FRONT):
    return ViewPoints(
        view,
        ("crotch", "waist_left"),
        np.array([[40.0, 60.0], [50.0, 45.0]]),
        np.array([0.5, 0.7]),
        np.zeros(2, bool),
    )


def proposal(view, shoulders_px, *, face_presence=0.0, nose_px=None, ears_px=None, knee_row=75.0, ankle_row=105.0):
    """Return what nets say of a person 100 px tall whose left and right shoulder lie at these columns.

    With its arms the figure is as wide as people are: half its height from the front, a fifth from the side.
    """
    mask = np.zeros((HEIGHT, WIDTH), np.uint8)
    mask[10:111, slice(15, 65) if np.ptp(shoulders_px) > 10.0 else slice(30, 50)] = 255
    pose = np.zeros((33, 2))
    pose[11], pose[12] = ((column, 30.0) for column in shoulders_px)
    pose[[25, 26], 1], pose[[27, 28], 1] = knee_row, ankle_row
    if nose_px is not None:
        pose[0, 0], pose[[7, 8], 0] = nose_px, ears_px
    return Proposal(
        view, pose, np.ones(33), np.zeros((468, 2)), np.zeros(468), face_presence, mask, np.zeros_like(mask)
    )


def near(view, nose_px, ears_px, **known):
    """Return what nets say of a face photo; hips and legs are guessed below its border."""
    given = {"knee_row": 200.0, "ankle_row": 260.0, **known}
    return proposal(view, (60.0, 20.0), nose_px=nose_px, ears_px=ears_px, **given)


def check(view, shoulders_px, **known):
    check_photos(Proposals({view: proposal(view, shoulders_px, **known)}), PHOTOS)


def test_a_correction_wins_and_the_rest_stays():
    before = proposed()
    after = points.apply_corrections(before, {"crotch": Correction(41.5, 63.25)}, PHOTOS.photos[FRONT])
    assert after.get("crotch") == pytest.approx([41.5, 63.25])
    assert after.get("waist_left") == pytest.approx([50.0, 45.0])
    assert after.confidence.tolist() == [1.0, 0.7]
    assert after.corrected.tolist() == [True, False]
    assert before.get("crotch") == pytest.approx([40.0, 60.0]), "the proposal is unchanged"


def test_a_correction_may_add_a_point_nobody_proposed():
    after = points.apply_corrections(proposed(), {"hip_left": Correction(55.0, 52.0)}, PHOTOS.photos[FRONT])
    assert after.names == ("crotch", "waist_left", "hip_left")
    assert after.get("hip_left") == pytest.approx([55.0, 52.0])
    assert after.corrected.tolist() == [False, False, True]


def standing(**moved):
    """Return the points of a person 100 px tall, some moved by an operator."""
    places = {"head_top": (40.0, 10.0), "sole_left": (45.0, 110.0), "sole_right": (35.0, 110.0), "l_knee": (44.0, 80.0)}
    places |= {"waist_left": (50.0, 45.0)}
    before = ViewPoints(FRONT, tuple(places), np.array(list(places.values())), np.full(5, 0.6), np.zeros(5, bool))
    return before, points.apply_corrections(
        before, {n: Correction(*place) for n, place in moved.items()}, PHOTOS.photos[FRONT]
    )


def test_the_fit_takes_proposals_where_corrections_are_obeyed_later():
    before, after = standing(waist_left=(60.0, 45.0), l_knee=(46.0, 81.0), hip_left=(51.0, 60.0))
    taken = points.points_for_fit(after)
    assert taken.names == before.names, "what nobody proposed moves no whole body"
    assert np.array_equal(taken.points_px, before.points_px)
    assert np.array_equal(taken.confidence, before.confidence)
    assert not taken.corrected.any()


def test_the_fit_takes_the_ends_and_joints_that_were_far_off():
    _, after = standing(head_top=(40.0, 12.0), l_knee=(49.0, 80.0))
    taken = points.points_for_fit(after)
    assert taken.get("head_top") == pytest.approx([40.0, 12.0]), "it sets the scale"
    assert taken.get("l_knee") == pytest.approx([49.0, 80.0]), "5 % of the figure: the proposal was wrong"
    assert dict(zip(taken.names, taken.corrected, strict=True)) == {
        "head_top": True, "sole_left": False, "sole_right": False, "l_knee": True, "waist_left": False,
    }  # fmt: skip
    astray = points.points_for_fit(standing(waist_left=(60.0, 45.0))[1], ("waist_left",))
    assert astray.get("waist_left") == pytest.approx([60.0, 45.0]), "unless the outline itself was wrong there"


@pytest.mark.parametrize("place", [(-1.0, 50.0), (40.0, -0.5), (WIDTH, 50.0), (40.0, HEIGHT + 7.0)])
def test_a_correction_off_the_image_is_refused(place):
    with pytest.raises(ClonerError, match="crotch lies off the image") as caught:
        points.apply_corrections(proposed(), {"crotch": Correction(*place)}, PHOTOS.photos[FRONT])
    assert caught.value.where == "body_front.png"
    assert "Drag it back" in caught.value.hint


def test_photos_that_show_what_they_say_pass():
    check(FRONT, (50.0, 30.0), face_presence=1.0)
    check(SIDE, (41.0, 39.0))
    check(BACK, (30.0, 50.0))


@pytest.mark.parametrize(
    ("view", "shoulders_px", "complaint"),
    [
        (SIDE, (50.0, 30.0), "from the front or back, not from the side"),
        (FRONT, (41.0, 39.0), "from the side, not the front"),
        (BACK, (41.0, 39.0), "from the side, not the back"),
        (FRONT, (30.0, 50.0), "shows the person's back, not the front"),
    ],
)
def test_exchanged_photos_are_refused_by_name(view, shoulders_px, complaint):
    with pytest.raises(ClonerError, match=complaint) as caught:
        check(view, shoulders_px)
    assert caught.value.where == f"{view}.png"
    assert "Rename or retake" in caught.value.hint


@pytest.mark.parametrize(
    ("view", "known", "complaint"),
    [
        (FRONT, {"knee_row": 130.0, "ankle_row": 180.0}, "only the upper part of the person"),
        (SIDE, {"ankle_row": 125.0}, "the feet are outside this photo"),
    ],
)
def test_body_photos_that_cut_the_person_are_refused(view, known, complaint):
    with pytest.raises(ClonerError, match=complaint):
        check(view, (50.0, 30.0), **known)


@pytest.mark.parametrize(
    ("face", "complaint"),
    [
        (near(FACE, 41.0, (60.0, 20.0), face_presence=1.0), ""),
        (near(FACE, 70.0, (30.0, 20.0), face_presence=1.0), "from the side, not from the front"),
        (near(FACE, 41.0, (60.0, 20.0)), "no face can be seen from the front"),
        (near(FACE, 41.0, (43.0, 39.0), face_presence=1.0, ankle_row=105.0), "shows the whole body"),
        (near(FACE_SIDE, 70.0, (30.0, 20.0)), ""),
        (near(FACE_SIDE, 10.0, (30.0, 29.9)), ""),
        (near(FACE_SIDE, 41.0, (60.0, 20.0)), "from the front or back, not from the side"),
        (near(FACE_SIDE, 70.0, (30.0, 20.0), ankle_row=105.0), "shows the whole body"),
    ],
)
def test_face_photos_show_what_they_say(face, complaint):
    given = Proposals({face.view: face})
    if not complaint:
        check_photos(given, PHOTOS)
        return
    with pytest.raises(ClonerError, match=complaint) as caught:
        check_photos(given, PHOTOS)
    assert caught.value.where == f"{face.view}.png"


class Stand:
    """Detectors that always say the same."""

    def get(self, name):
        if name == "body_points":
            return lambda given: proposed(given.view)
        nose = (("nose_tip",), np.array([[40.0, 20.0]]), np.array([0.9]), np.zeros(1, bool))
        return lambda photo, given: ViewPoints(given.view, *nose)


def test_the_stage_sorts_corrections_into_body_and_face(monkeypatch):
    monkeypatch.setattr(points, "DETECTORS", Stand())
    given = Proposals(
        {
            FRONT: proposal(FRONT, (50.0, 30.0), face_presence=1.0),
            FACE: near(FACE, 41.0, (60.0, 20.0), face_presence=1.0),
        }
    )
    placed = {"crotch": Correction(39.0, 61.0), "nose_tip": Correction(42.0, 21.0)}
    fractions = []
    result = points.run(
        photos=PHOTOS,
        proposals=given,
        corrections=Corrections({FRONT: placed, FACE: {"nose_tip": Correction(43.0, 22.0)}}),
        tick=fractions.append,
    )
    body, found = result.values["body_points"].views, result.values["face_points"].views
    assert set(body) == {FRONT}
    assert set(found) == {FRONT, FACE}
    assert body[FRONT].get("crotch") == pytest.approx([39.0, 61.0])
    assert body[FRONT].get("nose_tip") is None
    assert found[FRONT].get("nose_tip") == pytest.approx([42.0, 21.0])
    assert found[FACE].get("nose_tip") == pytest.approx([43.0, 22.0])
    assert fractions[-1] <= 1.0
    (confidence,) = result.residuals
    assert confidence.unit == "percent"
    assert confidence.value == pytest.approx(100.0 * np.mean([(1.0 + 0.7) / 2, 1.0, 1.0]))
