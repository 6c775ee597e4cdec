"""Skin of a colour that the person's cannot have is clothes."""

import numpy as np
import pytest

from cloner.generic.seen_points import NAMES
from cloner.labels.own_skin import relabel_foreign_skin
from cloner.records.labels import Label

HEIGHT, WIDTH = 300, 120
SKIN, SHADE, TIGHTS, COAT, WALL = (210, 165, 140), (150, 118, 100), (25, 22, 26), (200, 180, 140), (120, 120, 120)


def _figure(legs: tuple[int, int, int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a photo of a face, a coat with hands beside it, legs of a colour and shoes, its labels, and points."""
    rgb, labels = np.empty((HEIGHT, WIDTH, 3), np.uint8), np.zeros((HEIGHT, WIDTH), np.uint8)
    rgb[:] = WALL
    for rows, columns, colour, label in (
        ((10, 45), (45, 75), SKIN, Label.FACE_SKIN),
        ((45, 170), (35, 85), COAT, Label.UPPER_CLOTHES),
        ((150, 170), (15, 35), SKIN, Label.BODY_SKIN),
        ((150, 170), (85, 105), SKIN, Label.BODY_SKIN),
        ((170, 210), (40, 80), legs, Label.BODY_SKIN),
        ((210, 270), (40, 80), TIGHTS, Label.LOWER_CLOTHES),
        ((270, 290), (35, 85), (90, 40, 40), Label.SHOES),
    ):
        rgb[slice(*rows), slice(*columns)], labels[slice(*rows), slice(*columns)] = colour, label
    seen = np.zeros((len(NAMES), 2))
    seen[NAMES.index("l_wrist")], seen[NAMES.index("r_wrist")] = (95.0, 155.0), (25.0, 155.0)
    return rgb, labels, seen


@pytest.mark.parametrize("faced", [True, False])
def test_dark_tights_labelled_as_skin_are_the_lower_clothes(faced):
    rgb, labels, seen = _figure(TIGHTS)
    found = relabel_foreign_skin(rgb, labels, seen, faced=faced)
    assert (found[170:210, 40:80] == Label.LOWER_CLOTHES).all()
    rest = np.ones(labels.shape, bool)
    rest[170:210, 40:80] = False
    assert np.array_equal(found[rest], labels[rest])


@pytest.mark.parametrize("legs", [SKIN, SHADE])
def test_bare_legs_stay_bare_in_shade_too(legs):
    rgb, labels, seen = _figure(legs)
    assert np.array_equal(relabel_foreign_skin(rgb, labels, seen, faced=True), labels)


def test_without_hands_and_face_nothing_is_known():
    rgb, labels, seen = _figure(TIGHTS)
    labels[150:170, 15:35] = labels[150:170, 85:105] = Label.UPPER_CLOTHES  # gloves
    assert np.array_equal(relabel_foreign_skin(rgb, labels, seen, faced=False), labels)
    nobody = np.zeros_like(labels)
    assert np.array_equal(relabel_foreign_skin(rgb, nobody, seen, faced=True), nobody)
