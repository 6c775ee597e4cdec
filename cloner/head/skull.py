"""Keep the skull inside the outline of head and hair: photos show the hair, never the skull, so it may only shrink."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, map_coordinates
from scipy.optimize import least_squares

from cloner.calibration.loader import calibrated
from cloner.generic.head_controls import HeadControls
from cloner.geometry.deformation.dffd import deform
from cloner.head.model import Model
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.skull")

HAIR_M = _CALIBRATED.number("hair_m", "m")
EXPECTED = np.array(_CALIBRATED.triple("expected", "share"))
LEAST = _CALIBRATED.number("least", "factor")
OUTSIDE_M = _CALIBRATED.number("outside_m", "m")
MAP_PX_PER_M = _CALIBRATED.number("map_px_per_m", "px/m")


def skull_moves(model: Model, controls: HeadControls) -> tuple[Array, NDArray[np.int64]]:
    """Return what relative changes of the skull do to the head (3, H, 3), and the rows of skull vertices.

    The changes are: height above the eyes, depth behind the ears, width over the ears. Anchors carry them, so that DFFD
    blends them into face and neck.
    """
    generic = model.generic
    mean = generic.vertices_m.astype(np.float64)
    eye, ear = mean[generic.feature("eye_outer_L")], mean[generic.feature("ear_top_L")]
    low = mean[generic.feature("ear_lobe_L"), 1] - 0.03
    places = controls.controls_m
    carried = np.clip((places[:, 1] - low) / 0.03, 0.0, 1.0) * ~controls.movable
    over = np.clip((places[:, 1] - eye[1]) / 0.05, 0.0, 1.0)
    moves = np.zeros((3, len(places), 3))
    moves[0, :, 1] = carried * over * (places[:, 1] - eye[1])
    moves[1, :, 2] = carried * np.minimum(places[:, 2] - ear[2], 0.0)
    moves[2, :, 0] = carried * over * places[:, 0]
    fields = np.stack([deform(controls.weights, m) for m in moves])
    # The forehead shows its skin: its outline is the face's, no hair lies over it.
    places, brow = mean[generic.head_vertices], mean[generic.feature("glabella")]
    high = (places[:, 1] > eye[1] + 0.02) & ((places[:, 2] < brow[2] - 0.05) | (places[:, 1] > brow[1] + 0.07))
    rows = np.flatnonzero(high & (np.linalg.norm(fields, axis=2).max(axis=0) > 0.03))
    return fields, rows


def _depth_maps(masks: Sequence[tuple[Camera, NDArray[np.uint8]]], centre_m: Array) -> list[tuple[Camera, Array, int]]:
    """Return per photo the signed depth inside the outline, metres, on a coarser grid, and its step in px."""
    out = []
    for camera, mask in masks:
        metres = camera.metres_per_pixel(centre_m)
        step = max(1, round(1.0 / (metres * MAP_PX_PER_M)))
        inside = mask[::step, ::step] > 127
        depth = distance_transform_edt(inside) - distance_transform_edt(~inside)
        out.append((camera, np.asarray(depth, dtype=np.float64) * step * metres, step))
    return out


def fit_skull(
    model: Model, head: Array, controls: HeadControls, masks: Sequence[tuple[Camera, NDArray[np.uint8]]]
) -> tuple[Array, Array]:
    """Return the head (H, 3) with its skull shrunk into the outlines, and the factors (height, back, width)."""
    if not masks:
        return head, np.ones(3)
    fields, rows = skull_moves(model, controls)
    maps = _depth_maps(masks, head[rows].mean(axis=0))

    def outside(factors: Array) -> Array:
        moved = head[rows] + np.tensordot(factors - 1.0, fields[:, rows], axes=1)
        errors = [(factors - 1.0) / EXPECTED]
        for camera, depth, step in maps:
            x, y = camera.project(moved).T / step
            seen = map_coordinates(depth, [y, x], order=1, mode="nearest")
            # A vertex over the photo's edge tells nothing.
            seen = np.where((y < 1) | (x < 1) | (x > depth.shape[1] - 2), HAIR_M, seen)
            errors.append(np.maximum(HAIR_M - seen, 0.0) / OUTSIDE_M)
        return np.concatenate(errors)

    found = least_squares(outside, np.full(3, 0.995), bounds=(LEAST, 1.0), loss="soft_l1", diff_step=1e-3)
    return head + np.tensordot(found.x - 1.0, fields, axes=1), np.asarray(found.x)
