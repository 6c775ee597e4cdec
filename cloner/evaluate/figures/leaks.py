"""Background colours in a clone's texture."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from skimage.color import deltaE_ciede2000, rgb2lab

from cloner.evaluate.measures.posing import pose_clone
from cloner.evaluate.measures.rulers import OUTLINE_HEIGHT_PX
from cloner.evaluate.truths.truth import TruthView
from cloner.frames import ViewId
from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman
from cloner.geometry.cameras.visibility import compute_visibility
from cloner.geometry.charts.atlas import AtlasMap
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Clone
from cloner.vision.retouching.repair import spread_nearest

#: Texels this near to a true outline are judged, px in a photo of `OUTLINE_HEIGHT_PX`.
NEAR_PX: Final = 25.0
#: Colours as near as this to the room's are the room's (the issue's bar).
ALIKE: Final = 6.0
#: Depths outside the true outline whose colours are the room's there, px; nearer ones are mixed by the lens.
OUTSIDE_PX: Final = (4.0, 10.0)
#: Pixels this deep inside the true outline show the person alone, px.
INSIDE_PX: Final = 6.0
#: Cells of Lab and of the height, share of the figure, in which a person's colours are collected.
CELL: Final = 3.0
HEIGHT_CELL: Final = 0.04
#: Fewer pixels of a photo in a cell are noise.
LEAST_PX: Final = 10
#: Shoes excuse no calf: this far off in height, share of the figure, counts as much as colours just unlike.
SPAN: Final = 0.08


def background_texels(clone: Clone, generic: GenericHuman, photos: Mapping[ViewId, TruthView]) -> dict[ViewId, int]:
    """Return the number of texels near each photo's outline that look like the wall beside them.

    A texel counts when its colour lies within ΔE2000 6 of what the photo shows just outside the true outline there,
    and farther than that from every colour the person has about there in any photo: a white shoe before a white wall
    is no leak.

    Parameters
    ----------
    clone : Clone
        Its body's texture is judged, in the poses fitted to the photos; hair shells are cut out by their own outlines.
    generic : GenericHuman
    photos : mapping of ViewId to TruthView
        Of one framing, the body or the face: heights are shares of what a photo shows of the person.
    """
    judged = {view: _TruthWithDistances(photo, _signed_px(photo.mask)) for view, photo in photos.items()}
    person = cKDTree(np.concatenate([_person_colours(each) for each in judged.values()]))
    atlas = generic_atlas(generic, len(clone.atlas.rgb), wanted=_body_triangles(generic))
    return {view: _count(clone, generic, atlas, clone.views[view], each, person) for view, each in judged.items()}


@dataclass(frozen=True, slots=True, eq=False)
class _TruthWithDistances:
    """The truth of one photo, and (H, W) distances to its outline, px, positive inside."""

    truth: TruthView
    signed_px: NDArray[np.float32]

    @property
    def scale(self) -> float:
        """Pixels of the photo that make one of a photo of `OUTLINE_HEIGHT_PX`."""
        return len(self.truth.mask) / OUTLINE_HEIGHT_PX


def _person_colours(judged: _TruthWithDistances) -> Array:
    """Return (N, 4) the colours a photo shows of the person and their heights, to be asked for the nearest."""
    truth = judged.truth
    row, column = np.nonzero(judged.signed_px > INSIDE_PX * judged.scale)
    lab = rgb2lab(cv2.blur(truth.photo, (3, 3))[row, column][None])[0]
    cells = np.column_stack([lab / CELL, _heights(truth.mask, row) / HEIGHT_CELL])
    cells, count = np.unique(np.rint(cells).astype(np.int64), axis=0, return_counts=True)
    cells = cells[count >= LEAST_PX]
    return _features(cells[:, :3] * CELL, cells[:, 3] * HEIGHT_CELL)


def _heights(mask: NDArray[np.bool_], row: NDArray[np.integer]) -> Array:
    """Return (N,) how high pixels' rows lie in the figure, 0..1."""
    rows = np.flatnonzero(mask.any(axis=1))
    return np.asarray((rows[-1] - row) / max(int(rows[-1] - rows[0]), 1), np.float64)


def _features(lab: Array, heights: Array) -> Array:
    return np.column_stack([lab, heights * (ALIKE / SPAN)])


def _count(
    clone: Clone, generic: GenericHuman, atlas: AtlasMap, seen: PosedView, judged: _TruthWithDistances, person: cKDTree
) -> int:
    """Return the number of texels near one photo's outline that look like the wall beside them."""
    places, colours = _texels_near_outline(clone, generic, atlas, seen, judged)
    if not len(places):
        return 0
    lab = rgb2lab(colours[None])[0]
    asked = _features(lab, _heights(judged.truth.mask, places[:, 1]))
    strange = np.flatnonzero(person.query(asked, distance_upper_bound=ALIKE)[0] > ALIKE)
    column, row = places[strange].T
    soft = cv2.blur(judged.truth.photo, (3, 3))  # noise of single pixels is nobody's colour
    away = np.full(len(strange), np.inf)
    for depth in OUTSIDE_PX:
        room = spread_nearest(soft, judged.signed_px < -depth * judged.scale)[row, column]
        away = np.minimum(away, deltaE_ciede2000(lab[strange], rgb2lab(room[None])[0]))
    return int(np.count_nonzero(away < ALIKE))


def _body_triangles(generic: GenericHuman) -> NDArray[np.bool_]:
    triangles = generic.triangles()[0]
    return generic.skin[triangles[:, 0]]


def _texels_near_outline(
    clone: Clone, generic: GenericHuman, atlas: AtlasMap, seen: PosedView, judged: _TruthWithDistances
) -> tuple[NDArray[np.int64], NDArray[np.uint8]]:
    """Return pixels (N, 2) and colours (N, 3) of the texels that the camera sees near the true outline."""
    visibility = compute_visibility(pose_clone(clone, generic, seen.rotations).vertices_m, atlas.triangles, seen.camera)
    values = atlas.interpolate(np.column_stack([visibility.pixel_px, visibility.depth_m, visibility.cosine]))
    height, width = judged.truth.mask.shape
    column, row = np.rint(values[:, :2]).astype(np.int64).T
    inside = (column >= 0) & (row >= 0) & (column < width) & (row < height)
    near = np.zeros(len(values), bool)
    near[inside] = np.abs(judged.signed_px[row[inside], column[inside]]) < NEAR_PX * judged.scale
    near &= visibility.visible(values[:, :2], values[:, 2], values[:, 3])
    return np.stack([column[near], row[near]], axis=1), clone.atlas.rgb.reshape(-1, 3)[atlas.texel[near]]


def _signed_px(mask: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (H, W) distances to the outline, px, positive inside."""
    inner, outer = (cv2.distanceTransform(part.astype(np.uint8), cv2.DIST_L2, 5) for part in (mask, ~mask))
    return np.asarray(inner - outer, np.float32)
