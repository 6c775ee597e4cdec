"""Hoods and mislabelled patches: clothes on a scalp are a hood in most photos, or a mistake in one.

A hood has a volume as hair has, down to the neck; from there on it is the garment's.
"""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView, covered_by_surface
from cloner.records.arrays import Array
from cloner.records.labels import GARMENTS, Label, shows
from cloner.vision.segmentation.pieces import pieces_on

GLASSES = 0.04  # taste: of the scalp's longer side, some 7 mm: frames of glasses are thinner
HOOD = 0.5  # of the scalp that photos show clothed


def relabel_single_hoods(
    views: list[HairView], scalp_m: Array, normals: Array, triangles: NDArray[np.int32]
) -> list[HairView]:
    """Return the views with hair where single photos have clothes on a scalp that is mostly hair.

    A hood is a hood in all photos; a patch of clothes on a crown is the label net's mistake. What goes on beyond the
    scalp is none: a neck below a high hairline, a collar.

    Parameters
    ----------
    scalp_m, normals : (N, 3)
    triangles : (T, 3) of the scalp
    """
    places = [visible_scalp(view, scalp_m, normals, triangles) for view in views]
    straight = [(view, place) for view, place in zip(views, places, strict=True) if view.flip_m is None]
    hairy = sum(int((view.hair & place).sum()) for view, place in straight)
    clothed = sum(int((view.clothed & place).sum()) for view, place in straight)
    if not clothed or clothed > HOOD * (hairy + clothed):
        return views
    found = []
    for view, place in zip(views, places, strict=True):
        wrong = pieces_on(view.clothed, place, 0.5) & place
        if wrong.any():
            hair, to_hair, to_hairline, _ = distances_px(view.hair | wrong, view.outline_px > 0.0)
            view = replace(view, hair=hair, hair_px=to_hair, line_px=to_hairline)
        found.append(view)
    return found


def hood_pixels(
    labels: NDArray[np.uint8], alike: NDArray[np.bool_], scalp: NDArray[np.bool_], neck_px: float
) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of a photo's hood: clothes connected to those on the scalp, above the base of the neck.

    Where a hood is taken for hair or something worn on the head it counts as well, but for what is as thin as glasses.

    Parameters
    ----------
    labels : (H, W) uint8
    alike : (H, W) bool
        What looks as the cloth on the scalp does.
    scalp : (H, W) bool
        Pixels before which the scalp lies.
    """
    size = max(int(np.count_nonzero(scalp.any(axis=axis))) for axis in (0, 1))
    worn = shows(labels, *GARMENTS, Label.HAIR) | without_thin_parts(labels == Label.ACCESSORY, size) | alike
    worn[max(int(np.ceil(neck_px)), 0) :] = False
    return pieces_on(worn, scalp, 0.0)


def without_thin_parts(worn: NDArray[np.bool_], scalp_px: int) -> NDArray[np.bool_]:
    """Return what is worn on a head (H, W) without what is as thin as glasses."""
    return np.asarray(cv2.morphologyEx(worn.astype(np.uint8), cv2.MORPH_OPEN, _thin(scalp_px)) > 0)


def without_thin_gaps(worn: NDArray[np.bool_], scalp_px: int) -> NDArray[np.bool_]:
    """Return what is worn on a head (H, W), joined where a gap is as narrow as glasses: a fold, a stripe."""
    return np.asarray(cv2.morphologyEx(worn.astype(np.uint8), cv2.MORPH_CLOSE, _thin(scalp_px)) > 0)


def _thin(scalp_px: int) -> NDArray[np.uint8]:
    side = 2 * int(np.ceil(0.5 * GLASSES * scalp_px)) + 1
    return np.ones((side, side), np.uint8)


def visible_scalp(view: HairView, scalp_m: Array, normals: Array, triangles: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Return the pixels (H, W) that show the scalp or its hair, with no part of a head before it."""
    towards = view.posed.camera.position_m - view.to_view(scalp_m)
    facing = np.einsum("nk,nk->n", view.turn(normals), towards) > 0.0
    size = (view.hair.shape[1], view.hair.shape[0])
    own = covered_by_surface(view, scalp_m, triangles[facing[triangles].all(axis=1)]).astype(np.uint8)
    return np.asarray(cv2.resize(own, size, interpolation=cv2.INTER_NEAREST) > 0)
