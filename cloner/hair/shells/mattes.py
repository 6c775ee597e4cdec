"""Alpha mattes of hair around its outline: single hairs, strands and curls.

Between hair's colour and the wall's every pixel tells its share of hair (the compositing equation of matting, Porter
and Duff 1984, solved for alpha). Where most of the pixels are hair its surface lies: the core. What stands out of the
core is the rim, tufts of a curly head, ends of a short cut.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array
from cloner.records.photos import Photo
from cloner.vision.photographs.blending import push_pull

Mask = NDArray[np.bool_]
Picture = NDArray[np.float32]

#: Shares by distance from the core are told ring by ring, mm; no hair stands out farther than all rings.
RING_MM: Final = 3.0
RINGS: Final = 15
#: How far around the hair a photo is looked at, and from where on everything is the wall, mm.
AROUND_MM, WALL_MM = 60.0, 40.0
#: Finer photos are reduced: a strand is a millimetre wide.
FINEST_MM: Final = 0.5
#: Hair's own colour is taken so deep inside its outline, and colours of hair and wall are this smooth, mm.
DEEP_MM, SMOOTH_MM = 8.0, 5.0
#: Levels by which hair and wall must differ, and the share of the rim where they do.
CONTRAST, TOLD_SHARE = 40.0, 0.6
#: Smaller shares are a wall that is not as smooth as believed, larger ones whole.
HAZE: Final = (0.2, 0.8)
#: So many levels from all mixtures of hair and wall a pixel is doubted, at twice as many it is neither.
STRANGE: Final = 30.0
#: The core: so large a share within so many mm, so wide at least, and never drawn in deeper than so far.
DENSE, DENSE_MM, WIDE_MM, DEEPEST_MM = 0.75, 2.5, 20.0, 12.0
#: Other parts of the person stay so far off what is called rim; specks of other labels in it are no parts, mm.
OTHER_MM, SPECK_MM = 8.0, 4.0
#: A photo with a larger share in the outermost rings shows a wall like hair there.
OUTERMOST, CLUTTER = 3, 0.01
FEWEST_PX: Final = 30
#: Pixels with so large a share of hair have its colour, others that of the hair around: mixtures would shine. Through
#: sparse hair walls are seen also deep inside its outline: its colour is found again among those pixels.
PURE, ROUNDS = 0.9, 2
#: Where a ring has less than this share the rim ends.
LEAST_SHARE: Final = 0.05
#: Millimetres of hair beyond the core: smooth hair of five generated people and two samples has 2.3 to 2.75 (its own
#: edge's blur), crop curls and ends of short strands of four 2.9 to 3.7, three afros 8.2 to 8.9.
LEAST_MM: Final = 2.8


@dataclass(frozen=True, slots=True, eq=False)
class Matte:
    """The alpha matte of hair in a window of one photo.

    Attributes
    ----------
    share : (h, w) float32, 0..1
    rgb : (h, w, 3) float32
        Colours of the hair alone, levels.
    separable : (h, w) bool
        Where hair and wall differ.
    core : (h, w) bool
        Where hair is a surface.
    origin_px : (2,)
        Photo pixel of the window's first pixel.
    step : float
        Photo pixels a pixel of the window.
    pixel_mm : float
        Size of a pixel of the window.
    rings : (RINGS,)
        Mean share by distance from the core where the wall is behind; NaN where the photo cannot tell.
    """

    share: Picture
    rgb: Picture
    separable: Mask
    core: Mask
    origin_px: Array
    step: float
    pixel_mm: float
    rings: Array

    @property
    def clear(self) -> bool:
        """Return whether wall and hair differ in colour everywhere around."""
        return bool(np.isfinite(self.rings).all() and self.rings[-OUTERMOST:].mean() <= CLUTTER)

    def window_px(self, photo_px: Array) -> Array:
        """Return window pixels (N, 2) of photo pixels."""
        return (photo_px - self.origin_px + 0.5) / self.step - 0.5


def make_matte(rgb: NDArray[np.uint8], view: HairView, pixel_mm: float) -> Matte | None:
    """Return one photo's matte, None where it shows too little.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    view : HairView
    pixel_mm : float
        Size of a photo's pixel where the hair is.
    """
    near = view.hair_px * pixel_mm > -AROUND_MM
    rows, columns = np.flatnonzero(near.any(axis=1)), np.flatnonzero(near.any(axis=0))
    if not view.hair.any() or not rows.size:
        return None
    box = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    step = max(FINEST_MM / pixel_mm, 1.0)
    size = max(int(len(columns) / step), 1), max(int(len(rows) / step), 1)
    fine_mm = pixel_mm * step
    picture = cv2.resize(rgb[box], size, interpolation=cv2.INTER_AREA).astype(np.float32)
    hair, person = (
        cv2.resize(mask[box].astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0
        for mask in (view.hair, view.outline_px > 0.0)
    )
    other = cv2.morphologyEx((person & ~hair).astype(np.uint8), cv2.MORPH_OPEN, _disc(SPECK_MM / fine_mm)) > 0
    deep, wall = hair & (_away_mm(~hair, fine_mm) > DEEP_MM), _away_mm(person | hair, fine_mm) > WALL_MM
    if np.count_nonzero(deep) < FEWEST_PX:
        return None
    share, separable, pure = hair.astype(np.float32), np.zeros(hair.shape, np.bool_), deep
    own = _extrapolate(picture, pure, SMOOTH_MM / fine_mm)
    if np.count_nonzero(wall) >= FEWEST_PX:
        behind = _extrapolate(picture, wall, SMOOTH_MM / fine_mm)
        for _ in range(ROUNDS):
            share, separable, strange = _shares(picture, own, behind, hair)
            pure = hair & (share > PURE) & (strange < STRANGE)
            own = _extrapolate(picture, pure | (deep & ~separable), SMOOTH_MM / fine_mm)
    share = np.where(other, np.float32(0.0), share)
    core = _core(share, hair, other, fine_mm)
    alone = np.where(pure[..., None], picture, own)
    first = np.array([columns[0], rows[0]], np.float64)
    return Matte(
        share, alone, separable, core, first, step, fine_mm, _ring_means(share, separable, core, other, fine_mm)
    )


def _shares(picture: Picture, own: Picture, behind: Picture, hair: Mask) -> tuple[Picture, Mask, Picture]:
    """Return alpha (h, w) where hair differs from the wall, and each pixel's distance from mixtures of both."""
    apart = own - behind
    contrast = np.einsum("ijk,ijk->ij", apart, apart)
    along = np.einsum("ijk,ijk->ij", picture - behind, apart) / np.maximum(contrast, 1.0)
    # A colour that no mixture of both gives is another thing's: a shelf, a poster, a leaf.
    strange = np.linalg.norm(picture - behind - along[..., None] * apart, axis=2)
    share = np.clip((along - HAZE[0]) / (HAZE[1] - HAZE[0]), 0.0, 1.0)
    share *= np.where(hair, 1.0, np.clip(2.0 - strange / STRANGE, 0.0, 1.0))
    separable = contrast > CONTRAST**2
    return np.where(separable, share, hair).astype(np.float32), separable, strange


def hair_rim_mm(mattes: Iterable[Matte]) -> float | None:
    """Return how far hair stands out of its core, mm, None where it is smooth or no photo can tell.

    Of two photos the smoother is believed: a wall may look like hair.
    """
    shown = [matte.rings for matte in mattes if matte.clear]
    if not shown:
        return None
    usual = np.sort(shown, axis=0)[(len(shown) - 1) // 2]
    ends = np.flatnonzero(usual < LEAST_SHARE)
    reach = int(ends[0]) if ends.size else RINGS
    return RING_MM * reach if RING_MM * usual[:reach].sum() >= LEAST_MM else None


def make_mattes(photos: Mapping[ViewId, Photo], views: list[HairView], points_m: Array) -> dict[ViewId, Matte]:
    """Return every photo's matte, where it shows enough; ``points_m`` (N, 3) at rest give a pixel's size."""
    found = {}
    for view in views:
        if view.flip_m is None and view.posed.view in photos:
            matte = make_matte(photos[view.posed.view].rgb, view, view.pixel_mm(view.to_view(points_m)))
            if matte is not None:
                found[view.posed.view] = matte
    return found


def reduce_to_cores(views: list[HairView], mattes: Mapping[ViewId, Matte]) -> list[HairView]:
    """Return the views with hair reduced to its solid core."""
    return [reduce_to_core(view, mattes[view.posed.view]) if view.posed.view in mattes else view for view in views]


def reduce_to_core(view: HairView, matte: Matte) -> HairView:
    """Return a view with hair reduced to its solid core, to which surfaces are fitted."""
    placed = np.column_stack([np.eye(2) / matte.step, matte.window_px(np.zeros((1, 2)))[0]])
    flags = cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP
    core = cv2.warpAffine(matte.core.astype(np.uint8), placed, view.hair.shape[::-1], flags=flags) > 0
    hair, to_hair, _, to_person = distances_px(core, (view.outline_px > 0.0) & (core | ~view.hair))
    return replace(view, hair=hair, hair_px=to_hair, outline_px=to_person)


def _core(share: Picture, hair: Mask, other: Mask, pixel_mm: float) -> Mask:
    """Return the pixels (h, w) that are mostly hair, without narrow parts; the person beside it makes
    nothing narrow.
    """
    soft = cv2.GaussianBlur(np.where(other, np.float32(1.0), share), (0, 0), DENSE_MM / pixel_mm)
    dense = hair & ((soft > DENSE) | (_away_mm(~hair, pixel_mm) > DEEPEST_MM))
    disc = _disc(WIDE_MM / pixel_mm)
    air = len(disc)
    whole = cv2.copyMakeBorder((dense | other).astype(np.uint8), air, air, air, air, cv2.BORDER_REPLICATE)
    opened = cv2.morphologyEx(whole, cv2.MORPH_OPEN, disc)[air:-air, air:-air] > 0
    return np.asarray(dense & opened, np.bool_)


def _ring_means(share: Picture, separable: Mask, core: Mask, other: Mask, pixel_mm: float) -> Array:
    """Return the mean alpha (RINGS,) by distance from the core, NaN where unknown."""
    unknown = np.full(RINGS, np.nan)
    if not core.any():
        return unknown
    away, to_other = _away_mm(core, pixel_mm), _away_mm(other, pixel_mm)
    rim = (away > 0.0) & (away < RING_MM * RINGS) & (to_other > away + OTHER_MM)
    ring = np.floor(away / RING_MM).astype(np.int64)
    counts = np.bincount(ring[rim & separable], minlength=RINGS)[:RINGS]
    if np.count_nonzero(rim & separable) < TOLD_SHARE * np.count_nonzero(rim) or counts.min() < FEWEST_PX:
        return unknown
    return np.bincount(ring[rim & separable], share[rim & separable], minlength=RINGS)[:RINGS] / counts


def _disc(width_px: float) -> NDArray[np.uint8]:
    side = 2 * max(round(width_px / 2.0), 1) + 1
    return np.asarray(cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (side, side)), np.uint8)


def _away_mm(mask: Mask, pixel_mm: float) -> Array:
    """Return (h, w) the distance to a mask, mm, zero inside."""
    away = cv2.distanceTransform((~mask).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    return np.asarray(away, np.float64) * pixel_mm


def _extrapolate(picture: Picture, known: Mask, blur_px: float) -> Picture:
    """Return a picture with its known colours smoothly extended, computed at half its size."""
    size = (-(-known.shape[1] // 2), -(-known.shape[0] // 2))
    weight = cv2.resize(known.astype(np.float32), size, interpolation=cv2.INTER_AREA)
    total = cv2.resize(picture * known[..., None], size, interpolation=cv2.INTER_AREA)
    weighted = (weight > 0.0).astype(np.float32)
    whole = push_pull(np.asarray(total / np.maximum(weight, 1e-6)[..., None], np.float32), weighted)
    smooth = cv2.GaussianBlur(whole, (0, 0), max(blur_px / 2.0, 0.5))
    return np.asarray(cv2.resize(smooth, known.shape[::-1], interpolation=cv2.INTER_LINEAR), np.float32)
