"""The figures of one way to leave a step of the method out: outlines, body, head, and places in the photos."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

import numpy as np
from body_scores import HELD_OUT, KnownTruth, below_head_overlap, body_clone, drawn_mask, placed
from head_scores import ruler, score
from numpy.typing import NDArray

from cloner.detectors.face.face_net import load_face_net
from cloner.evaluate.kit_scores import joint_error_mm
from cloner.evaluate.measures import rulers
from cloner.evaluate.measures.posing import moved_camera
from cloner.evaluate.truths.kit import KitTruth
from cloner.frames import BODY_VIEWS, MILLIMETRES_PER_METRE, ViewId
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.paint.lookups.sources import Source
from cloner.records.labels import LABELS
from cloner.vision.contours.snake import normals

Array = NDArray[np.float64]
Values = Mapping[str, Any]
Figures = dict[str, float]

#: Labels that show a head: what no step of the body answers for.
HEAD: Final = tuple(LABELS.index(name) for name in ("face_skin", "hair", "eyes", "mouth", "beard"))
#: Sights more slanting than this are not asked where they put a texel.
LEAST_COSINE: Final = 0.3


def known_truth(kit: KitTruth) -> KnownTruth:
    """Return what is true of a person of the generator, as the rulers of bodies take it."""
    views = {name: view for name, view in kit.truth.views.items() if name in (*BODY_VIEWS, HELD_OUT)}
    heads = {name: np.isin(kit.labels[name], HEAD) for name in views}
    return KnownTruth(kit.truth.stature_m, kit.truth.girths_mm, {}, kit.truth.surface, views, heads, {}, {})


def outline_figures(values: Values, kit: KitTruth) -> Figures:
    """Return how far the body's outlines lie from the true ones, pixels of photos 1,800 px high, and their overlap."""
    away, overlap = [], []
    for view in BODY_VIEWS:
        if view in values["silhouettes"].views:
            mask, true = values["silhouettes"].views[view].mask, kit.truth.views[view].mask
            away.append(rulers.summarise(rulers.outline_distances_px(mask, true)).mean * 1800.0 / len(true))
            overlap.append(rulers.mask_iou(mask, true))
    return {"outline px": float(np.mean(away)), "outline IoU": float(np.mean(overlap))}


def body_figures(values: Values, kit: KitTruth) -> Figures:
    """Return overlaps below the head in the photos and from 45 degrees, and how far joints lie from the true ones."""
    body, found, generic, truth = values["body"], values["phenotype"], load_generic(), known_truth(kit)
    clone = body_clone(generic, body.mesh.vertices_m, body.mesh.joints_m, body.views, found.stature_m, found.sole_m)
    shown = [view for view in BODY_VIEWS if view in body.views]
    inputs = [
        below_head_overlap(drawn_mask(clone, body.views[view].camera, body.views[view].rotations), truth, view)
        for view in shown
    ]
    rotations, truth_from_clone = placed(clone, generic, truth)
    mask = drawn_mask(clone, moved_camera(truth.views[HELD_OUT].camera, truth_from_clone), rotations)
    return {
        "input IoU": float(np.mean(inputs)),
        "45 degrees IoU": below_head_overlap(mask, truth, HELD_OUT),
        "joints mm": float(np.mean([joint_error_mm(clone, generic, kit, view) for view in shown])),
    }


def head_figures(values: Values, kit: KitTruth) -> Figures:
    """Return how far the face's surface (size free) and landmarks lie from the true ones."""
    generic = load_generic()
    whole = np.array(generic.vertices_m, np.float64)
    whole[generic.head_vertices] = values["head"].vertices_m
    found = score(whole, ruler(kit.truth.surface), generic)
    return {"face mm": found["similarity_mm"], "landmarks mm": found["landmarks_mean_mm"]}


def curve_figures(values: Values, kit: KitTruth) -> Figures:
    """Return how far lids and lips of the front photo lie beside their true curves, percent between the irises."""
    proposal = values["proposals"].views[ViewId.FACE_FRONT]
    if proposal.face_presence == 0.0:
        return {}
    net, camera = load_face_net(), kit.truth.views[ViewId.FACE_FRONT].camera
    true_px = camera.project(net.places.at(kit.whole_m(ViewId.FACE_FRONT)))
    apart = float(np.linalg.norm(proposal.irises_px[0] - proposal.irises_px[1]))
    beside = []
    for curve in net.curves.values():
        found, true = curve @ proposal.face_px, curve @ true_px
        beside.append(np.abs(np.einsum("ni,ni->n", found - true, normals(true, closed=False))))
    return {"lids and lips %": 100.0 * float(np.concatenate(beside).mean()) / apart}


def apart_mm(sources: list[Source], kit: KitTruth) -> float | None:
    """Return how far apart face photos lie on the skin: median over texels that front and side both show."""
    shown = {source.view: source for source in sources if not source.mirrored}
    pair = [shown.get(view) for view in (ViewId.FACE_FRONT, ViewId.FACE_SIDE)]
    if pair[0] is None or pair[1] is None:
        return None
    both = [one for one in pair if one is not None]
    generic = load_generic()
    rows = generic.region("face") & generic.skin
    for one in both:
        rows &= (one.score > 0.0) & (one.visibility.cosine > LEAST_COSINE)
    rows[kit.bodies_m[ViewId.FACE_FRONT].shape[0] :] = False
    if rows.sum() < 50:
        return None
    errors = [_error_on_skin(one, kit, np.flatnonzero(rows)) for one in both]
    return MILLIMETRES_PER_METRE * float(np.median(np.linalg.norm(errors[0] - errors[1], axis=1)))


def _error_on_skin(source: Source, kit: KitTruth, rows: NDArray[np.int64]) -> Array:
    """Return how far from its own true place each vertex finds its colour, (N, 2) metres along and across the skin.

    Both directions belong to the head, so that errors of two photos may be compared.
    """
    camera, whole = kit.truth.views[source.view].camera, kit.whole_m(source.view)
    normals = vertex_normals(whole, body_triangles())[rows]
    head = _head_axes(whole)
    along = np.cross(normals, head[2])
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    across = np.cross(normals, along)
    at, step = camera.project(whole[rows]), 1e-3
    by = np.stack([(camera.project(whole[rows] + step * way) - at) / step for way in (along, across)], axis=2)
    return np.asarray(np.linalg.solve(by, (source.lookup_px[rows] - at)[:, :, None])[:, :, 0])


def _head_axes(whole_m: Array) -> Array:
    """Return the head's own axes (3, 3) in a photo's pose: from right to left eye, forward, up."""
    generic = load_generic()
    left, right, chin = (whole_m[generic.feature(name)] for name in ("eye_outer_L", "eye_outer_R", "chin_bottom"))
    x = (left - right) / np.linalg.norm(left - right)
    up = (left + right) / 2.0 - chin
    up -= (up @ x) * x
    up /= np.linalg.norm(up)
    return np.stack([x, np.cross(up, x), up])
