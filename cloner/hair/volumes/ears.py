"""Ears and hair: ears below hair are pressed to the head, ears that stand out are not hair in a back photo."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.volumes.cap import covered_share
from cloner.hair.volumes.pictures import body_depth_m, distances_px
from cloner.hair.volumes.views import HairView, covered_by_surface
from cloner.paint.details.tucking import covered_ear_shares, ear_masks, press_ears_to_head
from cloner.parallel import parallel_map
from cloner.records.arrays import Array
from cloner.records.clones import Joined

#: Beside an ear's outline its label is the hair's still: heads stand so far off their photos, mm.
BESIDE_MM: Final = 4.0


def press_ears(generic: GenericHuman, joined: Joined, views: list[HairView]) -> tuple[Joined, list[HairView]]:
    """Return the person with ears pressed to the head where photos show hair over them, and new views.

    What stands out of the head elsewhere is an ear in a back photo too.
    """
    ears = np.flatnonzero(np.any(ear_masks(generic), axis=0))
    normals = vertex_normals(joined.vertices_m, body_triangles())
    covered = np.zeros(len(joined.vertices_m))
    covered[ears] = covered_share(views, joined.vertices_m[ears], normals[ears])
    below = covered_ear_shares(generic, covered)
    bare = [ear for ear in ear_masks(generic) if not below[ear].any()]
    views = [without_ears(view, joined.vertices_m, bare) for view in views] if bare else views
    laid = press_ears_to_head(generic, joined.vertices_m, below)
    if laid is joined.vertices_m:
        return joined, views
    joined = replace(joined, vertices_m=laid)
    return joined, with_new_depth(generic, joined, views)


def without_ears(view: HairView, vertices_m: Array, ears: list[NDArray[np.bool_]]) -> HairView:
    """Return a back photo's view without hair where bare ears stand out; any other view unchanged.

    From behind an ear is a narrow rim of skin beside hair, which labels miss: hair behind it would be as wide as it.
    """
    if view.posed.view is not ViewId.BODY_BACK:
        return view
    triangles = body_triangles()
    own = np.any(ears, axis=0)[triangles].all(axis=1)
    standing = covered_by_surface(view, vertices_m, triangles[own]) & ~covered_by_surface(
        view, vertices_m, triangles[~own]
    )
    reach = 2 * int(np.ceil(BESIDE_MM / view.pixel_mm(view.to_view(vertices_m[np.any(ears, axis=0)])))) + 1
    height, width = view.hair.shape
    wide = cv2.resize(standing.astype(np.uint8), (width, height), interpolation=cv2.INTER_NEAREST)
    hair = view.hair & (cv2.dilate(wide, np.ones((reach, reach), np.uint8)) == 0)
    if np.array_equal(hair, view.hair):
        return view
    hair, to_hair, to_line, to_person = distances_px(hair, view.outline_px > 0.0)
    return replace(view, hair=hair, hair_px=to_hair, line_px=to_line, outline_px=to_person)


def with_new_depth(generic: GenericHuman, joined: Joined, views: list[HairView]) -> list[HairView]:
    """Return the views with depth pictures of a person whose vertices were moved, in the same poses."""
    straight = [view for view in views if view.flip_m is None]
    depths = parallel_map(lambda view: body_depth_m(generic, joined, view.posed, view.clothed), straight)
    nearest = {view.posed.view: depth for view, depth in zip(straight, depths, strict=True)}
    return [replace(view, nearest_m=nearest[view.posed.view]) for view in views]
