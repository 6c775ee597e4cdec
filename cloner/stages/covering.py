"""Which parts of the body cloth covers, by the colours of the photos.

Bare skin has the colour of the face; sleeves and trousers end somewhere between
their garment and the hand or foot. Where the garment itself has the skin's colour,
nothing is told.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, m_from_mm
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.seeing import facing, look
from cloner.geometry.skinning import joint_transforms, skin
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.labels import SKINS, Label, shows
from cloner.records.measures import Cover
from cloner.records.photos import PhotoSet
from cloner.records.points import Proposals
from cloner.stages.outlined import body_triangles
from cloner.vision.skin_colour import FARTHEST, SkinColour, skin_colour, skin_distance

Array = NDArray[np.float64]

#: Value of skin in the labels of the head.
#: Slices a segment.
SLICES: Final = 8
#: Steeper surfaces mix with what is behind them.
LEAST_COSINE: Final = 0.35
#: Colours are averaged over about this far: pores, threads and noise are smaller.
PATCH_MM: Final = 6.0
#: Pixels that give a photo's colour of skin; all of a face photo's would take ten times as long.
SKIN_SAMPLES: Final = 20_000
#: Fewer seen vertices tell nothing of a slice.
LEAST_VERTICES: Final = 4
#: Limbs with the segment of their own garment, which is taken as covered.
LIMBS: Final = {("upper_arm", "forearm"): "torso", ("thigh", "calf"): "pelvis"}
#: A garment that looks like skin in more of its slices than this says nothing about its sleeves.
SKIN_LIKE: Final = 0.3
#: Hands, feet and neck are small: skin elsewhere within these shares is the fit's error or a collar's edge.
CLOTH_SHARE: Final = 0.2
SKIN_SHARE: Final = 0.4


def covers(photos: PhotoSet, proposals: Proposals, joined: Joined) -> dict[str, Cover]:
    """Return by segment whether cloth covers it; segments that no photo shows are missing.

    Parameters
    ----------
    photos : PhotoSet
    proposals : Proposals
        With the head's labels.
    joined : Joined
        The person's skin with every photo's camera and pose.
    """
    generic = load_generic()
    far = _distances(generic, photos, proposals, joined)
    if not np.isfinite(far).any():
        return {}
    shares = {name: _slices(generic, name, far) for name in generic.segment_names if name != "head"}
    told: dict[str, Cover] = {}
    for (near, distal), garment in LIMBS.items():
        known = shares[garment][~np.isnan(shares[garment])]
        cloth = 1.0 - float(known.mean()) if len(known) else 0.0
        told[garment] = Cover((True,) * SLICES, cloth)
        for side in ("left", "right"):
            names = (f"{side}_{near}", f"{side}_{distal}")
            row = np.concatenate([shares[name] for name in names])
            covered = ending(row)
            if 1.0 - cloth > SKIN_LIKE:  # a garment of the skin's colour: what looks like skin may be sleeve
                covered = [True if slice_ else None for slice_ in covered]
            clear = float(np.nanmean(np.abs(2.0 * row - 1.0))) if np.isfinite(row).any() else 0.0
            for place, name in enumerate(names):
                told[name] = Cover(tuple(covered[place * SLICES : (place + 1) * SLICES]), min(clear, cloth))
    told["neck"] = _whole(far[generic.region("neck")])
    for side in ("left", "right"):
        for part in ("hand", "foot"):
            segment = generic.vertex_segment == generic.segment_names.index(f"{side}_{part}")
            told[f"{side}_{part}"] = _whole(far[segment])
    return {name: cover for name, cover in told.items() if any(slice_ is not None for slice_ in cover.covered)}


def ending(share: Array) -> list[bool | None]:
    """Return which slices of a limb are covered: cloth from its upper end to a hem, then skin, then perhaps a sock.

    Parameters
    ----------
    share : (K,) share of skin in each slice from the upper end on, NaN where not seen

    Notes
    -----
    The two ends are those that contradict the colours least; unseen slices follow their neighbours.
    """
    seen = ~np.isnan(share)
    if not seen.any():
        return [None] * len(share)
    value = np.where(seen, share, 0.5) - 0.5  # positive: skin
    total = np.concatenate([[0.0], np.cumsum(value)])
    count = len(share)
    ends = [(total[last] - total[first], first, last) for first in range(count + 1) for last in range(first, count + 1)]
    gain, first, last = max(ends, key=lambda end: (end[0], end[2] - end[1]))
    return [not (first <= place < last and gain > 0.0) for place in range(count)]


def _distances(generic: GenericHuman, photos: PhotoSet, proposals: Proposals, joined: Joined) -> Array:
    """Return (V,) distances of the vertices' colours from the skin's, of the photo that sees each best; NaN unseen."""
    best, seen = np.zeros(len(joined.vertices_m)), np.full(len(joined.vertices_m), np.nan)
    skins = {view: _skin_in(photos, proposals, view) for view in proposals.views}
    for view in photos.body_views:
        own = skins.get(view) or _any_skin(skins)
        if view not in joined.views or own is None:
            continue
        rows, cosine, colours = _seen_colours(generic, photos, proposals, joined, joined.views[view])
        far = skin_distance(colours, own)
        better = cosine > best[rows]
        seen[rows[better]] = np.minimum(far[better], 1e3)
        best[rows[better]] = cosine[better]
    return seen


def _skin_in(photos: PhotoSet, proposals: Proposals, view: ViewId) -> SkinColour | None:
    proposal = proposals.views[view]
    rgb = photos.photos[view].rgb[shows(proposal.labels, *SKINS)]
    return skin_colour(rgb[:: max(len(rgb) // SKIN_SAMPLES, 1)])


def _any_skin(skins: Mapping[ViewId, SkinColour | None]) -> SkinColour | None:
    """Return the skin of another body photo, else of a face photo: the best there is for a back without neck."""
    known = {view: own for view, own in skins.items() if own is not None}
    return known[min(known, key=lambda view: (view.is_face, view))] if known else None


def _seen_colours(
    generic: GenericHuman, photos: PhotoSet, proposals: Proposals, joined: Joined, posed: PosedView
) -> tuple[NDArray[np.int64], Array, NDArray[np.uint8]]:
    """Return the vertices that a photo sees well, the cosine of their slope and their (N, 3) colours."""
    rgb, proposal = photos.photos[posed.view].rgb, proposals.views[posed.view]
    transforms = joint_transforms(joined.joints_m, generic.joint_parents.astype(np.int32), posed.rotations)
    weights = generic.skin_weights.astype(np.float64)
    posed_m = skin(joined.vertices_m, transforms, generic.skin_joints, weights)
    triangles = body_triangles()
    sight = look(posed_m, triangles, posed.camera, facing(posed_m, triangles, posed.camera))
    column, row = np.rint(sight.pixel_px).astype(np.int64).T
    height, width = rgb.shape[:2]
    inside = (column >= 0) & (row >= 0) & (column < width) & (row < height)
    inside[inside] &= (proposal.mask[row[inside], column[inside]] > 127) & (
        proposal.labels[row[inside], column[inside]] != Label.HAIR
    )
    good = inside & (sight.cosine > LEAST_COSINE) & sight.visible(sight.pixel_px, sight.depth_m, sight.cosine)
    rows = np.flatnonzero(good & (generic.vertex_part == generic.part_names.index("body")))
    reach = max(0.5 * m_from_mm(PATCH_MM) / posed.camera.metres_per_pixel(joined.vertices_m.mean(axis=0)), 0.5)
    smooth = cv2.GaussianBlur(rgb, (0, 0), reach)
    return rows, sight.cosine[rows], smooth[row[rows], column[rows]]


def _slices(generic: GenericHuman, name: str, far: Array) -> Array:
    """Return (SLICES,) shares of skin along a segment, NaN where too little was seen."""
    members = (generic.vertex_segment == generic.segment_names.index(name)) & ~np.isnan(far)
    place = np.clip((generic.slice_s * SLICES).astype(int), 0, SLICES - 1)
    shares = np.full(SLICES, np.nan)
    for k in range(SLICES):
        own = far[members & (place == k)]
        if len(own) >= LEAST_VERTICES:
            shares[k] = float(np.mean(own < FARTHEST))
    return shares


def _whole(far: Array) -> Cover:
    seen = far[~np.isnan(far)]
    if len(seen) < LEAST_VERTICES:
        return Cover((None,), 0.0)
    share = float(np.mean(seen < FARTHEST))
    covered = None if CLOTH_SHARE < share < SKIN_SHARE else share <= CLOTH_SHARE
    return Cover((covered,), abs(2.0 * share - 1.0))
