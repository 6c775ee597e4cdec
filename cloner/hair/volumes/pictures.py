"""Images of hair, and of what covers it, in one photo."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.cameras.visibility import depth_picture
from cloner.hair.volumes.headwear import headwear
from cloner.paint.lookups.posed import posed_vertices
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.labels import Label
from cloner.records.proposals import Proposal
from cloner.vision.retouching.repair import nearest_known, signed_distance
from cloner.vision.segmentation.pieces import box_around, connected_pieces

SMALLEST_PIECE = 0.08  # of the largest hair area: brows and specks are smaller
LARGEST_HOLE = 0.02  # of the hair: a nape between two locks that meet below it is larger (taste)
FAR_MM = 1000.0  # stands for "no hair anywhere near"
NEAR_SHARE = 0.6  # distances are told within this share of the hair's size around it
#: One thing's colour varies by so many times its spread (robust deviation in CIELAB, within these bounds): light and
#: folds change lightness more than hue.
DEVIATIONS = 3.0
LEAST_SPREAD = (6.0, 2.5, 2.5)
MOST_SPREAD = (16.0, 6.0, 6.0)


def clean_hair(proposal: Proposal, person: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of hair or a cap: labelled so, on the person, in components of some size."""
    hair = ((proposal.labels == Label.HAIR) | headwear(proposal.labels)) & person
    small = cv2.morphologyEx(hair.astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    box, pieces, figures = connected_pieces(small)
    area = figures[:, cv2.CC_STAT_AREA].astype(float)
    area[0] = 0.0
    kept = np.zeros(hair.shape, np.bool_)
    if area.any():
        kept[box] = (area >= SMALLEST_PIECE * area.max())[pieces]
        if proposal.view is ViewId.BODY_BACK:
            kept[box] = fill_small_holes(kept[box])
    return kept


def fill_small_holes(hair: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return hair or cloth (H, W) without small holes: they are highlights and dots, neither ear nor face."""
    _, pieces, figures, _ = cv2.connectedComponentsWithStats((~np.pad(hair, 1)).astype(np.uint8), connectivity=4)
    small = figures[:, cv2.CC_STAT_AREA] < LARGEST_HOLE * np.count_nonzero(hair)
    small[[0, pieces[0, 0]]] = False  # the hair itself, and what lies around it
    return np.asarray(hair | small[pieces[1:-1, 1:-1]], np.bool_)


def similar_colours(rgb: NDArray[np.uint8], seed: NDArray[np.bool_], blur_px: float) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of a photo (H, W, 3) with the colours of the seed (H, W), after a blur."""
    smooth = cv2.GaussianBlur(rgb, (0, 0), max(blur_px, 0.5))
    colour = cv2.cvtColor(smooth.astype(np.float32) / 255.0, cv2.COLOR_RGB2LAB)
    middle = np.median(colour[seed], axis=0)
    spread = np.clip(1.4826 * np.median(np.abs(colour[seed] - middle), axis=0), LEAST_SPREAD, MOST_SPREAD)
    return np.asarray((np.abs(colour - middle) < DEVIATIONS * spread).all(axis=2))


def distances_px(
    hair: NDArray[np.bool_], person: NDArray[np.bool_]
) -> tuple[NDArray[np.bool_], NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
    """Return hair, and the signed distances (H, W) to its outline, to the hairline and to the person's outline, px.

    They are counted around the hair only: most of a body photo is far from it.
    """
    to_hair, to_hairline, to_person = (np.full(hair.shape, -FAR_MM, np.float32) for _ in range(3))
    if hair.any():
        longest = max(side.stop - side.start for side in box_around(hair)) - 1
        box = box_around(hair, int(NEAR_SHARE * longest) + 2)
        to_hair[box] = signed_distance(hair[box])
        to_hairline[box] = hairline(hair[box], person[box])
        to_person[box] = signed_distance(person[box])
    return hair, to_hair, to_hairline, to_person


def hairline(hair: NDArray[np.bool_], person: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return the signed distance (H, W) to the hairline, px, background taken as the person's nearest pixel."""
    if not hair.any():
        return signed_distance(hair)
    to_hair = cv2.distanceTransform((~hair).astype(np.uint8), cv2.DIST_L2, 3)
    to_other = cv2.distanceTransform((hair | ~person).astype(np.uint8), cv2.DIST_L2, 3)
    return np.asarray(to_other - to_hair, np.float32)


def body_depth_m(
    generic: GenericHuman, joined: Joined, posed: PosedView, clothed: NDArray[np.bool_]
) -> NDArray[np.float32]:
    """Return the depth picture (h, w) of a body in a photo, extended over clothes (H, W) beside it."""
    return extend_over_clothes(
        depth_picture(posed_vertices(generic, joined, posed), body_triangles(), posed.camera), clothed
    )


def extend_over_clothes(nearest_m: NDArray[np.float32], clothed: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return a depth picture (h, w), inf where empty, extended over clothes (H, W) at the depth nearby.

    A shoulder larger than the fitted one hides hair too; thin hair that hangs behind it was told to be none.
    """
    bare, size = np.isinf(nearest_m), (nearest_m.shape[1], nearest_m.shape[0])
    beyond = bare & (cv2.resize(clothed.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0)
    if not beyond.any() or bare.all():
        return nearest_m
    found = nearest_m.copy()
    found[beyond] = nearest_known(nearest_m, ~bare, beyond)
    return found
