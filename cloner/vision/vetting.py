"""Labels of skin and hair checked against their own colours: a collar is neither."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter

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
#: Patches of hair label are judged by majority over this many checked pixels.
PATCH_PX: Final = 9
#: Cells of hair's colours: log red/green and log blue/green in steps, brightness in stops.
CHROMA_STEP: Final = 0.15
CELLS: Final = (21, 21, 12)
#: Share of a photo's hair that makes a colour one of the hair's.
LEAST_SHARE: Final = 0.003
#: How much oftener the background must have a colour than the hair.
BEHIND: Final = 2.0
#: Background that would take more of the hair is of its colour.
MOST_KEPT: Final = 0.8
#: How much likelier than in skin a colour must be in hair.
LIKELIER: Final = 0.25
#: Fewer pixels tell nothing.
LEAST_HAIR: Final = 100
#: Odds of hair against skin of one pixel count up to this many powers of two; means below `LEAST_ODDS` are a nape's.
MOST_ODDS: Final = 3.0
LEAST_ODDS: Final = -0.25
#: A neck taken for hair is no less than this share of the hair.
NECK_SHARE: Final = 0.015
#: Share that keeps the odds of colours seen nowhere finite.
UNSEEN_SHARE: Final = 1e-4
#: Pieces of hair smaller than this share of the largest are left-overs of what was denied.
LEAST_PIECE: Final = 0.05


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


@dataclass(frozen=True, slots=True, eq=False)
class HairColours:
    """How often colours occur in a person's hair and skin in some photos.

    Attributes
    ----------
    hair, skin : (R, B, L) float64
        Shares in cells of log red/green, log blue/green and brightness in stops.
    """

    hair: NDArray[np.float64]
    skin: NDArray[np.float64]

    def has(self, rgb: NDArray[np.uint8]) -> NDArray[np.bool_]:
        """Return which of (N, 3) colours are the hair's; what skin has more often is skin's: labels overlap."""
        known = (self.hair > LEAST_SHARE) & (self.hair > LIKELIER * self.skin)
        return np.asarray(known[_cells(rgb)], bool)

    def odds(self, rgb: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return (N,) powers of two by which each of (N, 3) colours is oftener hair's than skin's, limited."""
        ratio = (self.hair + UNSEEN_SHARE) / (self.skin + UNSEEN_SHARE)
        return np.asarray(np.clip(np.log2(ratio), -MOST_ODDS, MOST_ODDS)[_cells(rgb)], np.float32)

    def below(self, rgb: NDArray[np.uint8], behind: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return which of (N, 3) colours the background has clearly more often than the hair."""
        return np.asarray((behind > BEHIND * self.hair)[_cells(rgb)], bool)


def _cells(rgb: NDArray[np.uint8]) -> tuple[NDArray[np.intp], ...]:
    """Return the cell of each of (N, 3) colours."""
    ratios, light = chroma(rgb)
    places = [ratios[:, 0] / CHROMA_STEP, ratios[:, 1] / CHROMA_STEP, np.log2(light)]
    middles = (CELLS[0] // 2, CELLS[1] // 2, CELLS[2] - 1)
    return tuple(
        np.clip(np.rint(place) + middle, 0, cells - 1).astype(np.intp)
        for place, middle, cells in zip(places, middles, CELLS, strict=True)
    )


def hair_colours(hair: list[NDArray[np.uint8]], skin: list[NDArray[np.uint8]]) -> HairColours | None:
    """Return the colours of hair and skin from (N, 3) labelled pixels of each photo; None without hair."""
    own = _shares(hair)
    return HairColours(own, _shares(skin)) if own.any() else None


def _shares(samples: list[NDArray[np.uint8]]) -> NDArray[np.float64]:
    """Return how often colours occur in photos' (N, 3) pixels, a stop darker or brighter counted as well."""
    share = np.zeros(CELLS)
    for each in samples:
        if len(each) >= LEAST_HAIR:
            some = each[:: max(len(each) // SAMPLES, 1)]
            np.add.at(share, _cells(some), 1.0 / len(some))
    return np.asarray(maximum_filter(share, (1, 1, 3)))


def vet_hair(rgb: NDArray[np.uint8], hair: NDArray[np.bool_], colours: HairColours | None) -> NDArray[np.bool_]:
    """Return hair (H, W) without patches whose colours the person's hair has nowhere else: collars, necks, backs.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    hair : (H, W) bool, the label
    colours : HairColours or None
        From other photos of the person; None denies nothing.
    """
    if colours is None or not hair.any():
        return hair
    kept = _without(hair, rgb, lambda some: ~colours.has(some))
    return _without_nape(kept, rgb, colours) if kept.any() else kept


def without_neck(rgb: NDArray[np.uint8], hair: NDArray[np.bool_], skin: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return hair (H, W) of a side photo without the neck, if all of that was taken for it.

    Light falls alike on cheek and neck of one photo, so its own skin and the upper half of its own hair tell.
    What is small may be a soft edge and stays.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    hair, skin : (H, W) bool, the labels
    """
    rows = np.flatnonzero(hair.any(axis=1))
    if not rows.size:
        return hair
    upper = slice(0, (int(rows[0]) + int(rows[-1])) // 2)
    colours = hair_colours([rgb[upper][hair[upper]]], [rgb[skin]])
    if colours is None or not _shares([rgb[skin]]).any():
        return hair
    denied = hair & ~_without_nape(hair, rgb, colours)
    _, pieces, stats, _ = cv2.connectedComponentsWithStats(denied.astype(np.uint8), connectivity=4)
    large = stats[:, cv2.CC_STAT_AREA] >= NECK_SHARE * np.count_nonzero(hair)
    large[0] = False
    return np.asarray(hair & ~large[pieces], bool)


def _without_nape(hair: NDArray[np.bool_], rgb: NDArray[np.uint8], colours: HairColours) -> NDArray[np.bool_]:
    """Return hair (H, W) without the neck that a net took for it, and without crumbs.

    Lit skin has colours that shaded hair has as well: patches are judged by their mean odds. Only what reaches from
    the label's lower half to its edge is denied: shine on a crown is hair.
    """
    small, named = _halved(rgb, hair)
    odds = np.zeros(named.shape, np.float32)
    odds[named] = colours.odds(small[named])
    patch = (PATCH_PX, PATCH_PX)
    mean = cv2.boxFilter(odds, -1, patch) / np.maximum(cv2.boxFilter(named.astype(np.float32), -1, patch), 1e-6)
    denied = named & (mean < LEAST_ODDS)
    _, pieces = cv2.connectedComponents((denied | ~named).astype(np.uint8), connectivity=4)
    rows = np.flatnonzero(named.any(axis=1))
    outside = np.unique(pieces[~named])
    denied &= np.isin(pieces, outside[outside > 0])
    _, pieces, stats, _ = cv2.connectedComponentsWithStats(denied.astype(np.uint8), connectivity=4)
    low = stats[:, cv2.CC_STAT_TOP] + stats[:, cv2.CC_STAT_HEIGHT] > (rows[0] + rows[-1]) / 2
    low[0] = False
    kept = hair & ~(cv2.resize(low[pieces].astype(np.uint8), hair.shape[::-1], interpolation=cv2.INTER_NEAREST) > 0)
    return _without_crumbs(kept)


def _without_crumbs(hair: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return hair (H, W) without pieces far smaller than the largest."""
    _, pieces, stats, _ = cv2.connectedComponentsWithStats(hair.astype(np.uint8), connectivity=8)
    area = stats[:, cv2.CC_STAT_AREA].copy()
    area[0] = 0
    return np.asarray((area >= max(LEAST_PIECE * area.max(), 1))[pieces], bool)


def before_wall(
    rgb: NDArray[np.uint8], hair: NDArray[np.bool_], person: NDArray[np.bool_], colours: HairColours | None
) -> NDArray[np.bool_]:
    """Return hair (H, W) without patches through which the background shows: between tail and neck.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    hair, person : (H, W) bool
    colours : HairColours or None
        As in :func:`vet_hair`.

    Notes
    -----
    Before a wall of hair's own colour nothing can be told: then all stays.
    """
    if colours is None or not hair.any() or person.all():
        return hair
    behind = _shares([rgb[::2, ::2][~person[::2, ::2]]])
    kept = _without(hair, rgb, lambda some: colours.below(some, behind))
    return kept if kept.sum() > MOST_KEPT * hair.sum() else hair


def _without(
    hair: NDArray[np.bool_], rgb: NDArray[np.uint8], denies: Callable[[NDArray[np.uint8]], NDArray[np.bool_]]
) -> NDArray[np.bool_]:
    """Return hair (H, W) without patches of denied colours; single strands and shine may be of any colour."""
    small, named = _halved(rgb, hair)
    strange = np.zeros(named.shape, np.uint8)
    strange[named] = 255 * denies(small[named]).astype(np.uint8)
    strange = cv2.medianBlur(strange, PATCH_PX)
    return np.asarray(hair & (cv2.resize(strange, hair.shape[::-1], interpolation=cv2.INTER_NEAREST) == 0), bool)


def _halved(rgb: NDArray[np.uint8], label: NDArray[np.bool_]) -> tuple[NDArray[np.uint8], NDArray[np.bool_]]:
    """Return a photo (h, w, 3) and a label (h, w) at `SCALE`, where labels are checked."""
    size = (round(label.shape[1] * SCALE), round(label.shape[0] * SCALE))
    small = np.asarray(cv2.resize(rgb, size, interpolation=cv2.INTER_AREA), np.uint8)
    return small, cv2.resize(label.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0


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
