"""What is worn on the head has a volume like hair; glasses and scarves have none."""

from __future__ import annotations

import numpy as np

from cloner.hair.volumes.headwear import headwear
from cloner.records.labels import Label


def head(*, face: bool) -> np.ndarray:
    """Return a head from row 20 (a cap), face or hair from 40 to 100, glasses at 60, a scarf at 110."""
    labels = np.zeros((140, 100), np.uint8)
    labels[20:40, 30:70] = Label.ACCESSORY
    labels[40:100, 30:70] = Label.FACE_SKIN if face else Label.HAIR
    labels[58:62, 35:65] = Label.ACCESSORY if face else Label.HAIR
    labels[105:120, 30:70] = Label.ACCESSORY
    return labels


def test_a_cap_is_worn_on_the_head_glasses_and_a_scarf_are_not() -> None:
    for face in (True, False):
        rows = np.flatnonzero(headwear(head(face=face)).any(axis=1))
        assert (rows[0], rows[-1]) == (20, 39), face


def test_without_head_or_cap_nothing_is_worn() -> None:
    assert not headwear(np.zeros((40, 40), np.uint8)).any()
    assert not headwear(np.full((40, 40), Label.ACCESSORY, np.uint8)).any(), "a bag alone"
