"""Rumple of the clothes' outline: loose ones fold and end in steps, tight ones follow the body."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.body.outlined import OutlinedPhoto, PosedSilhouette
from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.outlines.rumples import STEP_MM, rumples_mm
from cloner.records.arrays import Array
from cloner.records.measures import Cover
from cloner.records.silhouettes import SilhouetteSet

#: What each number is and where it comes from: ``cloner/calibration/measure.toml``.
_CALIBRATED: Final = calibrated("measure.rumpled")


#: Segments under what is worn above the waist and below it. The pelvis has the hem of one over the other.
GARMENTS: Final = (("torso", "pelvis", "upper_arm", "forearm"), ("thigh", "calf"))
NEAR_MM: Final = _CALIBRATED.number("near_mm", "mm")
LEAST_MM: Final = _CALIBRATED.number("least_mm", "mm")


def garments_rumples_mm(
    seen: Mapping[ViewId, PosedSilhouette],
    photos: Mapping[ViewId, OutlinedPhoto],
    silhouettes: SilhouetteSet,
    covers: Mapping[str, Cover],
) -> Array:
    """Return (2,) the median rumple of the outline above and below the waist, mm; NaN where too little cloth is seen.

    Parameters
    ----------
    seen : mapping of ViewId to Seen
        The person's skin posed as in each photo.
    photos : mapping of ViewId to Outlined
    silhouettes : SilhouetteSet
    covers : mapping of str to Cover
        By segment; bare skin is left out.
    """
    generic = load_generic()
    under_cloth = _always_covered(covers)
    names = np.array([name.removeprefix("left_").removeprefix("right_") for name in generic.segment_names])
    parts, heights = [], []
    for view, one in seen.items():
        rim = np.flatnonzero(one.body.on_rim)
        tree = cKDTree(one.body.pixels[rim])
        for contour in silhouettes.views[view].contours_px:
            places, height = rumples_mm(contour, one.mm_per_px)
            if not len(places):
                continue
            away, nearest = tree.query(places)
            good = (away * one.mm_per_px < NEAR_MM) & under_cloth[rim[nearest]] & ~photos[view].field.is_veiled(places)
            parts.append(names[generic.vertex_segment[rim[nearest]]][good])
            heights.append(np.abs(height[good]))
    part, size = np.concatenate([[""], *parts]), np.concatenate([[0.0], *heights])
    own = [size[np.isin(part, garment)] for garment in GARMENTS]
    return np.array([np.median(each) if len(each) * STEP_MM > LEAST_MM else np.nan for each in own])


def _always_covered(covers: Mapping[str, Cover]) -> NDArray[np.bool_]:
    """Return where (V,) no photo shows bare skin."""
    generic = load_generic()
    covered = np.ones(len(generic.vertex_segment), dtype=bool)
    for row, name in enumerate(generic.segment_names):
        if name in covers and covers[name].covered:
            members = np.flatnonzero(generic.vertex_segment == row)
            slices = np.array([slice_ is not False for slice_ in covers[name].covered])
            place = (generic.slice_s[members] * len(slices)).astype(np.int64)
            covered[members] = slices[np.clip(place, 0, len(slices) - 1)]
    return covered
