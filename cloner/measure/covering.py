"""Parts of the body that cloth covers, by the labels of the photos.

Sleeves and trousers end somewhere between their garment and the hand or foot.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.cameras.visibility import compute_visibility, front_facing
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.labels import CLOTHES, SKINS, labels_at
from cloner.records.measures import Cover
from cloner.records.proposals import Proposals

#: What each number is and where it comes from: ``cloner/calibration/measure.toml``.
_CALIBRATED: Final = calibrated("measure.covering")


#: Slices a segment.
SLICES: Final = 8
LEAST_COSINE: Final = _CALIBRATED.number("least_cosine", "cosine")
#: Fewer seen vertices tell nothing of a slice.
LEAST_VERTICES: Final = 4
#: Limbs with the segment of their own garment, which is taken as covered.
LIMBS: Final = {("upper_arm", "forearm"): "torso", ("thigh", "calf"): "pelvis"}
CLOTH_SHARE: Final = _CALIBRATED.number("cloth_share", "share")
SKIN_SHARE: Final = _CALIBRATED.number("skin_share", "share")


def find_covers(proposals: Proposals, joined: Joined) -> dict[str, Cover]:
    """Return whether cloth covers each segment; segments that no photo shows are missing.

    Parameters
    ----------
    proposals : Proposals
        With the labels.
    joined : Joined
        The person's skin with every photo's camera and pose.
    """
    generic = load_generic()
    bare = _bare_skin(generic, proposals, joined)
    if not np.isfinite(bare).any():
        return {}
    shares = {name: _slices(generic, name, bare) for name in generic.segment_names if name != "head"}
    covers: dict[str, Cover] = {}
    for (near, distal), garment in LIMBS.items():
        known = shares[garment][~np.isnan(shares[garment])]
        cloth = 1.0 - float(known.mean()) if len(known) else 0.0
        covers[garment] = Cover((True,) * SLICES, cloth)
        for side in ("left", "right"):
            names = (f"{side}_{near}", f"{side}_{distal}")
            row = np.concatenate([shares[name] for name in names])
            covered = covered_slices(row)
            clear = float(np.nanmean(np.abs(2.0 * row - 1.0))) if np.isfinite(row).any() else 0.0
            for place, name in enumerate(names):
                covers[name] = Cover(tuple(covered[place * SLICES : (place + 1) * SLICES]), min(clear, cloth))
    covers["neck"] = _whole(bare[generic.region("neck")])
    for side in ("left", "right"):
        for part in ("hand", "foot"):
            segment = generic.segment(f"{side}_{part}")
            covers[f"{side}_{part}"] = _whole(bare[segment])
    return {name: cover for name, cover in covers.items() if any(slice_ is not None for slice_ in cover.covered)}


def covered_slices(share: Array) -> list[bool | None]:
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


def _bare_skin(generic: GenericHuman, proposals: Proposals, joined: Joined) -> Array:
    """Return 1 (V,) where the body photo with the best view of a vertex shows skin, 0 where cloth; NaN where unseen."""
    best, seen = np.zeros(len(joined.vertices_m)), np.full(len(joined.vertices_m), np.nan)
    for view, posed in joined.views.items():
        if view.is_face or view not in proposals.views:
            continue
        rows, cosine, labels = _seen_labels(generic, proposals.views[view].labels, joined, posed)
        labelled = np.isin(labels, (*SKINS, *CLOTHES)) & (cosine > best[rows])
        seen[rows[labelled]] = np.isin(labels[labelled], SKINS)
        best[rows[labelled]] = cosine[labelled]
    return seen


def _seen_labels(
    generic: GenericHuman, labels: NDArray[np.uint8], joined: Joined, posed: PosedView
) -> tuple[NDArray[np.int64], Array, NDArray[np.uint8]]:
    """Return the vertices that a photo sees well, their cosines and their labels, (N,) each."""
    transforms = joint_transforms(joined.joints_m, generic.joint_parents.astype(np.int32), posed.rotations)
    posed_m = linear_blend_skinning(
        joined.vertices_m, transforms, generic.skin_joints, generic.skin_weights.astype(np.float64)
    )
    triangles = body_triangles()
    visibility = compute_visibility(posed_m, triangles, posed.camera, front_facing(posed_m, triangles, posed.camera))
    good = (visibility.cosine > LEAST_COSINE) & visibility.visible_vertices()
    rows = np.flatnonzero(good & generic.skin)
    return rows, visibility.cosine[rows], labels_at(labels, visibility.pixel_px[rows])


def _slices(generic: GenericHuman, name: str, bare: Array) -> Array:
    """Return (SLICES,) shares of skin along a segment, NaN where too little was seen."""
    members = generic.segment(name) & ~np.isnan(bare)
    place = np.clip((generic.slice_s * SLICES).astype(int), 0, SLICES - 1)
    shares = np.full(SLICES, np.nan)
    for k in range(SLICES):
        own = bare[members & (place == k)]
        if len(own) >= LEAST_VERTICES:
            shares[k] = float(own.mean())
    return shares


def _whole(bare: Array) -> Cover:
    seen = bare[~np.isnan(bare)]
    if len(seen) < LEAST_VERTICES:
        return Cover((None,), 0.0)
    share = float(seen.mean())
    covered = None if CLOTH_SHARE < share < SKIN_SHARE else share <= CLOTH_SHARE
    return Cover((covered,), abs(2.0 * share - 1.0))
