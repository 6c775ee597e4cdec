"""Hair that one photo loses before a wall of its colour, restored from the photo of the opposite side."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.hair.volumes.pictures import FAR_MM, distances_px, similar_colours
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array
from cloner.records.photos import Photo
from cloner.vision.retouching.aligning import sample
from cloner.vision.segmentation.pieces import box_around, connected_pieces

SURE_MM = 10.0  # so deep in the other photo's outline: heads turn between photos, and perspective widens what is near
STEP_MM = 2.0  # apart, what is asked
BLUR_MM = 3.0  # colours are told over so much: a lock, no single hair


def restore_lost_hair(views: list[HairView], photos: Mapping[ViewId, Photo], middle_m: Array) -> list[HairView]:
    """Return the views with hair where a front or back photo shows a similar wall, and the opposite one a person.

    From before and behind one sees the same outline. Where they contradict each other, who stands before a wall of
    another colour is right.

    Parameters
    ----------
    views : list of HairView
    photos : mapping of ViewId to Photo
    middle_m : (3,)
        The head's middle at rest, through which the outline is taken to run.
    """
    found = []
    for view in views:
        name = view.posed.view
        others = [one for one in views if not one.posed.view.is_side and one.posed.view.is_front != name.is_front]
        if others and not name.is_side and view.hair.any():
            lost = lost_hair(view, photos[name].rgb, others, middle_m)
            if lost.any():
                whole = distances_px(view.hair | lost, (view.outline_px > 0.0) | lost)
                view = replace(view, hair=whole[0], hair_px=whole[1], line_px=whole[2], outline_px=whole[3])
        found.append(view)
    return found


def lost_hair(view: HairView, rgb: NDArray[np.uint8], others: list[HairView], middle_m: Array) -> NDArray[np.bool_]:
    """Return the background pixels (H, W) that look like hair and are the person to all opposite photos.

    Parameters
    ----------
    view : HairView
    rgb : (H, W, 3) uint8
        Its photo.
    others : list of HairView
        Photos from the opposite side.
    middle_m : (3,) of the head, at rest
    """
    middle = view.to_view(middle_m[None])
    scale = view.pixel_mm(middle)
    air = (view.outline_px <= 0.0) & (view.outline_px > -FAR_MM)
    lost, box = np.zeros(air.shape, np.bool_), box_around(air | view.hair)
    asked = air[box] & similar_colours(rgb[box], view.hair[box], BLUR_MM / scale)
    step = max(round(STEP_MM / scale), 1)
    coarse = np.argwhere(asked[::step, ::step])
    if not len(coarse):
        return lost
    pixels = step * coarse[:, ::-1].astype(np.float64) + (box[1].start, box[0].start)
    points = view.to_rest(view.posed.camera.back_project(pixels, np.repeat(middle, len(pixels), axis=0)))
    inside_all, judged = np.ones(len(points), np.bool_), np.zeros(len(points), np.bool_)
    for other in others:
        there = other.to_view(points)
        inside = sample(other.outline_px, other.posed.camera.project(there))[:, 0] * other.pixel_mm(there)
        inside_all &= np.isnan(inside) | (inside > SURE_MM)  # NaN outside the picture
        judged |= ~np.isnan(inside)
    small = np.zeros(asked[::step, ::step].shape, np.uint8)
    small[tuple(coarse[inside_all & judged].T)] = 1
    small = cv2.morphologyEx(small, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    size = asked.shape[1], asked.shape[0]
    lost[box] = (cv2.resize(small, size, interpolation=cv2.INTER_NEAREST) > 0) & asked
    return lost & _joined_pieces(view.hair, lost)


def _joined_pieces(hair: NDArray[np.bool_], lost: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the components (H, W) of both that contain hair: sleeves of its colour do not."""
    box, pieces, _ = connected_pieces(hair | lost)
    found = np.zeros(hair.shape, np.bool_)
    found[box] = np.isin(pieces, np.unique(pieces[hair[box]]))
    return found
