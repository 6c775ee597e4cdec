"""Hoods and patches: clothes on a scalp are a hood in all photos, or a mistake in one.

A hood has a volume as hair has, down to the neck; from there on it is the garment's.
"""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView, cover
from cloner.records.arrays import Array
from cloner.records.labels import GARMENTS, Label, shows
from cloner.vision.segmentation.pieces import connected_pieces

GLASSES = 0.04  # taste: of the scalp's longer side, some 7 mm: frames of glasses are thinner
HOOD = 0.5  # of the scalp that photos show clothed


def without_hoods(
    views: list[HairView], scalp_m: Array, normals: Array, triangles: NDArray[np.int32]
) -> list[HairView]:
    """Return the evidence with hair where single photos have clothes on a scalp that is mostly hair.

    A hood is a hood in all photos; a patch of clothes on a crown is the label net's mistake. What goes on beyond the
    scalp is none: a neck below a high hairline, a collar.

    Parameters
    ----------
    scalp_m, normals : (N, 3)
    triangles : (T, 3) of the scalp
    """
    places = [seen_scalp(view, scalp_m, normals, triangles) for view in views]
    straight = [(view, place) for view, place in zip(views, places, strict=True) if view.flip_m is None]
    hairy = sum(int((view.hair & place).sum()) for view, place in straight)
    clothed = sum(int((view.clothed & place).sum()) for view, place in straight)
    if not clothed or clothed > HOOD * (hairy + clothed):
        return views
    found = []
    for view, place in zip(views, places, strict=True):
        wrong = _lying_on(view.clothed, place, 0.5) & place
        if wrong.any():
            hair, to_hair, to_hairline, _ = distances_px(view.hair | wrong, view.outline_px > 0.0)
            view = replace(view, hair=hair, hair_px=to_hair, line_px=to_hairline)
        found.append(view)
    return found


def hood_on(labels: NDArray[np.uint8], scalp: NDArray[np.bool_], neck_px: float) -> NDArray[np.bool_]:
    """Return (H, W) the hood of a photo: clothes joined to those on the scalp, above the row of the neck's base.

    Where a hood is taken for something worn on the head it counts as well, but for what is as thin as glasses.

    Parameters
    ----------
    labels : (H, W) uint8
    scalp : (H, W) bool
        Pixels before which the scalp lies.
    """
    size = max(int(np.count_nonzero(scalp.any(axis=axis))) for axis in (0, 1))
    accessory = (labels == Label.ACCESSORY).astype(np.uint8)
    side = 2 * int(np.ceil(0.5 * GLASSES * size)) + 1
    thick = cv2.morphologyEx(accessory, cv2.MORPH_OPEN, np.ones((side, side), np.uint8)) > 0
    worn = shows(labels, *GARMENTS) | thick
    worn[max(int(np.ceil(neck_px)), 0) :] = False
    return _lying_on(worn, scalp, 0.0)


def _lying_on(clothed: NDArray[np.bool_], place: NDArray[np.bool_], share: float) -> NDArray[np.bool_]:
    """Return (H, W) the pieces that lie on a place by more than a share of their area."""
    box, pieces, figures = connected_pieces(clothed)
    inside = np.bincount(pieces[place[box]], minlength=len(figures))
    most = inside > share * figures[:, cv2.CC_STAT_AREA]
    most[0] = False
    found = np.zeros(clothed.shape, np.bool_)
    found[box] = most[pieces]
    return found


def seen_scalp(view: HairView, scalp_m: Array, normals: Array, triangles: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Return (H, W) pixels that show the scalp or what grows there: nothing of a head lies before it."""
    towards = view.posed.camera.position_m - view.to_view(scalp_m)
    facing = np.einsum("nk,nk->n", view.turn(normals), towards) > 0.0
    size = (view.hair.shape[1], view.hair.shape[0])
    own = cover(view, scalp_m, triangles[facing[triangles].all(axis=1)]).astype(np.uint8)
    return np.asarray(cv2.resize(own, size, interpolation=cv2.INTER_NEAREST) > 0)
