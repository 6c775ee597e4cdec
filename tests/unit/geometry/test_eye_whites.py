"""Whites of the eyes as light as the photo shows them beside the skin."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from cloner.geometry.charts.iris import EYE_CORNERS, sclera_to_skin, skin_around_eyes
from cloner.records.heads import HeadFit
from cloner.records.labels import Label
from cloner.records.proposals import Proposals
from cloner.stages.textures import observed_eye_colours
from cloner.vision.retouching.painting import paint_eye
from kit import studio

SKIN, WHITE, IRIS = (60, 40, 30), (150, 140, 135), (50, 35, 25)
PUPILS = ((100, 100), (200, 100))


def eyes(white: tuple[int, int, int] = WHITE) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a dark face with two open eyes 60 px wide, its labels and its mesh."""
    rgb = np.full((200, 300, 3), SKIN, np.uint8)
    labels = np.full((200, 300), Label.FACE_SKIN, np.uint8)
    mesh = np.zeros((468, 2))
    for (x, y), corners in zip(PUPILS, EYE_CORNERS, strict=True):
        cv2.ellipse(rgb, (x, y), (30, 12), 0, 0, 360, white, -1)
        cv2.ellipse(labels, (x, y), (30, 12), 0, 0, 360, int(Label.EYES), -1)
        cv2.circle(rgb, (x, y), 12, IRIS, -1)
        mesh[list(corners)] = (x - 30, y), (x + 30, y)
    return rgb, labels, mesh


def test_the_ratio_is_that_of_the_painted_colours() -> None:
    found = sclera_to_skin(*eyes(), np.array(PUPILS, float))
    assert found == pytest.approx(np.array(WHITE) / np.array(SKIN), rel=0.02)


def test_closed_eyes_tell_nothing() -> None:
    rgb, labels, mesh = eyes()
    labels[:] = Label.FACE_SKIN
    assert sclera_to_skin(rgb, labels, mesh, np.array(PUPILS, float)) is None


def test_the_skin_is_that_around_the_eyes_alone() -> None:
    rgb, labels, mesh = eyes()
    rgb[180:] = 255
    assert skin_around_eyes(rgb, labels, mesh, np.array(PUPILS, float)) == pytest.approx(SKIN)
    labels[:] = Label.HAIR
    assert skin_around_eyes(rgb, labels, mesh, np.array(PUPILS, float)) is None


def test_an_iris_is_as_dark_beside_the_skin_of_the_atlas_as_beside_that_of_its_photo() -> None:
    rgb, labels, mesh = eyes()
    bright = np.minimum(rgb.astype(int) * 3 // 2, 255).astype(np.uint8)
    proposal = replace(
        studio.empty_proposal("face_front", labels > 0),
        labels=labels, face_px=mesh, irises_px=np.array(PUPILS, float), face_presence=1.0,
    )  # fmt: skip
    painted = []
    for shown in (rgb, bright):
        head = HeadFit(np.zeros((1, 3)), {}, shown[PUPILS[0][1], PUPILS[0][0]].astype(float), 0.0058, "right")
        photos, proposals = studio.photo_set({"face_front": shown}), Proposals({"face_front": proposal})
        painted.append(observed_eye_colours(photos, proposals, head, np.array(SKIN, float))[1])
    assert painted[0] == pytest.approx(IRIS)
    assert painted[1] == pytest.approx(IRIS, rel=0.05), "twice as much light in the photo makes no lighter eyes"


def test_light_eyes_in_a_dark_face_stay_light() -> None:
    """Beside the iris, level with the gaze, where no lid shades."""
    turn = np.radians(40.0)
    place = np.array([[np.sin(turn), 0.0, np.cos(turn)]], np.float32)
    ratio = np.array(WHITE) / np.array(SKIN)
    rng = np.random.default_rng
    shown, usual = (
        paint_eye(place, np.array(IRIS, float), 0.45, np.array(SKIN, float), told, rng(0))[0] for told in (ratio, None)
    )
    assert np.abs(shown / shown.sum() - np.array(WHITE) / np.sum(WHITE)).max() < 0.05
    assert shown.mean() > 1.2 * usual.mean()
    assert shown.max() < 239.0
