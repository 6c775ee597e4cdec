"""Likeness of a clone: silhouettes and pictures through known cameras."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.evaluate.measures.posing import (
    fit_rotations,
    joints_by_truth_name,
    landmarks,
    moved_camera,
    pose_clone,
    truth_from_body,
    truth_from_points,
)
from cloner.evaluate.measures.rulers import mask_iou, picture_similarity
from cloner.evaluate.truths.truth import TruthView
from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.views import Camera
from cloner.render import render, render_mask

Mask = NDArray[np.bool_]


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
    return mask_iou(render_mask(subject, camera, seen.rotations), mask)


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
    The ruler asks for the photo's pose. A front photo does not tell how far the
    arms hang forward, so the subject is first brought to the truth's joints by
    rotations, the baselines in the same way.
    """
    rotations = fit_rotations(subject, generic, truth.joints_m, truth.points_m, start)
    camera = held_out_camera(subject, rotations, generic, truth)
    mask = render_mask(subject, camera, rotations)
    picture = render(subject, camera, rotations, shading="photo")
    similar, difference = picture_similarity(picture, mask, truth.photo, truth.mask)
    return {"silhouette_iou": mask_iou(mask, truth.mask), "ssim": similar, "delta_e": difference}, picture
