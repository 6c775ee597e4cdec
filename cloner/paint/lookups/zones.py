"""Zones of the surface and of a photo where hair is accepted and lookups are rejected."""

from __future__ import annotations

import functools
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.photo_shares import arms_beside_head, lower_arms
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample
from cloner.vision.retouching.matting import MattedPhoto

STRAY_SHARE = 0.006  # of the figure, 1 cm: how far lookups stray where a shoulder is misjudged
#: How far from the scalp hairlines of people lie on the face: foreheads are 6 cm high.
HAIRLINE_REACH_M: Final = 0.035


def always_bare(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return face and ears (V,): bare whatever colours say, under paint and glasses too."""
    return generic.region("face") | generic.region("ear_left") | generic.region("ear_right")


def hair_allowed(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return where (V,) hair in the photo is the surface's own colour: the scalp."""
    return generic.region("scalp")


@functools.cache
def _near_hairline() -> NDArray[np.bool_]:
    generic = load_generic()
    scalp = generic.vertices_m[generic.region("scalp")].astype(np.float64)
    away, _ = cKDTree(scalp).query(generic.vertices_m.astype(np.float64))
    return np.asarray(away < HAIRLINE_REACH_M)


def hair_kept(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return where (V,) hair labels are ignored unless a shell covers the skin: the face's rim below the hairline.

    Farther in it is a fringe or a strand that is labelled so, and the skin below it is another photo's.
    """
    return np.asarray(generic.region("face") & _near_hairline())


def near_shell(hair_m: NDArray[np.float32], shape: tuple[int, ...], reach_px: float) -> NDArray[np.bool_]:
    """Return the pixels (H, W) close to what hair shells cover: labels farther off are collars and napes."""
    height, width = shape[:2]
    size = 2 * int(np.ceil(reach_px * hair_m.shape[0] / height)) + 1
    near = cv2.dilate(np.isfinite(hair_m).astype(np.uint8), np.ones((size, size), np.uint8))
    return np.asarray(cv2.resize(near, (width, height), interpolation=cv2.INTER_NEAREST) > 0, bool)


def near_bare_head(generic: GenericHuman, matted: MattedPhoto, lookup_px: Array) -> NDArray[np.bool_]:
    """Return which lookups (V,) land on or beside the bare skin of head and neck; arms have skin of their own."""
    reach = 2 * int(np.ceil(STRAY_SHARE * matted.figure_px)) + 1
    head = matted.bare.astype(np.uint8)
    head[max(int(np.ceil(lookup_px[generic.region("neck"), 1].max())), 0) :] = 0
    grown = cv2.dilate(head, np.ones((reach, reach), np.uint8))
    return np.asarray(sample(grown, lookup_px)[:, 0] > 0.5)


def in_arm_zone(generic: GenericHuman, matted: MattedPhoto, lookup_px: Array) -> NDArray[np.bool_]:
    """Return False (V,) where an arm is seen but the mesh has the trunk, or the other way round."""
    if not matted.arms.any():
        return np.ones(len(lookup_px), bool)
    shown = sample(matted.arms.astype(np.uint8), lookup_px)[:, 0] > 0.5
    upper = arms_beside_head(generic)
    return np.where(lower_arms(generic), shown, ~shown | upper)
