"""Labels of skin checked against the skin's own colour: a collar is none."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.skin_colour import FARTHEST, SkinColour, chroma, skin_colour, skin_distance

SKIN_LABEL: Final = 1
#: Pixels of a label that tell its colour; more only cost time.
SAMPLES: Final = 4000
#: Spread of log ratios beyond which a label covers several things.
WIDEST: Final = 0.2
#: Distance in spreads from which a pixel labelled skin is none: lips, shine and shade stay below.
NOT_SKIN: Final = 7.0
#: Pixels are checked at this share of the photo's size.
SCALE: Final = 0.5
#: Holes and specks up to this many checked pixels are brows, stitches and noise.
SPECK_PX: Final = 5


def label_colour(rgb: NDArray[np.uint8], mask: NDArray[np.bool_], labels: NDArray[np.uint8]) -> SkinColour | None:
    """Return the colour of the labelled skin of one photo, None where it is too little or of too many colours.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool, the person
    labels : (H, W) uint8, 1 = skin
    """
    known = rgb[(labels == SKIN_LABEL) & mask]
    colour = skin_colour(known[:: max(len(known) // SAMPLES, 1)])
    return colour if colour is not None and max(colour.spread) < WIDEST else None


def shown_bare(
    rgb: NDArray[np.uint8],
    mask: NDArray[np.bool_],
    hair: NDArray[np.bool_],
    bare: NDArray[np.bool_],
    colour: SkinColour | None,
) -> NDArray[np.uint8]:
    """Return (H, W) uint8, 255 where the person shows skin or hair and nothing worn.

    Labels are sure on the face, where lips and brows are skin too, but stop
    somewhere below it and take bits of collars; there colour tells.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool, the person
    hair, bare : (H, W) bool
        Labels.
    colour : SkinColour or None
        This person's; None believes the labels.
    """
    if colour is None:
        return (bare | hair).astype(np.uint8) * 255
    size = (round(mask.shape[1] * SCALE), round(mask.shape[0] * SCALE))
    small = cv2.resize(rgb, size, interpolation=cv2.INTER_AREA)
    person, named = (
        cv2.resize(flags.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0 for flags in (mask, bare)
    )
    like = np.zeros(person.shape, np.uint8)
    like[person] = np.where(skin_distance(small[person], colour) < FARTHEST, 255, 0)
    ratios, _ = chroma(small[named])
    like[named] = np.where(np.linalg.norm((ratios - colour.middle) / colour.spread, axis=1) < NOT_SKIN, 255, 0)
    shown = cv2.resize(cv2.medianBlur(like, SPECK_PX), mask.shape[::-1], interpolation=cv2.INTER_LINEAR)
    shown[hair] = 255
    return np.asarray(cv2.blur(shown, (3, 3)), np.uint8)
