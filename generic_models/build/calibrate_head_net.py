"""Learn how the face net errs with the face's shape: ``python generic_models/build/calibrate_head_net.py``.

The net draws every face towards the faces it learned from: two fifths of the variance of its errors follow from the
head's shape (leave one out, 120 painted people). Told to the head's fit they stop pulling it towards the mean head. The
people are those of ``calibrate_face_net.py``; the result is ``cloner_models/head_net.npz``.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from archives import save
from numpy.typing import NDArray

from cloner.detectors.face_net import load_face_net
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.sockets import similarity
from cloner.geometry.surface import SurfacePoints
from cloner.records.views import Camera

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "head_net.npz"
#: Ridge of the regression, in squared standard deviations of the shape; best of 3, 10, 30, 100 by leave-one-out.
RIDGE = 30.0
#: Joint errors kept; what is left counts as independent.
MODES = 24
#: Error of a face that the basis cannot show, metres a point: steadies its coefficients.
UNSHOWN_M = 0.0001


@dataclass(frozen=True, slots=True, eq=False)
class Sample:
    """One painted front face: true vertices (V, 3), camera, and the net's points (468, 2) px."""

    vertices_m: Array
    camera: Camera
    points_px: Array


def coefficients_of(generic: GenericHuman, vertices: Array) -> tuple[Array, float]:
    """Return the face basis' coefficients (F,) nearest to a head of any size, and the scale to the mean head's size."""
    head, face = generic.head_vertices, generic.region("face")[generic.head_vertices]
    mean, basis = generic.vertices_m[head].astype(np.float64), generic.face_basis.astype(np.float64)
    columns = basis[:, face].reshape(len(basis), -1).T
    normal = columns.T @ columns + face.sum() * UNSHOWN_M**2 * np.eye(len(basis))
    found, scale = np.zeros(len(basis)), 1.0
    for _ in range(4):
        shown = mean + np.tensordot(found, basis, axes=1)
        scale, rotation, shift = similarity(vertices[head][face], shown[face])
        laid = scale * vertices[head] @ rotation.T + shift
        found = np.linalg.solve(normal, columns.T @ (laid - mean)[face].ravel())
    return found, scale


def pose_free(places: SurfacePoints, generic: GenericHuman, error: Array) -> Array:
    """Return errors (468, 2) without what a camera's motion would take up: shift, size, and turns."""
    mean = places.at(generic.vertices_m.astype(np.float64))
    mean = mean - mean.mean(axis=0)
    still = np.zeros(len(mean))
    flat = mean[:, :2] * [1.0, -1.0]
    motions = np.stack(
        [
            np.column_stack([still + 1.0, still]),
            np.column_stack([still, still + 1.0]),
            flat,
            np.column_stack([-flat[:, 1], flat[:, 0]]),
            np.column_stack([mean[:, 2], still]),
            np.column_stack([still, mean[:, 2]]),
        ]
    ).reshape(6, -1)
    return np.asarray(
        (error.ravel() - np.linalg.lstsq(motions.T, error.ravel(), rcond=None)[0] @ motions).reshape(error.shape)
    )


def regress(shapes: Array, errors: Array, twin: NDArray[np.int64], mirrored: Array) -> dict[str, NDArray[np.generic]]:
    """Return what the shape tells of the errors, their joint rest, and each point's own.

    Parameters
    ----------
    shapes : (N, F) coefficients
    errors : (N, 468, 2) metres
    twin : (468,) each point's twin on the other side
    mirrored : (F, F) coefficients of a mirrored head from those of the head
    """
    shapes = np.vstack([shapes, shapes @ mirrored.T])
    errors = np.concatenate([errors, errors[:, twin] * [-1.0, 1.0]])
    middle = errors.mean(axis=0)
    flat = (errors - middle).reshape(len(errors), -1)
    gram = shapes @ shapes.T
    # Mirrored twins count twice as samples but tell half as much each.
    hat = gram @ np.linalg.inv(gram + 2.0 * RIDGE * np.eye(len(gram)))
    skew = np.linalg.solve(shapes.T @ shapes + 2.0 * RIDGE * np.eye(shapes.shape[1]), shapes.T @ flat)
    half = len(flat) // 2
    leverage = 1.0 - np.diag(hat) - np.r_[np.diag(hat, half), np.diag(hat, half)]
    left = (flat - hat @ flat) / np.maximum(leverage, 0.3)[:, None]
    _, size, modes = np.linalg.svd(left, full_matrices=False)
    drift = (size[:MODES, None] / np.sqrt(len(left))) * modes[:MODES]
    rest = left - (left @ modes[:MODES].T) @ modes[:MODES]
    alone = np.sqrt((rest.reshape(errors.shape) ** 2).sum(axis=2).mean(axis=0) / 2.0)
    return {
        "bias_m": middle.astype(np.float32),
        "skew_m": skew.reshape(-1, *errors.shape[1:]).astype(np.float16),
        "drift_m": drift.reshape(-1, *errors.shape[1:]).astype(np.float16),
        "alone_m": alone.astype(np.float32),
    }


def mirrored_coefficients(generic: GenericHuman) -> Array:
    """Return the (F, F) map from a head's coefficients to its mirror image's."""
    basis = generic.face_basis.astype(np.float64)
    row = np.full(len(generic.vertices_m), -1)
    row[generic.head_vertices] = np.arange(len(generic.head_vertices))
    other = basis[:, row[generic.mirror[generic.head_vertices]]] * [-1.0, 1.0, 1.0]
    flat = basis.reshape(len(basis), -1)
    return np.asarray(np.linalg.lstsq(flat.T, other.reshape(len(basis), -1).T, rcond=None)[0])


def calibrate(samples: list[Sample]) -> dict[str, NDArray[np.generic]]:
    """Return the arrays of ``head_net.npz``."""
    generic, places = load_generic(), load_face_net().places
    nasion, shapes, errors = generic.feature("nasion"), [], []
    for sample in samples:
        found, scale = coefficients_of(generic, sample.vertices_m)
        metres = scale * sample.camera.metres_per_pixel(sample.vertices_m[nasion])
        error = (sample.points_px - sample.camera.project(places.at(sample.vertices_m))) * metres
        shapes.append(found)
        errors.append(pose_free(places, generic, error))
    mean = places.at(generic.vertices_m.astype(np.float64))
    twin = np.linalg.norm((mean * [-1.0, 1.0, 1.0])[:, None] - mean[None], axis=2).argmin(axis=1)
    return regress(np.stack(shapes), np.stack(errors), twin, mirrored_coefficients(generic))


def main() -> None:
    """Photograph, ask, regress, write."""
    from calibrate_face_net import FIRST_SITTER, show_sitter

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--heads", type=int, default=120)
    shown = [show_sitter(seed) for seed in range(FIRST_SITTER, FIRST_SITTER + parser.parse_args().heads)]
    arrays = calibrate([Sample(s.vertices_m, s.camera, s.points_px) for s in shown if s is not None])
    save(OUT, arrays)
    rms = {name: 1e3 * float(np.sqrt((a.astype(float) ** 2).sum(axis=0).mean())) for name, a in arrays.items()}
    print(f"{len(shown)} heads; mm: {rms}")


if __name__ == "__main__":
    main()
