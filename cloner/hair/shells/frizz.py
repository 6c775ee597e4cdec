"""Single hairs that stand out of the hair's outline: how many there are, measured where photos show them on background.

An outline is where half of the pixels are hair. What lies beyond it is no surface: tufts of a curly head, strands of a
short cut. Between hair's colour and the background's every pixel tells its share of hair (the compositing equation of
matting, Porter and Duff 1984, solved for alpha).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array
from cloner.records.photos import Photo
from cloner.vision.photographs.blending import push_pull

Mask = NDArray[np.bool_]

#: Beyond the outline shares are told ring by ring, mm; background is what lies farther out than all rings.
RING_MM: Final = 3.0
RINGS: Final = 18
#: How far around the hair a photo is looked at, mm.
AROUND_MM: Final = 90.0
#: Finer photos are reduced: a tuft is a millimetre wide.
FINEST_MM: Final = 0.4
#: Hair's own colour is taken so deep inside its outline, and colours of hair and background are this smooth, mm.
DEEP_MM: Final = 5.0
#: The person's outline and the hair's are one line where they lie no farther apart than this; other parts of the
#: person stay farther off. Specks of other labels in the rim are no parts, mm.
SAME_MM, OTHER_MM, SPECK_MM = 4.0, 12.0, 4.0
#: Levels by which hair and background must differ, and the share of the rim where they do.
CONTRAST: Final = 40.0
RIM_SHARE: Final = 0.4
#: A photo whose background looks so much like hair in the outermost rings tells nothing.
OUTERMOST: Final = 3
CLUTTER: Final = 0.03
FEWEST_PX: Final = 30
#: A larger share tells no depth any more.
THICKEST: Final = 0.95
#: Mean length of hairs beyond the outline, mm: shorter is the outline's own blur, longer another thing's edge.
SHORTEST_MM, LONGEST_MM, LENGTH_STEP_MM = 3.0, 15.0, 0.25
#: Below this depth times way, mm, or this depth hair is smooth: straight hair of generated people has
#: up to 1.6 mm, before a pattern .2; frizzy hair 3.0 to 5.2 mm and .5 to .8 (12 people).
LEAST_MM, LEAST_DEPTH = 1.8, 0.3


@dataclass(frozen=True, slots=True)
class Frizz:
    """Hairs beyond the outline: their share at a distance d is 1 - exp(-depth exp(-d / length)).

    Single hairs cover each other by chance, as droplets of a fog do (Beer's law), and thin out outwards.

    Attributes
    ----------
    depth : float
        Optical depth at the outline.
    length_mm : float
    """

    depth: float
    length_mm: float


def measure_frizz(views: list[HairView], photos: Mapping[ViewId, Photo], points_m: Array) -> Frizz | None:
    """Return the hairs beyond the outline, None where hair is smooth or no photo can tell.

    Parameters
    ----------
    views : list of HairView
    photos : mapping of ViewId to Photo
    points_m : (N, 3) of the hair at rest, for the size of a pixel
    """
    shown = []
    for view in views:
        if view.flip_m is None and view.posed.view in photos:
            shares = shares_beyond(photos[view.posed.view].rgb, view, view.pixel_mm(view.to_view(points_m)))
            if shares is not None:
                shown.append(shares)
    if not shown:
        return None
    usual = np.sort(shown, axis=0)[(len(shown) - 1) // 2]  # of two photos the smoother: a background may look like hair
    depths = -np.log1p(-np.minimum(usual, THICKEST))
    lengths_mm = np.arange(SHORTEST_MM, LONGEST_MM, LENGTH_STEP_MM)
    falls = np.exp(-RING_MM * (np.arange(RINGS) + 0.5) / lengths_mm[:, None])
    scales = falls @ depths / (falls**2).sum(axis=1)
    best = int(np.argmin(((depths - scales[:, None] * falls) ** 2).sum(axis=1)))  # a tail of clutter counts little
    frizz = Frizz(float(scales[best]), float(lengths_mm[best]))
    told = best > 0 and frizz.depth >= LEAST_DEPTH and frizz.depth * frizz.length_mm >= LEAST_MM
    return frizz if told else None


def shares_beyond(rgb: NDArray[np.uint8], view: HairView, pixel_mm: float) -> Array | None:
    """Return (RINGS,) the share of hair by distance beyond its outline, None where the photo cannot tell."""
    near = view.hair_px * pixel_mm > -AROUND_MM
    rows, columns = np.flatnonzero(near.any(axis=1)), np.flatnonzero(near.any(axis=0))
    if not view.hair.any() or not rows.size:
        return None
    box = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    step = max(FINEST_MM / pixel_mm, 1.0)
    size = max(int(np.ptp(columns) / step), 1), max(int(np.ptp(rows) / step), 1)
    picture = cv2.resize(rgb[box], size, interpolation=cv2.INTER_AREA).astype(np.float32)
    hair, person = (
        cv2.resize(mask[box].astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0
        for mask in (view.hair, view.outline_px > 0.0)
    )
    return _shares(picture, hair, person | hair, pixel_mm * step)


def _shares(picture: NDArray[np.float32], hair: Mask, person: Mask, pixel_mm: float) -> Array | None:
    to_hair, to_person = _away_mm(hair, pixel_mm), _away_mm(person, pixel_mm)
    speck = 2 * max(round(SPECK_MM / pixel_mm), 1) + 1
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (speck, speck))
    other = cv2.morphologyEx((person & ~hair).astype(np.uint8), cv2.MORPH_OPEN, kernel) > 0
    deep = hair & (_away_mm(~hair, pixel_mm) > DEEP_MM)
    far = to_person > RING_MM * RINGS
    if np.count_nonzero(deep) < FEWEST_PX or np.count_nonzero(far) < FEWEST_PX:
        return None
    behind, own = (_spread(picture, known, DEEP_MM / pixel_mm) for known in (far, deep))
    apart = own - behind
    contrast = np.einsum("ijk,ijk->ij", apart, apart)
    share = np.einsum("ijk,ijk->ij", picture - behind, apart) / np.maximum(contrast, 1.0)
    rim = ~person & (to_hair <= to_person + SAME_MM) & (_away_mm(other, pixel_mm) > to_hair + OTHER_MM)
    rim &= to_hair < AROUND_MM
    told = rim & (contrast > CONTRAST**2)
    ring = np.floor(to_hair[told] / RING_MM).astype(np.int64)
    counts = np.bincount(ring, minlength=RINGS)
    if np.count_nonzero(told) < RIM_SHARE * np.count_nonzero(rim) or counts[:RINGS].min() < FEWEST_PX:
        return None
    means = np.bincount(ring, np.clip(share[told], 0.0, 1.0), minlength=RINGS)[:RINGS] / counts[:RINGS]
    clutter = float(means[-OUTERMOST:].mean())
    return None if clutter > CLUTTER else np.maximum(means - clutter, 0.0)


def _away_mm(mask: Mask, pixel_mm: float) -> Array:
    """Return (H, W) the distance to a mask, mm, zero inside."""
    away = cv2.distanceTransform((~mask).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    return np.asarray(away, np.float64) * pixel_mm


def _spread(picture: NDArray[np.float32], known: Mask, blur_px: float) -> NDArray[np.float32]:
    """Return a picture whose known colours go on smoothly everywhere; found at half its size, it is that smooth."""
    size = (-(-known.shape[1] // 2), -(-known.shape[0] // 2))
    weight = cv2.resize(known.astype(np.float32), size, interpolation=cv2.INTER_AREA)
    total = cv2.resize(picture * known[..., None], size, interpolation=cv2.INTER_AREA)
    told = (weight > 0.0).astype(np.float32)
    whole = push_pull(np.asarray(total / np.maximum(weight, 1e-6)[..., None], np.float32), told)
    smooth = cv2.GaussianBlur(whole, (0, 0), max(blur_px / 2.0, 0.5))
    return np.asarray(cv2.resize(smooth, known.shape[::-1], interpolation=cv2.INTER_LINEAR), np.float32)
