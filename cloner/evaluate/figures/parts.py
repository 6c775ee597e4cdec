"""Texels that show another part of the person than the one they lie on."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.evaluate.figures.origins import TexelOrigins
from cloner.evaluate.truths.kit import KitTruth
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.cameras.visibility import compute_visibility, depth_at, depth_picture
from cloner.records.arrays import Array
from cloner.records.labels import LABELS
from cloner.records.views import Camera
from cloner.vision.retouching.repair import spread_nearest

Flags = NDArray[np.bool_]

#: A border may lie this far off before its texels count: what misses by more is a streak and no seam (taste).
NEAR_M: Final = 0.010
#: The border between the skin of head and neck follows vertices, and eyes and mouth are no texels: one part each.
_SAME: Final = dict.fromkeys(("face_skin", "eyes", "mouth"), "body_skin")
#: Limbs whose colours must not lie on each other.
_LIMBS: Final = (("left_upper_arm", "left_forearm", "left_hand"), ("right_upper_arm", "right_forearm", "right_hand"))


def wrong_part_share(origins: TexelOrigins, generic: GenericHuman, kit: KitTruth) -> float | None:
    """Return the share of judged texels that show another part of the person.

    Parameters
    ----------
    origins : Origins
    generic : GenericHuman
    kit : KitTruth

    Notes
    -----
    A texel is judged where a photo, also a held-out one, truly shows its place on the body. It is wrong when the label
    of the pixel it came from is none that the photos show within `NEAR_M` of its true place, or when that pixel shows
    an arm and the texel lies on no arm within that distance, or the other way round. A face is skin also where every
    photo shows hair or a thing before it: what hangs there is a surface of its own.

    Returns
    -------
    float or None
        None when nothing could be judged.
    """
    body = len(next(iter(kit.bodies_m.values())))
    on_body: Flags = np.asarray((origins.vertices < body).all(axis=1), bool)
    pixel = np.rint(origins.pixel_px).astype(int)
    allowed, judged = _true_labels(origins, kit, on_body)
    corners = np.where(on_body[:, None], origins.vertices, 0)
    allowed = allow_skin_behind(allowed, np.asarray(generic.region("face")[corners].all(axis=1), bool))
    wrong = np.zeros(len(pixel), bool)
    for row, view in enumerate(origins.views):
        truth = kit.truth.views[view.value]
        own = np.flatnonzero(judged & (origins.view == row))
        if not own.size:
            continue
        height, width = truth.mask.shape
        column, line = np.clip(pixel[own, 0], 0, width - 1), np.clip(pixel[own, 1], 0, height - 1)
        # beyond the outline the painter takes the nearest colour inside: leaks of the room have their own figure
        labels = kit.labels[view.value]
        shown = _part_of_label()[spread_nearest(labels[..., None], labels > 0)[line, column, 0]]
        strange = (allowed[own] >> shown) & 1 == 0
        limbs = _limb_pictures(generic, kit.bodies_m[view.value], truth.camera)
        strange |= _wrong_limb(limbs, origins, own, generic)
        wrong[own] = strange
    return float(wrong[judged].mean()) if judged.any() else None


def _part_of_label() -> NDArray[np.int64]:
    """Return for every label the one that represents its part."""
    return np.array([LABELS.index(_SAME.get(name, name)) for name in LABELS])


def _true_labels(origins: TexelOrigins, kit: KitTruth, on_body: Flags) -> tuple[NDArray[np.int64], Flags]:
    """Return (N,) the labels near each texel's true place as bits, and whether any photo shows that place."""
    bits, seen = np.zeros(len(on_body), np.int64), np.zeros(len(on_body), bool)
    triangles = body_triangles()
    rows = np.flatnonzero(on_body)
    for view, labels in kit.labels.items():
        camera, body_m = kit.truth.views[view].camera, kit.bodies_m[view]
        visibility = compute_visibility(body_m, triangles, camera)
        table = np.column_stack([visibility.pixel_px, visibility.depth_m, visibility.cosine])
        values = np.einsum("nk,nkc->nc", origins.barycentric[rows], table[origins.vertices[rows]])
        visible = visibility.visible(values[:, :2], values[:, 2], values[:, 3])
        found, place = rows[visible], np.rint(values[visible, :2]).astype(int)
        height, width = labels.shape
        inside = (place >= 0).all(axis=1) & (place < (width, height)).all(axis=1)
        found, place = found[inside], place[inside]
        bits[found] |= _dilated_label_bits(labels, camera, body_m)[place[:, 1], place[:, 0]]
        seen[found] = True
    return bits, seen


def allow_skin_behind(allowed: NDArray[np.int64], face: Flags) -> NDArray[np.int64]:
    """Return the label bits near each texel, with skin added where a face (N,) is seen behind hair or accessories
    alone.
    """
    hanging = (1 << LABELS.index("hair")) | (1 << LABELS.index("accessory"))
    hidden = face & (allowed > 0) & (allowed & ~hanging == 0)
    return np.where(hidden, allowed | (1 << LABELS.index("body_skin")), allowed)


def _dilated_label_bits(labels: NDArray[np.uint8], camera: Camera, body_m: Array) -> NDArray[np.int64]:
    """Return as bits (H, W) the labels within `NEAR_M` of every pixel; the background is never a part."""
    reach = NEAR_M / camera.metres_per_pixel(body_m.mean(axis=0))
    merged, bits = _part_of_label()[labels], np.zeros(labels.shape, np.int64)
    for label in np.unique(merged):
        if label > 0:
            away = cv2.distanceTransform((merged != label).astype(np.uint8), cv2.DIST_L2, 5)
            bits |= (away <= reach).astype(np.int64) << int(label)
    return bits


def _limb_pictures(generic: GenericHuman, body_m: Array, camera: Camera) -> tuple[list[NDArray[np.float32]], float]:
    """Return the depth pictures of left arm, right arm and the rest, and pixels within `NEAR_M` in them."""
    triangles = body_triangles()
    limb = _limb_of_vertex(generic)[triangles]
    pictures = [depth_picture(body_m, triangles[(limb == k).all(axis=1)], camera) for k in (0, 1, 2)]
    return pictures, NEAR_M / camera.metres_per_pixel(body_m.mean(axis=0))


def _wrong_limb(
    limbs: tuple[list[NDArray[np.float32]], float], origins: TexelOrigins, own: NDArray[np.intp], generic: GenericHuman
) -> Flags:
    """Return which of the texels took an arm's pixel and lie elsewhere, or lie on an arm and took another's."""
    pictures, near_px = limbs
    depth = np.stack(pictures)
    owner = np.where(np.isfinite(depth.min(axis=0)), depth.argmin(axis=0), -1)
    limb = _limb_of_vertex(generic)[origins.vertices[own]]
    whole = (limb == limb[:, :1]).all(axis=1)
    wanted = limb[:, 0].copy()
    swapped = origins.mirrored[own] & (wanted < 2)
    wanted[swapped] = 1 - wanted[swapped]
    wrong = np.zeros(len(own), bool)
    pixel = origins.pixel_px[own]
    for k in (0, 1, 2):
        # a limb that is nowhere seen is as far as the picture is large, not 3e38
        away = np.minimum(cv2.distanceTransform((owner != k).astype(np.uint8), cv2.DIST_L2, 5), sum(owner.shape))
        asked = np.flatnonzero(whole & (wanted == k))
        # depth pictures are half the photo's size; clothes stand out of the naked body: there no limb is known
        gap = depth_at(2.0 * away.astype(np.float32), pixel[asked])
        shown = depth_at(owner.astype(np.float32), pixel[asked])
        wrong[asked] = (shown >= 0.0) & (shown != k) & (gap > near_px)
    return wrong


def _limb_of_vertex(generic: GenericHuman) -> NDArray[np.int64]:
    """Return (V,) 0 for the left arm, 1 for the right, 2 for everything else."""
    limb = np.full(len(generic.vertex_segment), 2)
    for k, names in enumerate(_LIMBS):
        limb[generic.segment(*names)] = k
    return limb
