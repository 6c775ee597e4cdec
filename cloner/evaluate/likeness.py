"""How a clone looks: silhouettes and pictures through known cameras, and its texture's seams."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.evaluate.posing import (
    joints_by_truth_name,
    landmarks,
    moved_camera,
    pose_clone,
    rotations_towards,
    truth_from_body,
    truth_from_points,
)
from cloner.evaluate.rulers import overlap, picture_similarity, seam_ratio
from cloner.evaluate.truth import TruthView
from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import surface_normals
from cloner.records.clones import Clone
from cloner.records.views import Camera
from cloner.render import render, render_mask

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

#: Share of a unit normal along z from which a surface counts as clearly front or back; taste.
_CLEARLY: Final = 0.35


def seen_as_photo(subject: Clone, clone: Clone, generic: GenericHuman, view: ViewId, mask: Mask) -> float | None:
    """Return the silhouette IoU of a subject in the pose and camera fitted to a photo.

    Parameters
    ----------
    subject : Clone
        The clone itself, or a baseline that stands in its place: its main
        joints, in the same pose, are laid rigidly on the clone's.
    clone : Clone
        Whose ``views`` are used.
    mask : (H, W) bool
        The true silhouette.

    Returns
    -------
    float or None
        None when the clone has no fit for that photo.
    """
    seen = clone.views.get(view)
    if seen is None:
        return None
    camera = seen.camera
    if subject is not clone:
        own, goal = (
            joints_by_truth_name(pose_clone(who, generic, seen.rotations), generic) for who in (subject, clone)
        )
        camera = moved_camera(camera, truth_from_points(own, goal))
    return overlap(render_mask(subject, camera, seen.rotations), mask)


def held_out_camera(subject: Clone, rotations: Array, generic: GenericHuman, truth: TruthView) -> Camera:
    """Return the truth's camera in a subject's model frame.

    Parameters
    ----------
    subject : Clone
    rotations : (94, 3) float64
        The subject in the pose of the photo.
    truth : TruthView
        A view no clone ever saw. Bodies are laid on the truth's joints, faces
        on its landmarks, rigidly.
    """
    posed = pose_clone(subject, generic, rotations)
    if truth.name.startswith("face"):
        return moved_camera(truth.camera, truth_from_points(landmarks(posed.features_m), landmarks(truth.points_m)))
    return moved_camera(truth.camera, truth_from_body(posed, generic, truth.joints_m, truth.points_m))


def held_out_likeness(
    subject: Clone, start: Array, generic: GenericHuman, truth: TruthView
) -> tuple[dict[str, float], NDArray[np.uint8]]:
    """Return silhouette IoU, SSIM and ΔE2000 in a held-out view, and the picture.

    Parameters
    ----------
    subject, generic, truth
        As in :func:`held_out_camera`.
    start : (94, 3) float64
        Pose of the front photo.

    Notes
    -----
    goals.md asks for the photo's pose. A front photo does not tell how far the
    arms hang forward, so the subject is first brought to the truth's joints by
    rotations, the baselines in the same way.
    """
    rotations = rotations_towards(subject, generic, truth.joints_m, truth.points_m, start)
    camera = held_out_camera(subject, rotations, generic, truth)
    mask = render_mask(subject, camera, rotations)
    picture = render(subject, camera, rotations, shading="photo")
    similar, difference = picture_similarity(picture, mask, truth.photo, truth.mask)
    return {"silhouette_iou": overlap(mask, truth.mask), "ssim": similar, "delta_e": difference}, picture


def seam_ratios(clone: Clone, generic: GenericHuman) -> dict[str, float | None]:
    """Return the colour jump across three borders relative to inside the surface.

    Returns
    -------
    dict
        ``front_back`` (where the rest pose's normals turn from front to back),
        ``head_body`` (neck) and ``face_front_side`` (normals 45° from the front).

    Notes
    -----
    Edges beside another region are left out on both sides of the ratio: a white collar on a neck is no seam.
    """
    triangles, corners = generic.triangles()
    colours = _vertex_colours(clone, generic, triangles, corners)
    edges = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0).astype(np.int64)
    skin = generic.vertex_part == generic.part_names.index("body")
    skin &= ~generic.region("mouth_interior")
    edges = edges[skin[edges].all(axis=1)]
    if len(clone.triangle_regions):
        region = _vertex_region(clone, triangles)
        edges = edges[(region[edges[:, 0]] == region[edges[:, 1]]) & (region[edges[:, 0]] >= 0)]
    normals = surface_normals(clone.vertices_m)
    head = generic.head_blend > 0.5 if len(generic.head_blend) else np.zeros(len(normals), dtype=bool)
    face = generic.region("face") if "face" in generic.region_names else head
    ahead, aside = normals[:, 2], np.abs(normals[:, 0]) > np.abs(normals[:, 2])
    trunk = ~head[edges].any(axis=1)
    on_face = face[edges].all(axis=1)
    masks: Mapping[str, tuple[Mask, Mask]] = {
        "front_back": (trunk & _differ(ahead > 0.0, edges), trunk & (np.abs(ahead[edges]) > _CLEARLY).all(axis=1)),
        "head_body": (_differ(head, edges), _neck(generic)[edges].all(axis=1) & ~_differ(head, edges)),
        "face_front_side": (on_face & _differ(aside, edges), on_face & ~_differ(aside, edges)),
    }
    return {where: seam_ratio(colours, edges, crossing, inside) for where, (crossing, inside) in masks.items()}


def _vertex_region(clone: Clone, triangles: NDArray[np.integer]) -> NDArray[np.int64]:
    """Return (V,) the region of all triangles around each vertex, -1 where they differ."""
    least, most = np.full(len(clone.vertices_m), 255), np.full(len(clone.vertices_m), -1)
    labels = clone.triangle_regions.astype(np.int64)
    for corner in triangles.T:
        np.minimum.at(least, corner, labels)
        np.maximum.at(most, corner, labels)
    return np.where(least == most, most, -1)


def _differ(label: Mask, edges: NDArray[np.int64]) -> Mask:
    return np.asarray(label[edges[:, 0]] != label[edges[:, 1]])


def _neck(generic: GenericHuman) -> Mask:
    """Return the vertices around the border of head and body."""
    if "neck" in generic.region_names:
        return np.asarray(generic.region("neck"))
    return np.asarray((generic.head_blend > 0.05) & (generic.head_blend < 0.95))


def _vertex_colours(
    clone: Clone, generic: GenericHuman, triangles: NDArray[np.integer], corners: NDArray[np.integer]
) -> NDArray[np.uint8]:
    """Return (V, 3) atlas colours at one texture coordinate of each vertex."""
    place = np.zeros((len(clone.vertices_m), 2))
    place[triangles.ravel()] = generic.uv[corners.ravel()]
    size = np.array(clone.atlas.rgb.shape[1::-1])
    column, row = np.clip((place * size).astype(int), 0, size - 1).T
    return np.asarray(clone.atlas.rgb[row, column])
