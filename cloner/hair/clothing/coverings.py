"""Consistent labels for head coverings: headscarves, beanies and caps keep one label, by their colour in each photo."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.hair.clothing.hoods import (
    HOOD,
    hood_pixels,
    visible_scalp,
    without_thin_gaps,
    without_thin_parts,
)
from cloner.hair.volumes.pictures import distances_px, fill_small_holes
from cloner.hair.volumes.views import HairView
from cloner.labels.glasses import worn_before_face
from cloner.records.arrays import Array
from cloner.records.labels import Label, shows
from cloner.records.photos import Photo
from cloner.records.proposals import Proposals
from cloner.vision.segmentation.colours import colour_ratio, quantise_colours
from cloner.vision.segmentation.pieces import pieces_on

Bools = NDArray[np.bool_]

#: Something is worn where more than this of the scalp that all photos show is labelled so, and not as hair.
WORN_SHARE: Final = 0.35
#: Nor is anything where less than this share of the scalp is: glasses, an alice band.
LEAST_WORN: Final = 0.1
#: It hangs below the scalp by so many heights of the scalp at most.
HANGS: Final = 1.6
#: Colours are told over so much of the scalp's height: a pixel is noise.
BLUR_SHARE: Final = 0.02
#: Where less than this share of a scalp is told to be worn, what looks like hair there tells the cloth's colour too.
SEED_SHARE: Final = 0.2
#: A head's cloth goes on as a garment where so large a share of what is above the neck's base lies below. A hood that
#: labels take for hair and scarves: .65, .98, 2.2 in three photos; four scarves, two beanies, a cap: .28 at most but
#: in one photo.
GOES_ON: Final = 0.5
#: Log likelihood above which a colour is the cloth's: half of what is told to be other clothes may be cloth as well.
#: Overlap with the true cloth, 17 covered heads: .903 at 0, .905 here and, worse in more of them, at -1.4.
LEAN: Final = -0.7
CLOTHES: Final = (Label.UPPER_CLOTHES, Label.LOWER_CLOTHES)
ACCESSORY: Final = (Label.ACCESSORY,)
#: Never part of a covering.
BARE: Final = (Label.EYES, Label.MOUTH, Label.BEARD, Label.BACKGROUND)


def merge_covering_labels(
    views: list[HairView],
    photos: Mapping[ViewId, Photo],
    proposals: Proposals,
    scalp_m: Array,
    normals: Array,
    triangles: NDArray[np.int32],
    neck_m: Array,
) -> tuple[list[HairView], bool]:
    """Return the views with all of a head covering as hair, where its label changes within one piece of cloth, and
    whether that is a hood.

    Whether something is worn, all photos tell together. Where it ends, each photo tells by its colours: what is joined
    to the cloth on the scalp and looks as it does is the same cloth; a hood ends at the neck, and is clothes below.

    Parameters
    ----------
    views : list of HairView
    photos, proposals
    scalp_m, normals : (N, 3)
    triangles : (T, 3) of the scalp
    neck_m : (3,) the neck's base
    """
    straight = [view for view in views if view.flip_m is None]
    labels = {view.posed.view: proposals.views[view.posed.view].labels for view in straight}
    places = {view.posed.view: visible_scalp(view, scalp_m, normals, triangles) for view in straight}
    worn, clothed, hairy = (
        sum(int(np.count_nonzero(shows(labels[view], *kinds) & place)) for view, place in places.items())
        for kinds in (ACCESSORY, CLOTHES, (Label.HAIR,))
    )
    whole = sum(int(np.count_nonzero(place)) for place in places.values())
    if worn + clothed <= max(WORN_SHARE * (worn + clothed + hairy), LEAST_WORN * whole):
        return views, False
    cloth = {view: head_covering(photos[view].rgb, labels[view], place) for view, place in places.items()}
    neck = {one.posed.view: one.posed.camera.project(one.to_view(neck_m[None]))[0, 1] for one in straight}
    hood = is_hood(labels, places) or goes_on_below(cloth, labels, neck)
    if hood and worn + clothed <= HOOD * whole:
        return views, False
    if hood:
        cloth = {view: hood_pixels(labels[view], cloth[view], place, neck[view]) for view, place in places.items()}
    found = []
    for view in views:
        own = cloth[view.posed.view] & ~view.hair
        if own.any():
            hair, to_hair, to_line, to_person = distances_px(
                view.hair | own, labels[view.posed.view] != Label.BACKGROUND
            )
            apart = view.clothed & ~hair
            view = replace(view, hair=hair, hair_px=to_hair, line_px=to_line, outline_px=to_person, clothed=apart)
        found.append(view)
    return found, hood


def is_hood(labels: Mapping[ViewId, NDArray[np.uint8]], scalp: Mapping[ViewId, Bools]) -> bool:
    """Return whether most photos label what covers the scalp as clothes, and none as headwear.

    Each photo counts alike: one that takes a hood for a scarf is outvoted, however large it shows the head.

    Parameters
    ----------
    labels : mapping of ViewId to (H, W) uint8
    scalp : mapping of ViewId to (H, W) bool
        Pixels before which the scalp lies.
    """
    lean = 0.0
    for view, place in scalp.items():
        clothed, worn = (np.count_nonzero(shows(labels[view], *kinds) & place) for kinds in (CLOTHES, ACCESSORY))
        lean += (clothed - worn) / max(int(np.count_nonzero(place)), 1)
    return lean > 0.0


def goes_on_below(
    cloth: Mapping[ViewId, Bools], labels: Mapping[ViewId, NDArray[np.uint8]], neck_px: Mapping[ViewId, float]
) -> bool:
    """Return whether in most photos that show a head's cloth it goes on as clothes below the base of the neck.

    Parameters
    ----------
    cloth : mapping of ViewId to (H, W) bool
        As :func:`head_covering` finds it by colour.
    neck_px : mapping of ViewId to float
        Row of the neck's base.
    """
    votes = []
    for view, own in cloth.items():
        if own.any():
            row = max(int(np.ceil(neck_px[view])), 0)
            below = np.count_nonzero(own[row:] & shows(labels[view][row:], *CLOTHES))
            votes.append(below > GOES_ON * np.count_nonzero(own[:row]))
    return bool(2 * sum(votes) > len(votes))


def head_covering(rgb: NDArray[np.uint8], labels: NDArray[np.uint8], scalp: Bools) -> Bools:
    """Return the pixels (H, W) of the cloth that covers a head: connected to the scalp and of the same colour.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    labels : (H, W) uint8
    scalp : (H, W) bool
        Pixels before which the scalp lies.
    """
    cloth = np.zeros(labels.shape, np.bool_)
    rows, columns = np.flatnonzero(scalp.any(axis=1)), np.flatnonzero(scalp.any(axis=0))
    if not rows.size:
        return cloth
    size = int(max(np.ptp(rows), np.ptp(columns))) + 1
    box = np.s_[
        max(rows[0] - size // 2, 0) : rows[-1] + int(HANGS * size) + 1,
        max(columns[0] - size, 0) : columns[-1] + size + 1,
    ]
    place, shown = scalp[box], labels[box]
    seed = place & shows(shown, Label.ACCESSORY, Label.UPPER_CLOTHES)
    hairy = bool(seed.sum() < SEED_SHARE * place.sum())
    if hairy:
        seed = place & shows(shown, Label.ACCESSORY, Label.UPPER_CLOTHES, Label.HAIR)
    if not seed.any():
        return cloth
    before = worn_before_face(shown)
    seed |= pieces_on((shown == Label.ACCESSORY) & ~before, place, 0.0)
    # cloth lies higher than the scalp: what is told to be skin up there is cloth too, lower down it is a face
    crown = np.arange(box[0].start, box[0].start + len(shown))[:, None] < rows[0] + size // 2
    # and where hair may be hair, clothes and necks of its colour are no cloth that hangs from the head
    elsewhere = (Label.FACE_SKIN, Label.HAIR, *((Label.BODY_SKIN, *CLOTHES) if hairy else ()))
    allowed = ~shows(shown, *BARE) & ~before & (place | crown | ~shows(shown, *elsewhere))
    alike = looks_as(rgb[box], shown, seed, ~(place | crown | seed), BLUR_SHARE * size) & allowed
    whole = fill_small_holes(without_thin_gaps(alike | seed, size) & allowed)
    cloth[box] = pieces_on(without_thin_parts(whole, size), seed & alike, 0.0)
    return cloth


def looks_as(rgb: NDArray[np.uint8], labels: NDArray[np.uint8], seed: Bools, apart: Bools, blur_px: float) -> Bools:
    """Return the person's pixels (H, W) whose colour occurs more among a cloth's seed than among what else is worn.

    Colours are counted, so that a cloth may have several: stripes, dots.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    labels : (H, W) uint8
    seed : (H, W) bool
    apart : (H, W) bool
        Where skin and garments are surely something else.
    """
    smooth = cv2.GaussianBlur(rgb, (0, 0), max(blur_px, 0.5))
    person = labels != Label.BACKGROUND
    palette = quantise_colours(np.asarray(cv2.cvtColor(smooth, cv2.COLOR_RGB2LAB), np.uint8), person)
    other = apart & shows(labels, Label.FACE_SKIN, Label.BODY_SKIN, *CLOTHES)
    found = np.zeros(labels.shape, np.bool_)
    found[person] = colour_ratio(palette, seed, other, person, window_px=float(max(labels.shape)))[0] > LEAN
    return found
