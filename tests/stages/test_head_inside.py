"""The nose of a front photo as evidence: its points err together, and what an operator corrects teaches the rest."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.head.nose import nose_observations
from cloner.records.points import ViewPoints
from cloner.records.proposals import Proposal
from kit.visitors import photo, truth_mask, visitor_folder

NAMES = ("pupil_L", "pupil_R", "ala_L", "ala_R", "subnasale", "nose_tip", "chin_front", "chin_bottom")


@pytest.fixture(scope="module")
def seen():
    """Return photo, proposal, true named points and eye distance of a sample visitor."""
    told = json.loads((visitor_folder("boris") / "truth.json").read_text())["features"]["face_front"]["points"]
    points = np.array([told[n].get("xy_rendered", told[n]["xy"]) for n in NAMES]) - 0.5
    named = ViewPoints(ViewId.FACE_FRONT, NAMES, points, np.full(len(NAMES), 0.7), np.zeros(len(NAMES), dtype=bool))
    picture = photo("boris", "plain", "face_front")
    mask = truth_mask("boris", "plain", "face_front").astype(np.uint8) * 255
    pose, face = np.zeros((33, 2)), np.zeros((468, 2))
    proposal = Proposal(named.view, pose, np.zeros(33), face, np.zeros(468), 1.0, mask, np.ones_like(mask))
    return picture, proposal, named, float(np.linalg.norm(points[0] - points[1]))


def test_both_halves_of_the_nose_are_told(seen):
    picture, proposal, named, iod = seen
    groups = nose_observations(picture, proposal, named)
    assert len(groups) == 2
    for group in groups:
        covariance = np.linalg.inv(group.whiten.T @ group.whiten)
        spread = np.sqrt(np.diag(covariance)) / iod
        assert (spread > 0.008).all()
        assert (spread < 0.12).all()


def test_without_named_points_nothing_is_told(seen):
    picture, proposal, named, _ = seen
    few = ViewPoints(named.view, NAMES[:2], named.points_px[:2], named.confidence[:2], named.corrected[:2])
    assert nose_observations(picture, proposal, few) == ()


def test_a_corrected_wing_takes_its_neighbours_along_and_makes_them_surer(seen):
    picture, proposal, named, iod = seen
    row = NAMES.index("ala_L")
    before = nose_observations(picture, proposal, named)[0]
    moved = np.array(named.points_px)
    moved[row] = before.points_px[0] + [0.03 * iod, 0.0]
    corrected = np.arange(len(NAMES)) == row
    after = nose_observations(picture, proposal, replace(named, points_px=moved, corrected=corrected))[0]
    assert after.points_px[0] == pytest.approx(moved[row], abs=0.005 * iod)
    wing = after.points_px[3:6, 0] - before.points_px[3:6, 0]
    assert (wing > 0.005 * iod).all()
    volume = [np.linalg.slogdet(group.whiten)[1] for group in (before, after)]
    assert volume[1] > volume[0] + 1.0
