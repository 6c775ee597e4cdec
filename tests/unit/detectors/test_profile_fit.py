"""Profiles of painted silhouettes: either way round, tilted, with glasses, fringes and gnawed masks."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.face_side import find_side_face, missing_edge_share
from cloner.detectors.face.profile_judge import face_share, features, load_judge
from cloner.detectors.nets.results import POSE_NAMES
from cloner.frames import ViewId
from cloner.records.labels import Label
from cloner.records.points import expected_face_error, face_confidence
from cloner.records.proposals import Proposal

SIZE = (700, 560)  # height, width
IOD_M = 0.063
MIDLINE = ("glabella", "nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front",
           "chin_bottom")  # fmt: skip


class Sitter:
    """A head in profile drawn from the shape model itself, with the truth of its named points."""

    def __init__(self, seed: int, *, facing: int = 1, tilt_deg: float = 0.0, px_per_m: float = 1900.0) -> None:
        self.model = load_face_net().profile
        rng = np.random.default_rng(seed)
        shape = self.model.shape(0.8 * rng.normal(size=len(self.model.modes)))
        turn = np.radians(tilt_deg)
        linear = px_per_m * np.array([[facing * np.cos(turn), -facing * np.sin(turn)], [-np.sin(turn), -np.cos(turn)]])
        self.facing, self.scale = facing, px_per_m
        place = shape @ linear.T
        self.shift = np.array([SIZE[1] / 2 + facing * 90, 0.5 * SIZE[0]]) - place[: self.model.samples].mean(axis=0)
        place += self.shift
        self.curve, self.named = place[: self.model.samples], place[self.model.samples :]
        self.mask = np.zeros(SIZE, np.uint8)
        back = self.curve[0] + np.array([-facing * 0.16, -0.03]) * px_per_m
        skull = self.curve[0] + np.array([-facing * 0.075, 0.005]) * px_per_m
        nape = self.curve[-1] + np.array([-facing * 0.085, 0.02]) * px_per_m
        neck = np.array([self.curve[-1] + [0, 0.2 * px_per_m], nape + [0, 0.2 * px_per_m]])
        self._fill(np.vstack([self.curve, neck[:1], neck[1:], nape, back]))
        cv2.circle(self.mask, np.round(skull).astype(int).tolist(), round(0.082 * px_per_m), 255, -1)

    def _fill(self, polygon: np.ndarray) -> None:
        cv2.fillPoly(self.mask, [np.round(polygon * 16).astype(np.int32)], 255, cv2.LINE_AA, 4)

    def at(self, name: str) -> np.ndarray:
        return self.named[self.model.names.index(name)]

    def proposal(self, *, hint_px: float = 12.0, seed: int = 0) -> Proposal:
        rng = np.random.default_rng(seed)
        row = {name: k for k, name in enumerate(POSE_NAMES)}
        pose = np.zeros((33, 2))
        inwards = np.array([-self.facing * 0.018, 0.0]) * self.scale  # pose nets put points on the near side's wall
        for names, mark in (
            (("nose",), "nose_tip"), (("eye_l", "eye_r"), "pupil"), (("mouth_l", "mouth_r"), "mouth_corner"),
            (("ear_l", "ear_r"), "ear_outer"),
        ):  # fmt: skip
            for name in names:
                pose[row[name]] = self.at(mark) + inwards + rng.normal(0, hint_px, 2)
        empty = np.zeros(SIZE, np.uint8)
        return Proposal(ViewId.FACE_SIDE, pose, np.ones(33), np.zeros((468, 2)), np.zeros(468), 0.0, self.mask, empty)

    def errors(self, found) -> dict[str, float]:
        """Return distances of the midline's points in shares of the eye distance."""
        rows = {name: found.names.index(name) for name in MIDLINE}
        return {
            n: float(np.linalg.norm(found.points_px[r] - self.at(n))) / (IOD_M * self.scale) for n, r in rows.items()
        }


@pytest.mark.parametrize(("seed", "facing", "tilt"), [(1, 1, 0.0), (2, -1, 8.0), (3, 1, -12.0), (4, -1, 0.0)])
def test_profiles_are_found_either_way_round(seed, facing, tilt):
    sitter = Sitter(seed, facing=facing, tilt_deg=tilt)
    found = find_side_face(sitter.proposal(), sitter.model)
    errors = sitter.errors(found)
    assert found.facing == facing
    below = [errors[n] for n in MIDLINE[2:]]  # the brow's flat line tells heights badly
    assert np.mean(below) < 0.03, errors
    assert max(below) < 0.08, errors
    assert max(errors.values()) < 0.16, errors
    assert found.fitted.cost < 0.2
    side = "R" if facing > 0 else "L"
    assert f"ear_top_{side}" in found.names


def test_a_wrong_hint_of_the_direction_is_overruled_by_the_outline():
    sitter = Sitter(5, facing=1)
    proposal = sitter.proposal()
    pose = np.array(proposal.pose_px)
    pose[:, 0] = SIZE[1] - pose[:, 0]  # as if the pose net saw the back of the head as the face
    turned = Proposal(
        ViewId.FACE_SIDE, pose, np.ones(33), np.zeros((468, 2)), np.zeros(468), 0.0, sitter.mask, proposal.labels
    )
    found = find_side_face(turned, sitter.model)
    assert found.facing == 1
    assert np.mean(list(sitter.errors(found).values())) < 0.05


def test_glasses_and_a_fringe_are_not_taken_for_the_face():
    sitter = Sitter(6, facing=1)
    k = sitter.scale
    lens = sitter.at("nasion") + np.array([0.004, 0.006]) * k
    cv2.ellipse(
        sitter.mask, np.round(lens).astype(int).tolist(), (round(0.005 * k), round(0.019 * k)), 0, 0, 360, 255, -1
    )
    cv2.circle(sitter.mask, np.round(sitter.curve[2]).astype(int).tolist(), round(0.014 * k), 255, -1)
    errors = sitter.errors(find_side_face(sitter.proposal(), sitter.model))
    lower = [errors[n] for n in ("nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front")]
    assert np.mean(lower) < 0.04, errors
    assert max(lower) < 0.10, errors


def test_a_piece_of_background_before_the_lips_does_not_bend_the_face_to_it():
    sitter = Sitter(7, facing=-1)
    low, high = sitter.at("subnasale"), sitter.at("stomion")
    front = sitter.at("nose_tip")[0]
    cv2.rectangle(sitter.mask, (round(front) + 6, round(low[1])), (round(low[0]) + 20, round(high[1])), 255, -1)
    errors = sitter.errors(find_side_face(sitter.proposal(), sitter.model))
    assert np.mean(list(errors.values())) < 0.05, errors


def test_what_is_no_face_gets_no_confidence():
    sitter = Sitter(8)
    square = np.zeros(SIZE, np.uint8)
    square[100:650, 120:420] = 255
    proposal = sitter.proposal()
    box = Proposal(
        ViewId.FACE_SIDE,
        np.array(proposal.pose_px),
        np.ones(33),
        np.zeros((468, 2)),
        np.zeros(468),
        0.0,
        square,
        np.where(square > 0, Label.UPPER_CLOTHES, Label.BACKGROUND).astype(np.uint8),
    )
    found = find_side_face(box, sitter.model)
    assert found is None or face_confidence(found.error_iod).max() < 0.4


def test_nobody_is_no_profile():
    sitter = Sitter(9)
    empty = np.zeros(SIZE, np.uint8)
    nobody = Proposal(
        ViewId.FACE_SIDE, np.zeros((33, 2)), np.zeros(33), np.zeros((468, 2)), np.zeros(468), 0.0, empty, empty
    )
    assert find_side_face(nobody, sitter.model) is None


def test_confidence_tells_the_expected_error():
    error = np.array([0.0, 0.02, 0.1, 0.5])
    assert expected_face_error(face_confidence(error)) == pytest.approx(error)
    assert np.all(np.diff(face_confidence(error)) < 0)


def test_a_profile_without_an_edge_in_the_photo_is_doubted():
    sitter = Sitter(10)
    found = find_side_face(sitter.proposal(), sitter.model)
    shown = np.where(sitter.mask[..., None] > 127, 170, 90).astype(np.uint8).repeat(3, axis=2)
    assert missing_edge_share(shown, sitter.model, found.fitted) == 0.0
    blurred = cv2.GaussianBlur(shown, (0, 0), 25.0)  # what a mask that follows a soft shadow sees
    assert missing_edge_share(blurred, sitter.model, found.fitted) > 0.9


def test_without_hints_the_profile_is_sought_everywhere():
    sitter = Sitter(11, facing=-1)
    proposal = sitter.proposal()
    blind = Proposal(
        ViewId.FACE_SIDE, np.zeros((33, 2)), np.zeros(33), np.zeros((468, 2)), np.zeros(468), 0.0, sitter.mask,
        proposal.labels,
    )  # fmt: skip
    found = find_side_face(blind, sitter.model)
    assert found.facing == -1
    assert np.mean([sitter.errors(found)[n] for n in MIDLINE[2:]]) < 0.04


def test_a_fall_of_hair_with_a_profiles_outline_is_none():
    sitter = Sitter(12)
    shown = {}
    for label in (Label.FACE_SKIN, Label.HAIR):
        labels = np.where(sitter.mask > 127, label, Label.BACKGROUND).astype(np.uint8)
        shown[label] = find_side_face(replace(sitter.proposal(), labels=labels), sitter.model)
    assert shown[Label.FACE_SKIN].error_iod.min() < 0.1
    assert shown[Label.HAIR].error_iod.min() > 0.4


def test_labels_tell_a_face_from_what_has_its_outline():
    """The same profile laid two centimetres too high has a chin where the labels still show face."""
    sitter = Sitter(13)
    found = find_side_face(sitter.proposal(), sitter.model)
    rows = np.arange(SIZE[0])[:, None]
    labels = np.where(rows < sitter.at("glabella")[1], Label.HAIR, Label.FACE_SKIN)
    labels = np.where(rows > sitter.at("chin_bottom")[1], Label.BODY_SKIN, labels)
    labels = np.where(sitter.mask > 127, labels, Label.BACKGROUND).astype(np.uint8)
    higher = found.fitted.px_from_m - np.array([[0, 0, 0], [0, 0, 0.02 * found.fitted.size]])
    right, wrong = (
        load_judge().error_mm(features(sitter.model, replace(found.fitted, px_from_m=one), found.facing, labels, None))
        for one in (found.fitted.px_from_m, higher)
    )
    assert wrong > 1.5 * right
    assert face_share(sitter.model, found.fitted, labels) > 0.6


def test_what_is_worn_before_a_face_does_not_become_its_profile():
    """Worn things with the outline of a face, three centimetres before it; labels tell that they are worn."""
    sitter = Sitter(12)
    shift = np.float32([[1, 0, sitter.facing * 0.03 * sitter.scale], [0, 1, 0]])
    worn = (cv2.warpAffine(sitter.mask, shift, SIZE[::-1]) > 127) & (sitter.mask <= 127)
    labels = np.where(sitter.mask > 127, Label.FACE_SKIN, Label.BACKGROUND).astype(np.uint8)
    labels[worn] = Label.ACCESSORY
    mask = np.where(worn, 255, sitter.mask).astype(np.uint8)
    errors = sitter.errors(find_side_face(replace(sitter.proposal(), mask=mask, labels=labels), sitter.model))
    assert max(errors[name] for name in ("nasion", "nose_tip", "chin_front")) < 0.1
