"""Overlap of the finished clone with the person in every photo."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, mm_from_m
from cloner.generic.layers import clone_layers
from cloner.parallel import parallel_map
from cloner.records.bodies import PosedView
from cloner.records.clones import Clone
from cloner.records.silhouettes import SilhouetteSet
from cloner.render import coverage

Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class PhotoAgreement:
    """Clone against extracted silhouette in one photo.

    Attributes
    ----------
    iou : float
        Intersection over union of the filled outlines; face photos count above the chin only.
    outline_rms_px, outline_rms_mm : float
        Root mean square distance between the two outlines, both ways.
    size : float
        Square root of the clone's area over the person's; 1 where they agree.
    """

    iou: float
    outline_rms_px: float
    outline_rms_mm: float
    size: float = 1.0


def agreements(clone: Clone, silhouettes: SilhouetteSet) -> dict[ViewId, PhotoAgreement]:
    """Return the agreement of every photo that has a silhouette and a camera.

    Notes
    -----
    This compares the clone with *our own* outline of the photo; the truth of
    synthetic visitors is compared by ``cloner evaluate``.
    """

    def drawn() -> Iterator[tuple[PosedView, Mask]]:  # on this thread, as GL wants it, while others compare
        for view in silhouettes.views:
            posed = clone.views.get(view)
            if posed is not None:
                layers = clone_layers(clone, posed.rotations if view.is_body else None)
                yield posed, coverage(layers, posed.camera, supersample=1) > 0.5  # half a pixel's cover

    def agreement(shown: tuple[PosedView, Mask]) -> tuple[ViewId, PhotoAgreement]:
        posed, own = shown
        return posed.view, _agreement(clone, posed, own, silhouettes.views[posed.view].mask)

    return dict(parallel_map(agreement, drawn()))


def _agreement(clone: Clone, posed: PosedView, drawn: Mask, seen: Mask) -> PhotoAgreement:
    """Return the agreement of one photo with the clone as its camera sees it."""
    row = _chin_row(clone, posed, seen.shape[0]) if posed.view.is_face else None
    return compare(drawn[:row], seen[:row], _mm_per_pixel(clone, posed))


def compare(drawn: Mask, seen: Mask, mm_per_px: float) -> PhotoAgreement:
    """Return the agreement of two masks of one size."""
    union = np.count_nonzero(drawn | seen)
    iou = np.count_nonzero(drawn & seen) / union if union else 0.0
    rms_px = _outline_rms_px(drawn, seen)
    size = float(np.sqrt(float(np.count_nonzero(drawn)) / max(float(np.count_nonzero(seen)), 1.0)))
    return PhotoAgreement(float(iou), rms_px, rms_px * mm_per_px, size)


def _outline_rms_px(drawn: Mask, seen: Mask) -> float:
    rows, columns = (np.flatnonzero((drawn | seen).any(axis=axis)) for axis in (1, 0))
    if not rows.size:
        return float(max(drawn.shape))
    box = (slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1))  # all outlines lie in it; saves time
    first, second = _boundary(drawn)[box], _boundary(seen)[box]
    if not first.any() or not second.any():
        return float(max(drawn.shape))  # nothing to compare: as far off as the photo is large
    both = np.concatenate([_distance_px(second)[first], _distance_px(first)[second]])
    return float(np.sqrt(np.mean(both**2)))


def _boundary(mask: Mask) -> Mask:
    """Return the mask's outermost pixels, without those on the picture's border."""
    inner = cv2.erode(mask.astype(np.uint8), cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3)), borderValue=1)
    return np.asarray(mask & (inner == 0))


def _distance_px(outline: Mask) -> NDArray[np.float32]:
    """Return (H, W) every pixel's exact distance to the nearest pixel of an outline."""
    return np.asarray(cv2.distanceTransform((~outline).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_PRECISE))


def _mm_per_pixel(clone: Clone, posed: PosedView) -> float:
    """Return the size of a pixel at the depth of the body's or the head's middle."""
    rows = clone.features_m.get("nose_tip") if posed.view.is_face else None
    middle = clone.vertices_m.mean(axis=0) if rows is None else rows
    return mm_from_m(posed.camera.metres_per_pixel(middle))


def _chin_row(clone: Clone, posed: PosedView, height_px: int) -> int:
    chin = clone.features_m.get("chin_bottom")
    if chin is None:
        return height_px
    row = posed.camera.project(np.asarray(chin)[None])[0, 1]
    return int(np.clip(round(float(row)), 1, height_px))
