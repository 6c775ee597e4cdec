"""How much of a clone's texture shows the room instead of the person."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from skimage.color import deltaE_ciede2000, rgb2lab

from cloner.evaluate.rulers import OUTLINE_HEIGHT_PX
from cloner.evaluate.truth import TruthView
from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman
from cloner.geometry.atlas import AtlasMap
from cloner.geometry.seeing import look
from cloner.geometry.skinning import joint_transforms, skin
from cloner.records.bodies import PosedView
from cloner.records.clones import Clone

Array = NDArray[np.float64]

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


def person_colours(views: Iterable[TruthView]) -> cKDTree:
    """Return the person's colours (CIELAB) and their heights in photos of one framing, to be asked for the nearest.

    Photos of the body, or of the face: heights are shares of what a photo shows of the person.
    """
    found = []
    for view in views:
        row, column = np.nonzero(_signed_px(view.mask) > INSIDE_PX * len(view.mask) / OUTLINE_HEIGHT_PX)
        lab = rgb2lab(cv2.blur(view.photo, (3, 3))[row, column][None])[0]
        cells = np.column_stack([lab / CELL, _heights(view.mask, row) / HEIGHT_CELL])
        cells, count = np.unique(np.rint(cells).astype(np.int64), axis=0, return_counts=True)
        cells = cells[count >= LEAST_PX]
        found.append(_features(cells[:, :3] * CELL, cells[:, 3] * HEIGHT_CELL))
    return cKDTree(np.concatenate(found))


def _heights(mask: NDArray[np.bool_], row: NDArray[np.integer]) -> Array:
    """Return (N,) how high pixels' rows lie in the figure, 0..1."""
    rows = np.flatnonzero(mask.any(axis=1))
    return np.asarray((rows[-1] - row) / max(int(rows[-1] - rows[0]), 1), np.float64)


def _features(lab: Array, heights: Array) -> Array:
    return np.column_stack([lab, heights * (ALIKE / SPAN)])


def background_texels(clone: Clone, generic: GenericHuman, seen: PosedView, truth: TruthView, person: cKDTree) -> int:
    """Return the number of texels near one photo's outline that look like the wall beside them.

    A texel counts when its colour lies within ΔE2000 6 of what the photo shows just outside the true outline there,
    and farther than that from every colour the person has about there in any photo: a white shoe before a white wall
    is no leak.

    Parameters
    ----------
    clone : Clone
        Its body's texture is judged; hair shells are cut out by their own outlines.
    generic : GenericHuman
    seen : PosedView
        Camera and pose of the photo, as fitted.
    truth : TruthView
        Of that photo.
    person : cKDTree
        From :func:`person_colours` of the photos framed like this one.
    """
    atlas = generic_atlas(generic, len(clone.atlas.rgb), wanted=_body(generic))
    places, colours = _seen_beside(clone, generic, atlas, seen, truth)
    if not len(places):
        return 0
    lab = rgb2lab(colours[None])[0]
    asked = _features(lab, _heights(truth.mask, places[:, 1]))
    strange = np.flatnonzero(person.query(asked, distance_upper_bound=ALIKE)[0] > ALIKE)
    room = [rgb2lab(_outside_colours(truth, places[strange], depth)[None])[0] for depth in OUTSIDE_PX]
    away = np.min([deltaE_ciede2000(lab[strange], shown) for shown in room], axis=0)
    return int(np.count_nonzero(away < ALIKE))


def _body(generic: GenericHuman) -> NDArray[np.bool_]:
    triangles = generic.triangles()[0]
    return np.asarray(generic.vertex_part[triangles[:, 0]] == generic.part_names.index("body"), bool)


def _seen_beside(
    clone: Clone, generic: GenericHuman, atlas: AtlasMap, seen: PosedView, truth: TruthView
) -> tuple[NDArray[np.int64], NDArray[np.uint8]]:
    """Return (N, 2) pixels and (N, 3) colours of the texels that the camera sees near the true outline."""
    transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), seen.rotations)
    posed = skin(
        clone.vertices_m, transforms, generic.skin_joints.astype(np.int32), generic.skin_weights.astype(np.float64)
    )
    sight = look(posed, atlas.triangles, seen.camera)
    table = np.column_stack([sight.pixel_px, sight.depth_m, sight.cosine])
    values = atlas.interpolate(table)
    height, width = truth.mask.shape
    column, row = np.rint(values[:, :2]).astype(np.int64).T
    inside = (column >= 0) & (row >= 0) & (column < width) & (row < height)
    near = np.zeros(len(values), bool)
    signed = _signed_px(truth.mask)
    near[inside] = np.abs(signed[row[inside], column[inside]]) < NEAR_PX * height / OUTLINE_HEIGHT_PX
    near &= sight.visible(values[:, :2], values[:, 2], values[:, 3])
    places = np.stack([column[near], row[near]], axis=1)
    return np.clip(places, 0, (width - 1, height - 1)), clone.atlas.rgb.reshape(-1, 3)[atlas.texel[near]]


def _outside_colours(truth: TruthView, places: NDArray[np.int64], depth_px: float) -> NDArray[np.uint8]:
    """Return (N, 3) the photo's colours at the nearest pixels this far outside the true outline."""
    known = _signed_px(truth.mask) < -depth_px * len(truth.mask) / OUTLINE_HEIGHT_PX
    _, labels = cv2.distanceTransformWithLabels(
        (~known).astype(np.uint8), cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
    )
    soft = cv2.blur(truth.photo, (3, 3))  # noise of single pixels is nobody's colour
    colour_of = np.zeros((int(labels.max()) + 1, 3), np.uint8)
    colour_of[labels[known]] = soft[known]
    return np.asarray(colour_of[labels[places[:, 1], places[:, 0]]], np.uint8)


def _signed_px(mask: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (H, W) distances to the outline, px, positive inside."""
    inner, outer = (cv2.distanceTransform(part.astype(np.uint8), cv2.DIST_L2, 5) for part in (mask, ~mask))
    return np.asarray(inner - outer, np.float32)
