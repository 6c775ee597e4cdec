"""Photos are refused only for what is certain: one misled sign is outvoted, and what hides a face is no mistake."""

import functools
import pickle
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cloner.detectors.nets.placing import is_upright
from cloner.detectors.nets.results import Box, PoseResult
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.labels.evidence import LabelEvidence
from cloner.labels.evidence import label_evidence as whole_look
from cloner.records.labels import Label
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import Corrections, ViewPoints
from cloner.records.proposals import Proposals
from cloner.stages import figures, photo_checks, points
from cloner.stages.figures import NobodySeen, nobody_seen
from cloner.stages.hidden import SOMEBODY, shares_colours
from cloner.stages.photo_checks import check_photos, front_odds, profile_odds, side_odds
from cloner.stages.proposals import COVERED, HIDDEN, propose, resolve_hidden
from kit import studio
from kit.visitors import photo

FRONT, SIDE, BACK, FACE, FACE_SIDE = ViewId


@functools.cache
def seen(view):
    rgb = photo("anna", "plain", view.value).rgb
    given = Photo(view, rgb, 79.0, view.value, f"{view}.jpg")
    return propose(given), given


def checked(proposal, given, view):
    check_photos(Proposals({view: replace(proposal, view=view)}), PhotoSet({view: replace(given, view=view)}))


def test_a_profile_whose_ears_the_net_misplaces_is_a_profile():
    proposal, given = seen(FACE_SIDE)
    pose = proposal.pose_px.copy()
    nose, up = pose[0].copy(), float(pose[[11, 12], 1].mean() - pose[0, 1])
    pose[7], pose[8] = nose - [0.2 * up, 0.0], nose + [0.2 * up, 0.0]  # as beards and long hair mislead it
    misled = replace(proposal, pose_px=pose)
    assert profile_odds(misled) < profile_odds(proposal) - 3.0
    checked(misled, given, FACE_SIDE)


@pytest.mark.parametrize(
    ("shown", "name", "complaint"),
    [
        (FACE, FACE_SIDE, "from the front or back, not from the side"),
        (FRONT, SIDE, "from the front or back, not from the side"),
        (SIDE, FRONT, "from the side, not the front"),
        (SIDE, BACK, "from the side, not the back"),
        (BACK, FRONT, "back, not the front"),
        (FRONT, BACK, "front, not the back"),
    ],
)
def test_photos_under_another_name_are_refused(shown, name, complaint):
    proposal, given = seen(shown)
    faced = proposal.face_presence if name in (FRONT, FACE) else 0.0
    checked(proposal, given, shown)
    with pytest.raises(ClonerError, match=complaint):
        checked(replace(proposal, face_presence=faced), given, name)


def test_a_back_that_the_net_takes_for_a_front_passes_beside_a_front_with_a_face():
    proposal, given = seen(BACK)
    pose, visible = proposal.pose_px.copy(), proposal.pose_visibility.copy()
    pose[[11, 12]] = pose[[12, 11]]
    visible[[29, 30]], visible[[31, 32]] = 0.3, 0.8
    misled = replace(proposal, pose_px=pose, pose_visibility=visible)
    assert front_odds(misled) == pytest.approx(4.0)
    front, front_photo = seen(FRONT)
    check_photos(Proposals({FRONT: front, BACK: misled}), PhotoSet({FRONT: front_photo, BACK: given}))
    bald = np.where(misled.labels == Label.HAIR, Label.FACE_SKIN, misled.labels).astype(np.uint8)
    checked(misled, given, BACK)  # a head that is all hair is no front
    with pytest.raises(ClonerError, match="front, not the back"):
        checked(replace(misled, labels=bald), given, BACK)


def test_shoulders_alone_do_not_turn_a_front_photo():
    proposal, given = seen(FRONT)
    pose = proposal.pose_px.copy()
    pose[[11, 12], 0] = pose[[11, 12], 0].mean() + np.array([0.4, -0.4]) * np.ptp(pose[[11, 12], 0]) * 0.9
    narrow = replace(proposal, pose_px=pose)
    assert side_odds(narrow) > side_odds(proposal)
    checked(narrow, given, FRONT)


def test_a_body_upside_down_is_a_pattern():
    keys = np.array([[50.0, 60.0], [50.0, 10.0], [50.0, 30.0], [50.0, 15.0]])
    assert is_upright(Box("person", 0, 0, 100, 120, 0.6, keys))
    assert not is_upright(Box("person", 0, 0, 100, 120, 0.6, keys[[1, 0, 3, 2]]))


def portrait(colour, wall=(90, 140, 190)):
    """Return a picture of a blob of one colour that the lower edge cuts, and the blob."""
    rgb = np.empty((160, 120, 3), np.uint8)
    rgb[:] = wall
    mask = np.zeros((160, 120), bool)
    mask[30:, 30:95] = True
    rgb[mask] = colour
    return rgb, mask


def test_a_portrait_in_the_person_s_colours_is_the_person():
    hair, clothes = (70, 45, 30), (160, 40, 60)
    body, mask = portrait(clothes)
    body[30:60][mask[30:60]] = hair
    others = [(body, mask)]
    assert shares_colours(portrait(hair, wall=(200, 200, 190))[0], others) > 0.9
    assert shares_colours(portrait((40, 120, 60), wall=(200, 200, 190))[0], others) == pytest.approx(0.0)
    assert shares_colours(np.full((160, 120, 3), hair, np.uint8), others) < SOMEBODY, "a wall of the hair's colour"


def _seeing(monkeypatch, soft):
    """Let the label net see a person of these probabilities."""

    class Seen(LabelEvidence):
        def person(self, shape):
            return soft

    def look(*given, **more):
        seen = whole_look(*given, **more)
        return Seen(seen.whole, seen.near, seen.box, seen.head, seen.seen_px, seen.naked_px)

    monkeypatch.setattr(figures, "label_evidence", look)


@pytest.mark.parametrize(("torn", "alike", "kept"), [(False, True, True), (True, True, False), (False, False, False)])
def test_a_side_photo_of_hair_alone_is_kept_by_its_mask_or_left_out(monkeypatch, torn, alike, kept):
    hair = (70, 45, 30)
    front, mask = portrait(hair)
    side, inside = portrait(hair if alike else (40, 120, 60), wall=(200, 200, 190))
    pictures = studio.photo_set({FACE: front, FACE_SIDE: side})
    soft = np.where(inside, 0.5 if torn else 1.0, 0.0).astype(np.float32)
    soft[:40] = np.where(inside[:40], 1.0, 0.0)
    _seeing(monkeypatch, soft)
    known = {FACE: studio.empty_proposal(FACE, mask)}
    unseen = {FACE_SIDE: nobody_seen(pictures.photos[FACE_SIDE])}
    found = resolve_hidden(pictures, known, unseen)
    assert (FACE_SIDE in found.views) is kept
    assert dict(found.left_out) == ({} if kept else {FACE_SIDE: HIDDEN})
    check_photos(found, pictures)  # an unseen pose is no reason to refuse


@pytest.mark.parametrize("body", [True, False])
def test_a_face_behind_hair_is_left_out_beside_the_front_of_the_body_and_refused_alone(monkeypatch, body):
    hair = (70, 45, 30)
    front, mask = portrait(hair)
    other = FRONT if body else FACE_SIDE
    pictures = studio.photo_set({other: front, FACE: portrait(hair, wall=(200, 200, 190))[0]})
    _seeing(monkeypatch, mask.astype(np.float32))
    known, unseen = {other: studio.empty_proposal(other, mask)}, {FACE: nobody_seen(pictures.photos[FACE])}
    if body:
        found = resolve_hidden(pictures, known, unseen)
        assert set(found.views) == {FRONT}
        assert dict(found.left_out) == {FACE: HIDDEN}
    else:
        with pytest.raises(NobodySeen):
            resolve_hidden(pictures, known, unseen)


def test_a_side_photo_of_hair_that_may_be_a_back_is_left_out_and_one_with_a_face_refused():
    proposal, given = seen(FACE)
    bare = proposal.labels.copy()
    bare[bare == Label.FACE_SKIN] = Label.HAIR
    hair = replace(proposal, view=FACE_SIDE, labels=bare)
    beside = PhotoSet({FACE: given, FACE_SIDE: replace(given, view=FACE_SIDE)})
    found = resolve_hidden(beside, {FACE: proposal, FACE_SIDE: hair}, {})
    assert dict(found.left_out) == {FACE_SIDE: COVERED}
    assert set(found.views) == {FACE}
    assert dict(found.covered) == {FACE_SIDE: hair}
    assert dict(found.without({FACE: "a reason"}).covered) == {FACE_SIDE: hair}
    shoulder = bare.copy()
    shoulder[-40:][bare[-40:] == Label.HAIR] = Label.FACE_SKIN
    grey = replace(given, view=FACE_SIDE, rgb=np.full_like(given.rgb, 128))  # in which nobody sees a face
    alone = PhotoSet({FACE: given, FACE_SIDE: grey})
    assert FACE_SIDE in resolve_hidden(alone, {FACE: proposal, FACE_SIDE: replace(hair, labels=shoulder)}, {}).left_out
    with_face = resolve_hidden(beside, {FACE: proposal, FACE_SIDE: replace(proposal, view=FACE_SIDE)}, {})
    with pytest.raises(ClonerError, match="not from the side"):
        check_photos(with_face, beside)


@pytest.mark.parametrize(("broad", "stands"), [(20, True), (62, True), (90, False)])  # aside, arms away, too broad
def test_somebody_standing_whom_only_the_label_net_sees_is_left_out(monkeypatch, broad, stands):
    front, mask = portrait((70, 45, 30))
    pictures = studio.photo_set({FACE: front, SIDE: np.full((160, 120, 3), 120, np.uint8)})
    soft = np.zeros((160, 120), np.float32)
    soft[20:140, 60 - broad // 2 : 60 + broad // 2] = 1.0
    _seeing(monkeypatch, soft)
    known, unseen = {FACE: studio.empty_proposal(FACE, mask)}, {SIDE: nobody_seen(pictures.photos[SIDE])}
    if stands:
        assert dict(resolve_hidden(pictures, known, unseen).left_out) == {SIDE: HIDDEN}
    else:
        with pytest.raises(NobodySeen):
            resolve_hidden(pictures, known, unseen)


@pytest.mark.parametrize("sure", [True, False])
def test_whom_only_the_label_net_sees_stand_is_asked_of_the_pose_net(monkeypatch, sure):
    proposal, given = seen(SIDE)
    asked = []

    def pose_in_mask(rgb, inside):
        asked.append(inside)
        sight, mask = proposal.pose_visibility, proposal.mask.astype(np.float32) / 255.0
        return PoseResult(proposal.pose_px, sight, sight, 1.0, mask) if sure else None

    own = {"people": lambda rgb: [], "pose_in_mask": pose_in_mask}
    others = figures.DETECTORS
    monkeypatch.setattr(figures, "DETECTORS", SimpleNamespace(get=lambda name: own.get(name) or others.get(name)))
    if sure:
        assert (figures.find_figure(given).pose_px == proposal.pose_px).all()
    else:
        with pytest.raises(NobodySeen):
            figures.find_figure(given)
    (inside,) = asked
    person = proposal.mask > 127
    assert (inside & person).sum() > 0.9 * (inside | person).sum()


@pytest.mark.parametrize("short", [True, False])
def test_somebody_whom_the_pose_net_sees_to_the_shins_is_looked_at_whole(monkeypatch, short):
    proposal, given = seen(SIDE)
    person = proposal.mask > 127
    rows = np.flatnonzero(person.any(axis=1))
    mask = proposal.mask.astype(np.float32) / 255.0
    if short:
        mask[rows[0] + 7 * len(rows) // 10 :] = 0.0
    asked, sight = [], proposal.pose_visibility

    def pose_in_mask(rgb, inside):
        asked.append(inside)
        return PoseResult(proposal.pose_px, sight, sight, 1.0, proposal.mask.astype(np.float32) / 255.0)

    own = {"pose": lambda rgb, box: PoseResult(proposal.pose_px, sight, sight, 1.0, mask), "pose_in_mask": pose_in_mask}
    others = figures.DETECTORS
    monkeypatch.setattr(figures, "DETECTORS", SimpleNamespace(get=lambda name: own.get(name) or others.get(name)))
    inside = figures.find_figure(given).inside
    assert len(asked) == short
    assert (inside & person).sum() > 0.98 * (inside | person).sum()


def test_a_face_beside_its_hair_is_a_profile_whatever_the_pose_net_reads(monkeypatch):
    proposal, given = seen(FACE_SIDE)
    front, _ = seen(FACE)
    assert photo_checks.face_offset_in_head(proposal) > 0.2
    assert photo_checks.face_offset_in_head(front) < 0.1
    bald = np.where(proposal.labels == Label.HAIR, Label.FACE_SKIN, proposal.labels).astype(np.uint8)
    assert photo_checks.face_offset_in_head(replace(proposal, labels=bald)) == 0.0
    monkeypatch.setattr(photo_checks, "_outline_odds", lambda proposal: -2.0)  # a beard has no profile
    misread = replace(proposal, pose_px=front.pose_px)
    assert photo_checks.profile_odds(misread) < -2.0
    assert photo_checks.side_face_odds(misread, given) > 0.0
    assert photo_checks.side_face_odds(replace(misread, labels=front.labels), given) < 0.0


def test_the_pose_of_a_head_counts_less_where_hair_hides_the_face():
    proposal, given = seen(FACE_SIDE)
    assert photo_checks.pose_reliability(proposal) == pytest.approx(1.0)
    covered = proposal.labels.copy()
    covered[covered == Label.FACE_SKIN] = Label.HAIR
    assert photo_checks.pose_reliability(replace(proposal, labels=covered)) == photo_checks.LEAST_BELIEF
    half = proposal.labels.copy()
    head = int(np.isin(half, (Label.FACE_SKIN, Label.HAIR, Label.ACCESSORY)).sum())
    skin = np.flatnonzero(half.ravel() == Label.FACE_SKIN)
    half.ravel()[skin[: skin.size - head // 8]] = Label.HAIR  # an eighth of the head is face
    assert photo_checks.pose_reliability(replace(proposal, labels=half)) == pytest.approx(0.125 / 0.2, abs=1e-3)
    pose = proposal.pose_px.copy()
    pose[0] = pose[[7, 8]].mean(axis=0)  # a guessed nose between the ears
    guessed = replace(proposal, pose_px=pose, labels=covered)
    assert profile_odds(guessed) < profile_odds(proposal) - 3.0
    checked(guessed, given, FACE_SIDE)


def test_a_landscape_in_the_side_photo_s_place_is_refused():
    front, mask = portrait((70, 45, 30))
    meadow = np.random.default_rng(0).integers((30, 110, 30), (70, 160, 60), (160, 120, 3)).astype(np.uint8)
    given = studio.photo_set({FACE: front, FACE_SIDE: meadow})
    with pytest.raises(NobodySeen, match="no person found"):
        resolve_hidden(
            given, {FACE: studio.empty_proposal(FACE, mask)}, {FACE_SIDE: nobody_seen(given.photos[FACE_SIDE])}
        )
    alone = studio.photo_set({FRONT: front})
    with pytest.raises(NobodySeen, match="no person found"):
        resolve_hidden(alone, {}, {FRONT: nobody_seen(alone.photos[FRONT])})


def test_the_refusal_survives_the_way_between_processes():
    error = nobody_seen(studio.photo_record(FACE_SIDE, np.zeros((4, 4, 3), np.uint8)))
    again = pickle.loads(pickle.dumps(error))
    assert isinstance(again, NobodySeen)
    assert str(again) == str(error)
    assert "no person found" in str(again)


def test_a_profile_without_a_trusted_nose_is_none(monkeypatch):
    class Net:
        trust = 0.02

        def get(self, name):
            names = ("nose_tip", "chin_front")
            if name == "face_points":
                places = np.array([[10.0, 10.0], [10.0, 20.0]])
                return lambda photo, given: ViewPoints(
                    FACE_SIDE, names, places, np.array([Net.trust, 0.5]), np.zeros(2, bool)
                )
            return lambda view, keys: ViewPoints(view, (), np.zeros((0, 2)), np.zeros(0), np.zeros(0, bool))

    monkeypatch.setattr(points, "DETECTORS", Net())
    rgb, mask = portrait((70, 45, 30))
    given = Photo(FACE_SIDE, rgb, None, "", ""), studio.empty_proposal(FACE_SIDE, mask), Corrections({})
    assert points.face_proposals(*given).names == ()
    Net.trust = 0.3
    assert points.face_proposals(*given).names == ("nose_tip", "chin_front")


def test_a_side_photo_that_is_left_out_later_may_still_show_the_hair():
    """Its head was laid on hair for a profile: the shape is not to be had from it, the hair is."""
    face, _ = seen(FACE)
    side, back = (replace(face, view=view) for view in (FACE_SIDE, BACK))
    found = Proposals({FACE_SIDE: side, BACK: back}).without({FACE_SIDE: "a reason", BACK: "another"})
    assert not found.views
    assert dict(found.covered) == {FACE_SIDE: side}


def test_the_tip_of_a_nose_beside_hair_is_no_profile():
    """Lines on curtains of hair made profiles of half and twice the head's size."""
    proposal, given = seen(FACE_SIDE)
    assert "nose_tip" in points.face_proposals(given, proposal, Corrections({})).names
    skin = np.argwhere(proposal.labels == Label.FACE_SKIN)
    hidden = proposal.labels.copy()
    hidden[tuple(skin[: int(0.97 * len(skin))].T)] = Label.HAIR
    assert points.face_proposals(given, replace(proposal, labels=hidden), Corrections({})).names == ()
