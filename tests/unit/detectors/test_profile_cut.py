"""A wall of skin's colour before a side face leaves the mask; hair before a forehead stays in it."""

from __future__ import annotations

import cv2
import numpy as np

from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.profile_cut import wall_before_profile
from cloner.detectors.face.profile_fit import FittedProfile
from cloner.frames import ViewId
from cloner.project.folder import load_photo
from cloner.stages.proposals import propose
from kit.visitors import truth_mask, visitor_folder

SIZE = 4000.0  # px per metre
SKIN, WALL, HAIR = (196, 150, 126), (208, 166, 120), (60, 42, 34)


def scene(before):
    """Return mask, strip and the wall found before a mean face looking right, with a strip painted before its nose."""
    model = load_face_net().profile
    px_from_m = np.array([[SIZE, 0.0, 400.0], [0.0, -SIZE, 400.0]])
    curve = model.mean[: model.samples] @ px_from_m[:, :2].T + px_from_m[:, 2]
    behind = np.column_stack([np.full(2, 20.0), [curve[-1, 1], curve[0, 1]]])
    face = np.zeros((900, 700), np.uint8)
    cv2.fillPoly(face, [np.rint(np.vstack([curve, behind])).astype(np.int32)], 1)
    rgb = np.where(face[..., None] > 0, SKIN, WALL).astype(np.uint8)
    tip = curve[int(np.argmax(curve[:, 0]))]
    strip = np.zeros_like(face)
    cv2.rectangle(strip, (20, int(tip[1]) - 120), (int(tip[0]) - 8, int(tip[1]) - 20), 1, -1)
    strip &= 1 - face
    rgb[strip > 0] = before
    rgb = np.clip(rgb + np.random.default_rng(0).normal(0.0, 2.0, rgb.shape), 0, 255).astype(np.uint8)
    fitted = FittedProfile(px_from_m, np.zeros(len(model.modes)), 0.1, np.eye(4 + len(model.modes)))
    return 255 * (face | strip), strip > 0, wall_before_profile(rgb, 255 * (face | strip), model, fitted)


def test_wall_is_cut_and_hair_stays():
    mask, strip, wall = scene(WALL)
    assert wall[strip].mean() > 0.8
    assert (wall & (mask > 0) & ~strip).sum() < 0.05 * strip.sum()
    *_, kept = scene(HAIR)
    assert not kept.any()


def test_no_wall_between_nose_and_lip():
    shot = load_photo(visitor_folder("anna", "handheld") / "face_side.jpg", ViewId.FACE_SIDE)
    front = (slice(900, 1300), slice(1050, None))
    true = truth_mask("anna", "handheld", "face_side")[front]
    found = propose(shot).mask[front] > 127
    assert (found & ~true).sum() < 0.012 * true.sum()
    assert (true & ~found).sum() < 0.012 * true.sum()
