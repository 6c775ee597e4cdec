"""Colour of the bare skin in a photo."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.labels import SKINS, shows
from cloner.vision.retouching.skin_colour import SkinColour, skin_colour

#: Pixels of a label that tell its colour; more only cost time.
SAMPLES: Final = 4000
#: Spread of log ratios beyond which a label covers several things.
WIDEST: Final = 0.2


def label_colour(rgb: NDArray[np.uint8], mask: NDArray[np.bool_], labels: NDArray[np.uint8]) -> SkinColour | None:
    """Return the colour of one photo's labelled skin, None where it is too small or too varied.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool, the person
    labels : (H, W) uint8, values of ``Label``
    """
    known = rgb[shows(labels, *SKINS) & mask]
    colour = skin_colour(known[:: max(len(known) // SAMPLES, 1)])
    return colour if colour is not None and max(colour.spread) < WIDEST else None
