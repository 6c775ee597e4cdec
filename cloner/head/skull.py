"""The skull inside the outline of head and hair: photos show the hair, never the skull, so it can only shrink."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, map_coordinates

from cloner.calibration.loader import calibrated
from cloner.fit.evidence import Residuals, cauchy_weights
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.generic.head_controls import HeadControls
from cloner.geometry.cameras.motions import projection_derivatives
from cloner.geometry.deformation.dffd import deform
from cloner.head.model import HeadModel
from cloner.records.arrays import Array
from cloner.records.proposals import PERSON_LEVEL
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.skull")

HAIR_M = _CALIBRATED.number("hair_m", "m")
EXPECTED = np.array(_CALIBRATED.triple("expected", "share"))
LEAST = _CALIBRATED.number("least", "factor")
OUTSIDE_M = _CALIBRATED.number("outside_m", "m")
MAP_PX_PER_M = _CALIBRATED.number("map_px_per_m", "px/m")
#: Steps at most.
ITERATIONS = 12


def skull_modes(model: HeadModel, controls: HeadControls) -> tuple[Array, NDArray[np.int64]]:
    """Return the modes (3, H, 3) of relative changes of the skull, and the rows of skull vertices.

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


def _depth_maps(
    masks: Sequence[tuple[Camera, NDArray[np.uint8]]], centre_m: Array
) -> list[tuple[Camera, Array, list[Array], int]]:
    """Return per photo the depth inside the outline, metres, on a coarse grid, its gradients, and the grid step, px."""
    out = []
    for camera, mask in masks:
        metres = camera.metres_per_pixel(centre_m)
        step = max(1, round(1.0 / (metres * MAP_PX_PER_M)))
        inside = mask[::step, ::step] > PERSON_LEVEL
        depth = distance_transform_edt(inside) - distance_transform_edt(~inside)
        depth = np.asarray(depth, dtype=np.float64) * step * metres
        out.append((camera, depth, list(np.gradient(depth)), step))
    return out


def fit_skull(
    model: HeadModel, head: Array, controls: HeadControls, masks: Sequence[tuple[Camera, NDArray[np.uint8]]]
) -> tuple[Array, Array]:
    """Return the head (H, 3) with the skull shrunk into the outlines, and the factors (height, back, width)."""
    if not masks:
        return head, np.ones(3)
    fields, rows = skull_modes(model, controls)
    maps, own = _depth_maps(masks, head[rows].mean(axis=0)), fields[:, rows].transpose(1, 2, 0)

    def linearise(values: Values, iteration: int) -> Iterator[Residuals]:
        moved = head[rows] + own @ (values["factors"] - 1.0)
        for camera, depth, steep, step in maps:
            seen, by_points, _ = projection_derivatives(camera, moved)
            places = seen.T[::-1] / step
            lacking = HAIR_M - map_coordinates(depth, places, order=1, mode="nearest")
            inside = (places >= 1.0).all(axis=0) & (places[1] <= depth.shape[1] - 2)
            counts = np.flatnonzero(inside & (lacking > 0.0))  # a vertex over the photo's edge tells nothing
            deeper = np.stack([map_coordinates(each, places[:, counts], order=1) for each in steep[::-1]], axis=1)
            by_factors = np.einsum("ni,nia,naf->nf", deeper / step, by_points[counts], own[counts], optimize=True)
            value = lacking[counts] / OUTSIDE_M
            yield Residuals(("factors",), value, -by_factors / OUTSIDE_M, np.sqrt(cauchy_weights(value**2, 1.0)))

    block = ParameterBlock(np.ones(3), 1.0, EXPECTED, lower=LEAST, upper=1.0)
    factors = Problem({"factors": block}).solve(linearise, iterations=ITERATIONS, tolerance=0.01).values["factors"]
    return head + np.tensordot(factors - 1.0, fields, axes=1), factors
