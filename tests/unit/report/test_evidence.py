"""What the finished clone says of its photos is acted upon and told; every warning has an input that provokes it."""

from dataclasses import replace

import numpy as np
import pytest

from cloner import making
from cloner.evaluate.truths.baselines import generic_clone
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.pipeline import StageReport
from cloner.records.bodies import PosedView
from cloner.records.proposals import Proposals
from cloner.report.agreement import PhotoAgreement, compare
from cloner.report.evidence import contradicting_photos, is_better
from cloner.report.standing import azimuth_degrees, pose_warnings
from cloner.report.weak import photo_weaknesses
from kit import studio

FRONT, SIDE, BACK, FACE, FACE_SIDE = ViewId
GOOD = PhotoAgreement(0.97, 2.0, 3.0, 1.01)
RED = np.full((40, 30, 3), (200, 30, 30), np.uint8)


def disc(radius, size=200):
    y, x = np.mgrid[:size, :size] - size / 2
    return x * x + y * y < radius * radius


def test_a_clone_of_half_the_size_is_told_by_its_size():
    found = compare(disc(40), disc(80), 1.0)
    assert found.size == pytest.approx(0.5, abs=0.01)
    assert found.iou == pytest.approx(0.25, abs=0.01)


@pytest.mark.parametrize("view", [FACE_SIDE, SIDE, BACK])
def test_a_photo_that_the_clone_contradicts_is_left_out(view):
    seen = {FRONT: GOOD, FACE: GOOD, view: replace(GOOD, iou=0.31)}
    told = contradicting_photos(seen)
    assert list(told) == [view]
    assert "cover only 31 percent of the person" in told[view]
    assert list(contradicting_photos({**seen, view: replace(GOOD, size=0.7)})) == [view], "far too small"
    assert list(contradicting_photos({**seen, view: replace(GOOD, iou=0.68)})) == [view], "a mouth taken for a nose"
    assert contradicting_photos({**seen, view: replace(GOOD, iou=0.80)}) == {}, "drawn roughly"
    assert contradicting_photos({**seen, view: GOOD}) == {}


def test_front_photos_stay_and_nothing_is_held_against_nothing():
    assert contradicting_photos({FRONT: GOOD, FACE: replace(GOOD, iou=0.3)}) == {}
    assert contradicting_photos({FRONT: replace(GOOD, iou=0.4), SIDE: replace(GOOD, iou=0.3)}) == {}
    assert contradicting_photos({SIDE: replace(GOOD, iou=0.3), BACK: GOOD}) == {}


def test_a_clone_without_a_photo_must_cover_the_front_as_well():
    before = {FRONT: GOOD, FACE: GOOD, SIDE: replace(GOOD, iou=0.3)}
    assert is_better(before, {FRONT: GOOD, FACE: replace(GOOD, iou=0.95)})
    assert not is_better(before, {FRONT: GOOD, FACE: replace(GOOD, iou=0.8)})
    assert not is_better(before, {FRONT: GOOD})


class Stages:
    """A pipeline that covers the side photo badly as long as it takes it."""

    def __init__(self, front_without=0.97):
        self.runs, self.front_without = [], front_without

    def run(self, values, **known):
        proposals = values.get("proposals") or Proposals(
            {v: studio.empty_proposal(v, disc(9, 30)) for v in (FRONT, SIDE)}
        )
        self.runs.append(set(proposals.views))
        names = ("proposals", "points") if "proposals" not in values else ("points",)
        reports = [StageReport(name, 1.0, 1.0, 1.0, (), (f"of run {len(self.runs)}",)) for name in names]
        return {**values, "proposals": proposals, "clone": proposals, "obeyed_silhouettes": None}, reports

    def agreements(self, clone, silhouettes):
        front = GOOD if SIDE in clone.views else replace(GOOD, iou=self.front_without)
        return {FRONT: front, **({SIDE: replace(GOOD, iou=0.31)} if SIDE in clone.views else {})}


@pytest.mark.parametrize(("front_without", "kept"), [(0.96, {FRONT}), (0.8, {FRONT, SIDE})])
def test_the_clone_is_made_again_without_a_contradicted_photo(monkeypatch, front_without, kept):
    stages = Stages(front_without)
    monkeypatch.setattr(making.pipeline, "run", stages.run)
    monkeypatch.setattr(making, "agreements", stages.agreements)
    given = {"photos": 1, "person": 2, "corrections": 3}
    values, reports = making._run_without_contradicting_photos(given, 0, lambda s, f: None, lambda n, v: None, ())
    assert stages.runs == [{FRONT, SIDE}, {FRONT}]
    assert set(values["proposals"].views) == kept
    assert set(values["proposals"].left_out) == {FRONT, SIDE} - kept
    assert [report.name for report in reports] == ["proposals", "points"]


def test_what_is_left_out_and_what_fits_badly_is_told():
    photos = studio.photo_set({FRONT: RED, FACE: RED, FACE_SIDE: RED})
    known = Proposals({v: studio.empty_proposal(v, disc(9, 30)) for v in (FRONT, FACE)}, {FACE_SIDE: "why it was"})
    assert photo_weaknesses(photos, known, {FRONT: GOOD, FACE: GOOD}) == ("face_side: why it was",)
    told = photo_weaknesses(photos, known, {FRONT: replace(GOOD, iou=0.85), FACE: replace(GOOD, iou=0.75)})
    assert "body_front: the clone covers the person's outline only to 85 percent" in told
    assert "face_front: the clone covers the head's outline only to 75 percent" in told


def posed(view, azimuth):
    return PosedView(view, studio.camera(azimuth), np.zeros((len(load_generic().joint_names), 3)))


@pytest.mark.parametrize(("view", "straight"), [(FACE, 0.0), (FACE_SIDE, -90.0), (FACE_SIDE, 90.0)])
def test_a_turned_head_is_told_and_a_straight_one_is_not(view, straight):
    clone = generic_clone(load_generic(), 1.7)
    assert azimuth_degrees(posed(view, straight)) == pytest.approx(straight)
    assert pose_warnings(replace(clone, views={view: posed(view, straight + 15.0)}), Proposals({})) == ()
    (told,) = pose_warnings(replace(clone, views={view: posed(view, straight + 32.0)}), Proposals({}))
    assert told.startswith(f"{view}: the head is turned by about 32 degrees")


@pytest.mark.parametrize(("moved_m", "visible", "count"), [(0.0, 1.0, 0), (0.12, 1.0, 1), (0.12, 0.1, 0)])
def test_an_arm_beside_the_photo_s_arm_is_told(moved_m, visible, count):
    generic = load_generic()
    clone = generic_clone(generic, 1.7)
    side = posed(SIDE, -90.0)
    pose, seen = np.zeros((33, 2)), np.zeros(33)
    for row, joint in ((14, "r_elbow"), (16, "r_wrist")):
        place = clone.joints_m[generic.joint(joint)] + [0.0, 0.0, moved_m]
        pose[row], seen[row] = side.camera.project(place[None])[0], visible
    proposal = replace(studio.empty_proposal(SIDE, disc(9, 30)), pose_px=pose, pose_visibility=seen)
    told = pose_warnings(replace(clone, views={SIDE: side}), Proposals({SIDE: proposal}))
    assert len(told) == count
    if count:
        assert told[0].startswith("body_side: the right arm of the clone lies 12 cm beside the arm in this photo")
