"""States read off label pictures drawn by hand: a face 200 px wide, eyes 90 px apart."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.labels.photo import without_collars, without_specks
from cloner.labels.states import State, read_states, stands_barefoot
from cloner.records.labels import Label

EYES = ((155, 200), (245, 200))


def drawn(**extra: tuple[int, int, int, int, int]) -> np.ndarray:
    """Return a face under hair over a shirt; extras are (label, left, top, right, bottom)."""
    labels = np.zeros((480, 400), np.uint8)
    labels[380:, 80:320] = Label.UPPER_CLOTHES
    cv2.ellipse(labels, (200, 200), (120, 170), 0, 0, 360, int(Label.HAIR), -1)
    cv2.ellipse(labels, (200, 220), (95, 140), 0, 0, 360, int(Label.FACE_SKIN), -1)
    for eye in EYES:
        cv2.ellipse(labels, eye, (14, 6), 0, 0, 360, int(Label.EYES), -1)
    for label, left, top, right, bottom in extra.values():
        labels[top:bottom, left:right][labels[top:bottom, left:right] > 0] = label
    return labels


def mesh() -> np.ndarray:
    points = np.tile([[200.0, 230.0]], (468, 1))
    points[33], points[263] = EYES
    points[105], points[334] = (155.0, 180.0), (245.0, 180.0)
    return points


def states(labels: np.ndarray) -> frozenset[State]:
    return read_states({ViewId.FACE_FRONT: labels}, mesh())


def test_a_plain_face_has_no_state() -> None:
    assert states(drawn()) == frozenset()


@pytest.mark.parametrize(
    ("extra", "state"),
    [
        ((Label.BEARD, 140, 290, 260, 350), State.BEARD),
        ((Label.ACCESSORY, 140, 186, 260, 214), State.GLASSES),
        ((Label.ACCESSORY, 80, 20, 320, 130), State.HEADWEAR),
        ((Label.HAIR, 200, 100, 320, 260), State.FRINGE),
    ],
)
def test_a_state_is_told(extra: tuple[int, int, int, int, int], state: State) -> None:
    assert state in states(drawn(extra=extra))


def test_heavy_brows_are_no_glasses() -> None:
    assert states(drawn(brows=(Label.ACCESSORY, 130, 176, 270, 196))) == frozenset()


def test_an_ear_s_ring_and_a_clip_of_one_side_are_no_glasses() -> None:
    assert states(drawn(one=(Label.ACCESSORY, 205, 182, 262, 226))) == frozenset()


def test_no_hair_is_bald_but_not_under_a_hat() -> None:
    bald = drawn()
    bald[bald == Label.HAIR] = Label.FACE_SKIN
    assert states(bald) == {State.BALD}
    bald[20:130][bald[20:130] > 0] = Label.ACCESSORY
    assert states(bald) == {State.HEADWEAR}


def test_who_wears_a_hood_is_not_bald() -> None:
    hooded = drawn()
    hooded[hooded == Label.HAIR] = Label.UPPER_CLOTHES
    assert states(hooded) == frozenset()


def test_a_scarf_is_no_hat_and_no_glasses() -> None:
    assert states(drawn(scarf=(Label.ACCESSORY, 80, 370, 320, 430))) == frozenset()


@pytest.mark.parametrize(
    ("left", "right", "bare"),
    [
        (Label.BODY_SKIN, Label.BODY_SKIN, True),
        (Label.SHOES, Label.SHOES, False),
        (Label.BODY_SKIN, Label.SHOES, False),
    ],
)
def test_bare_feet(left: Label, right: Label, bare: bool) -> None:
    labels = np.zeros((60, 100), np.uint8)
    labels[40:, 10:40], labels[40:, 60:90] = left, right
    assert stands_barefoot(labels, np.array([[25.0, 44.0], [75.0, 46.0]])) is bare


def test_nothing_at_the_feet_is_not_bare() -> None:
    assert not stands_barefoot(np.zeros((60, 100), np.uint8), np.array([[25.0, 50.0]]))


def test_a_speck_becomes_what_lies_around_it_and_eyes_stay() -> None:
    labels = drawn(speck=(Label.ACCESSORY, 200, 60, 204, 64))
    assert (labels == Label.ACCESSORY).sum() == 16
    cleaned = without_specks(labels, 100.0)
    assert (cleaned[60:64, 200:204] == Label.HAIR).all()
    assert ((cleaned == Label.EYES) == (labels == Label.EYES)).all()
    assert ((cleaned != labels) == (labels == Label.ACCESSORY)).all()


def test_a_dark_collar_is_no_hair_and_a_tail_is() -> None:
    labels = drawn(collar=(Label.HAIR, 120, 390, 280, 410))
    tail = np.zeros(labels.shape, bool)
    tail[200:470, 60:90] = True  # hangs from beside the head, over the shoulder
    labels[tail] = Label.HAIR
    cleaned = without_collars(labels, 360.0)
    assert (cleaned[390:410, 120:280] == Label.UPPER_CLOTHES).all()
    assert (cleaned[tail] == Label.HAIR).all()
