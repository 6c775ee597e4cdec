"""Distance of the finished skin from the photos' outlines, as a colour map on the skin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from scipy.spatial import cKDTree

from cloner.editing.outline_constraints import posed_photo
from cloner.editing.places import generic_metric
from cloner.frames import ViewId
from cloner.generic.surfaces import body_triangles
from cloner.geometry.outlines.contour_search import occluding_contour
from cloner.geometry.outlines.silhouette import borders_px, fill_triangles
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.silhouettes import Silhouette

#: Skin this near to a place on the outline shows its gap, one standard deviation, metres (taste: a palm).
SPREAD_M: Final = 0.04
#: Skin farther than this from all places on an outline shows nothing.
_FARTHEST_M: Final = 0.12
#: Gaps beyond this are another part's outline, not the skin's own, mm: hair, a skirt, an arm over the trunk.
MOST_MM: Final = 60.0
#: Skin this near to the border of the clone's own picture makes it, px.
BORDER_PX: Final = 3.0
_NEIGHBOURS: Final = 12


def outline_gaps_mm(
    vertices_m: Array, joints_m: Array, views: Mapping[ViewId, PosedView], outlines: Mapping[ViewId, Silhouette]
) -> Array:
    """Return the distance (V,) between clone and photo outline nearby, mm; NaN where no body photo shows an outline.

    Parameters
    ----------
    vertices_m : (V, 3) rest pose
    joints_m : (94, 3)
    views : mapping
        Camera and pose of every photo.
    outlines : mapping
        The photos' own outlines.
    """
    places, gaps = [np.zeros((0, 3))], [np.zeros(0)]
    for view, posed in views.items():
        if not view.is_body or view not in outlines:
            continue
        seen = posed_photo(vertices_m, joints_m, posed)
        rim = np.unique(occluding_contour(generic_metric(), seen.posed_m, seen.pixels, seen.eye_m).edges)
        size = (posed.camera.height_px, posed.camera.width_px)
        border = np.concatenate([np.zeros((0, 2)), *borders_px(fill_triangles(seen.pixels, body_triangles(), size))])
        if not len(border):
            continue
        rim = rim[cKDTree(border).query(seen.pixels[rim])[0] < BORDER_PX]  # not before other parts of the person
        contours = np.concatenate(outlines[view].contours_px)
        away_mm = cKDTree(contours).query(seen.pixels[rim])[0] * seen.mm_per_px
        own = away_mm < MOST_MM
        places.append(vertices_m[rim[own]])
        gaps.append(away_mm[own])
    return _spread(vertices_m, np.concatenate(places), np.concatenate(gaps))


def _spread(vertices_m: Array, places_m: Array, values: Array) -> Array:
    """Return the mean near each vertex of values known at some points."""
    if len(places_m) < _NEIGHBOURS:
        return np.full(len(vertices_m), np.nan)
    distance, rows = cKDTree(places_m).query(vertices_m, k=_NEIGHBOURS, distance_upper_bound=_FARTHEST_M)
    weight = np.where(np.isfinite(distance), np.exp(-0.5 * (distance / SPREAD_M) ** 2), 0.0)
    total = weight.sum(axis=1)
    mean = (weight * np.append(values, 0.0)[rows]).sum(axis=1) / np.maximum(total, 1e-12)
    return np.where(total > 0.0, mean, np.nan)
