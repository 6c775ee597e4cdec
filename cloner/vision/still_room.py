"""What other photos of a camera that stood still show of the room behind the person.

In a booth the camera stands on a tripod and the person turns: one photo shows the wall that another one hides.
A pixel that looks the same in a photo where nobody stands there is the room's, whatever its colour.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.float32]
Bools = NDArray[np.bool_]
Picture = NDArray[np.uint8]

#: Longer side at which photos are compared, px: half a megapixel, where a pixel's noise is averaged away.
WORK_SIDE_PX: Final = 900
#: This far from both masks pixels surely show the room, and from the other's mask probably, share of the longer side.
SURELY: Final = 0.03
PROBABLY: Final = 0.01
#: Two photos show the same room from the same place if so many of its pixels, as a share, differ by less than that,
#: grey levels.  The samples on a tripod: .99 and more; hand-held before the same walls: .2 to .6.
SAME_SHARE: Final = 0.9
SAME_LEVELS: Final = 12.0
#: Grey levels over which a person's colours differ from the room's, a judgement, and least noise of a comparison.
PERSON_LEVELS: Final = 40.0
LEAST_NOISE: Final = 1.5
#: The largest of three channels' differences is spread so many times its median (half-normal distributions).
SPREAD: Final = 1.0
#: Pixels of a neighbourhood that decide together, and how many of them count as independent: a white shirt before a
#: white wall has folds somewhere, so a neighbourhood that differs by no more than noise shows the wall.
NEIGHBOURS: Final = 5
INDEPENDENT: Final = 3.0
#: Log odds a comparison may claim: the room's, and the person's, whose shadow changes the room as well.
MOST_ROOM: Final = 7.0
MOST_PERSON: Final = 1.0


def still_room(rgb: Picture, mask: Image, others: Sequence[tuple[Picture, Image]]) -> Image | None:
    """Return log odds (H, W) of the person against the room by comparison with other photos; None where none compares.

    Parameters
    ----------
    rgb : ndarray, shape (H, W, 3), uint8
    mask : ndarray, shape (H, W), float32
        Person probability 0..1.
    others : sequence of (rgb, mask)
        Further photos of the visit.

    Returns
    -------
    ndarray or None
        Negative where another photo shows the same colour and nobody; 0 where all others show the person.
    """
    shape = rgb.shape[:2]
    own, own_mask = _small(rgb, mask)
    found: Image | None = None
    for other_rgb, other_mask in others:
        if other_rgb.shape != rgb.shape:
            continue
        compared = _compared(own, own_mask, *_small(other_rgb, other_mask))
        if compared is not None:
            found = compared if found is None else np.where(np.abs(compared) > np.abs(found), compared, found)
    if found is None:
        return None
    return np.asarray(cv2.resize(found, (shape[1], shape[0]), interpolation=cv2.INTER_LINEAR), np.float32)


def _small(rgb: Picture, mask: Image) -> tuple[Image, Bools]:
    """Return a photo and its mask at the working size."""
    share = min(1.0, WORK_SIDE_PX / max(mask.shape))
    size = (max(round(mask.shape[1] * share), 1), max(round(mask.shape[0] * share), 1))
    small, inside = (cv2.resize(each, size, interpolation=cv2.INTER_AREA) for each in (rgb, mask))
    return small.astype(np.float32), inside > 0.5


def _compared(first: Image, inside: Bools, second: Image, other: Bools) -> Image | None:
    """Return log odds by one comparison; None where the camera has moved."""
    side = max(inside.shape)
    away, other_away = (cv2.distanceTransform((~each).astype(np.uint8), cv2.DIST_L2, 3) for each in (inside, other))
    sure = (away > SURELY * side) & (other_away > SURELY * side)
    if not sure.any():
        return None
    # The second exposure is brought to the first one's.
    gain = np.median(first[sure] + 1.0, axis=0) / np.median(second[sure] + 1.0, axis=0)
    apart = np.abs(first - gain.astype(np.float32) * second).max(axis=2)
    if float((apart[sure] < SAME_LEVELS).mean()) < SAME_SHARE:
        return None
    noise = max(float(np.median(apart[sure])), LEAST_NOISE)
    likely = cv2.blur((apart / (SPREAD * noise)) ** 2, (NEIGHBOURS, NEIGHBOURS))
    odds = INDEPENDENT * (np.log(noise / PERSON_LEVELS) + 0.5 * likely)
    odds = np.clip(odds, -MOST_ROOM, MOST_PERSON).astype(np.float32)
    return np.where(other_away > PROBABLY * side, odds, np.float32(0.0))


def without_room(mask: Image, room: Image | None) -> Image:
    """Return a mask (H, W, 0..1) that believes what other photos show of the room."""
    if room is None:
        return mask
    held = np.clip(mask, 0.01, 0.99)
    odds = np.log(held / (1.0 - held)) + np.minimum(room, 0.0)
    return np.where(room < 0.0, 1.0 / (1.0 + np.exp(-odds)), mask).astype(np.float32)
