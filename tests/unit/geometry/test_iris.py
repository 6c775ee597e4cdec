"""Irises are sampled where they are seen."""

from __future__ import annotations

import cv2
import numpy as np

from cloner.geometry.charts.iris import sample_iris
from cloner.records.labels import Label

CENTRES, RADIUS = np.array([[60.0, 50.0], [140.0, 50.0]]), 12.0
BROWN, FAIR, SKIN = (90, 60, 40), (190, 180, 150), (200, 150, 130)


def eyes() -> tuple[np.ndarray, np.ndarray]:
    """Return a picture of two brown irises, the right one behind fair hair, and its labels."""
    rgb, labels = np.full((100, 200, 3), 220, np.uint8), np.full((100, 200), Label.FACE_SKIN, np.uint8)
    for x, y in CENTRES.astype(int).tolist():
        cv2.circle(rgb, (x, y), 12, BROWN, -1)
        cv2.circle(rgb, (x, y), 5, (10, 10, 10), -1)
        cv2.circle(labels, (x, y), 12, int(Label.EYES), -1)
    rgb[:, 110:], labels[:, 110:] = FAIR, Label.HAIR
    return rgb, labels


def test_an_iris_behind_hair_gives_no_colour() -> None:
    rgb, labels = eyes()
    np.testing.assert_allclose(sample_iris(rgb, labels, CENTRES, RADIUS), BROWN, atol=1.0)


def test_lids_are_no_iris() -> None:
    """Below lids that are nearly shut, most of a ring is skin; of photos without labels of eyes it counts."""
    rgb, labels = eyes()
    rgb[52:], labels[52:] = SKIN, Label.FACE_SKIN
    rgb[50:52, :110] = BROWN
    wide = np.array([[60.0, 48.0]])
    np.testing.assert_allclose(sample_iris(rgb, labels, wide, RADIUS), BROWN, atol=1.0)
    unlabelled = np.full_like(labels, Label.FACE_SKIN)
    assert np.abs(np.array(sample_iris(rgb, unlabelled, wide, RADIUS)) - BROWN).max() > 30.0


def test_dark_lenses_show_no_iris() -> None:
    rgb, labels = eyes()
    assert sample_iris(rgb, np.full_like(labels, Label.ACCESSORY), CENTRES, RADIUS) is None


def test_small_irises_and_those_off_the_photo_give_no_colour() -> None:
    rgb, labels = eyes()
    assert sample_iris(rgb, labels, CENTRES, 2.0) is None
    assert sample_iris(rgb, labels, CENTRES + 500.0, RADIUS) is None
