"""Classes of a label image."""

from __future__ import annotations

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray


class Label(IntEnum):
    """Classes of a label picture, (H, W) uint8."""

    BACKGROUND = 0
    BODY_SKIN = 1
    """Below the jaw: neck, arms, hands, legs, bare feet."""
    FACE_SKIN = 2
    """Above the jaw, with ears, bald scalp, lips, brows, lashes and thin stubble."""
    HAIR = 3
    UPPER_CLOTHES = 4
    """Tops, jackets, collars, hoods, whole coats, the bodice of a dress."""
    LOWER_CLOTHES = 5
    SHOES = 6
    EYES = 7
    MOUTH = 8
    """Teeth, tongue, the inside of the mouth."""
    ACCESSORY = 9
    """Glasses, caps, scarves, headbands."""
    BEARD = 10


#: Their names, each at its own place.
LABELS = tuple(label.name.lower() for label in Label)
SKINS = (Label.BODY_SKIN, Label.FACE_SKIN)
#: What lies inside a face's outline.
FACE = (Label.FACE_SKIN, Label.EYES, Label.MOUTH, Label.BEARD)
#: The person's own, nothing worn.
OWN = (*SKINS, Label.HAIR, Label.EYES, Label.MOUTH, Label.BEARD)
GARMENTS = (Label.UPPER_CLOTHES, Label.LOWER_CLOTHES, Label.SHOES)
CLOTHES = (*GARMENTS, Label.ACCESSORY)


#: What a surface can be made of, as far as texture and regions tell it apart.
SURFACES = ("skin", "hair", "upper_clothes", "lower_clothes", "shoes", "accessory")
#: Place in ``SURFACES`` of each label; -1 tells nothing of the surface.
SURFACE_OF = np.array([-1, 0, 0, 1, 2, 3, 4, 0, 0, 5, 0], np.int8)


def labels_at(labels: NDArray[np.uint8], places_px: NDArray[np.floating]) -> NDArray[np.uint8]:
    """Return the (N,) labels of the pixels nearest to places (N, 2), right and down; background off the picture."""
    column, row = np.rint(places_px).astype(np.int64).T
    inside = (column >= 0) & (row >= 0) & (column < labels.shape[1]) & (row < labels.shape[0])
    found = np.full(len(places_px), Label.BACKGROUND, np.uint8)
    found[inside] = labels[row[inside], column[inside]]
    return found


def shows(labels: NDArray[np.uint8], *classes: Label) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of a label image with one of some classes."""
    found = np.zeros(labels.shape, np.bool_)
    for one in classes:  # bytes are compared thirty at a time, a table is read one by one
        found |= labels == one
    return found
