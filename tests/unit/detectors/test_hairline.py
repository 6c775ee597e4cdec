"""The hairline of a drawn face, turned and with gaps."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from cloner.detectors.face.hairline import trace_hairline
from cloner.records.labels import Label

IOD = 80.0


def drawn(tilt_deg: float = 0.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return labels, glabella and up of a face with hair beginning 70 px over the glabella, as an ellipse."""
    labels = np.zeros((480, 400), np.uint8)
    middle = (200, 260)
    cv2.ellipse(labels, middle, (120, 170), 0, 0, 360, int(Label.HAIR), -1)
    cv2.ellipse(labels, middle, (85, 130), 0, 0, 360, int(Label.FACE_SKIN), -1)
    labels[320:] = np.where(labels[320:] > 0, Label.FACE_SKIN, 0)
    turn = cv2.getRotationMatrix2D(middle, -tilt_deg, 1.0)
    labels = cv2.warpAffine(labels, turn, labels.shape[::-1], flags=cv2.INTER_NEAREST)
    glabella = turn @ np.array([200.0, 200.0, 1.0])
    up = turn[:, :2] @ np.array([0.0, -1.0])
    return labels, glabella, up


@pytest.mark.parametrize("tilt", [0.0, 14.0, -9.0])
def test_the_line_lies_where_hair_begins_however_the_head_is_tilted(tilt):
    labels, glabella, up = drawn(tilt)
    line = trace_hairline(labels, glabella, up, IOD)
    assert len(line.points_px) > 25
    assert line.top() == pytest.approx(glabella + 70.0 * up, abs=2.0)


def test_a_lock_on_the_forehead_and_specks_do_not_count_and_bald_is_none():
    labels, glabella, up = drawn()
    labels[170:174, 190:200] = Label.HAIR  # a speck, thinner than any hairline
    assert trace_hairline(labels, glabella, up, IOD).top() == pytest.approx(glabella + 70.0 * up, abs=3.0)
    bald = np.where(labels == Label.HAIR, Label.FACE_SKIN, labels).astype(np.uint8)
    assert trace_hairline(bald, glabella, up, IOD).top() is None
