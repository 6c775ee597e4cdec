"""Lips, eyes and irises by the second half of the attention face net.

The net looks at the whole face, gives a mesh and features of every place, cuts three turned grids of features out
where its mesh has the lips and the eyes, and looks at each again. Cutting out is done here, in NumPy, because the
runtime lacks the operators; the two halves around it are nets of their own. No net here.

References
----------
Grishchenko et al. 2020, "Attention Mesh: High-fidelity Face Mesh Prediction in Real-time".
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from importlib.resources import files
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.nets.placing import jittered_crops, mesh_crop, mirror_order
from cloner.vision.photographs.crops import cut, move_points, photo_px_from_crop

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.face_regions")

Floats = NDArray[np.float64]
Features = NDArray[np.float32]
RunNet = Callable[[str, Sequence[NDArray[np.float32]]], list[NDArray[np.float32]]]
"""Runs a net by its file's name on float inputs without batch axis; gives outputs the same way, in the net's order."""

MESH_NET: Final = "face_attention_mesh.tflite"
REGION_NET: Final = "face_attention_regions.tflite"
#: Side of the picture and of its feature map, of a region's grid, and of the region in its own points' unit, px.
SIDE: Final = 192
_MAP_SIDE: Final = 48
_GRID: Final = 16
_REGION_SIDE: Final = 64
_ROOM: Final = _CALIBRATED.number("room", "factor")
#: Regions in the net's order, each with the two mesh points that tell its slope, from the image's left to its right.
_REGIONS: Final = (("lips", 61, 291), ("eye_right", 33, 133), ("eye_left", 362, 263))
#: Rows of the iris centres behind the 468 mesh points, the person's right and left.
IRIS_ROWS: Final = (468, 469)


@lru_cache(maxsize=1)
def region_rows() -> dict[str, NDArray[np.int32]]:
    """Return which mesh points each region refines: 80 of the lips, 71 of each eye with its brow."""
    with (files("cloner_models") / "nets" / "face_regions.npz").open("rb") as stream, np.load(stream) as data:
        return {name: data[name] for name, _, _ in _REGIONS}


def region_frame(mesh_px: Floats, rows: NDArray[np.integer], left: int, right: int) -> tuple[Floats, Floats]:
    """Return the (2, 2) linear part and the (2,) shift from a region's unit square to the mesh's pixels.

    Parameters
    ----------
    mesh_px : (468, 2) float64
        Any frame; the square is 1.5 times the box of the region's points, turned with the line left-right.
    rows : (K,) the region's points
    left, right : int
        Mesh points whose line is level in the square.
    """
    across = mesh_px[right] - mesh_px[left]
    angle = float(np.arctan2(across[1], across[0]))
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    level = mesh_px[rows] @ turn
    low, high = level.min(axis=0), level.max(axis=0)
    linear = turn @ np.diag(_ROOM * (high - low))
    return linear, turn @ ((low + high) / 2.0) - linear @ [0.5, 0.5]


def cut_features(features: Features, linear: Floats, shift: Floats) -> Features:
    """Return the (16, 16, C) features of a region's grid, between cells bilinearly, zero outside.

    Parameters
    ----------
    features : (48, 48, C) float32
    linear, shift : (2, 2), (2,) float64
        From the unit square to the picture's pixels, cell centres at half cells.
    """
    middle = (np.arange(_GRID) + 0.5) / _GRID
    square = np.stack(np.meshgrid(middle, middle), axis=-1)
    place = ((square @ linear.T + shift) * (_MAP_SIDE / SIDE) - 0.5).astype(np.float32)
    channels = [
        cv2.remap(np.ascontiguousarray(features[..., k : k + 4]), place[..., 0], place[..., 1], cv2.INTER_LINEAR)
        for k in range(0, features.shape[-1], 4)  # cv2 takes four channels at a time
    ]
    return np.concatenate(channels, axis=-1).astype(np.float32)


def refined_mesh(image: NDArray[np.uint8], run: RunNet) -> Floats:
    """Return points (470, 2) of a face: the mesh, with refined lips and eyes, and the iris centres.

    Parameters
    ----------
    image : (192, 192, 3) uint8
        The face, upright.
    run : callable
        Runs a net.

    Returns
    -------
    (470, 2) float64
        Net pixels, (0, 0) = corner of the top-left pixel; rows 468 and 469 the person's right and left iris.
    """
    outputs = {out.size: out for out in run(MESH_NET, [image.astype(np.float32) / np.float32(255.0)])}
    points = np.zeros((470, 2))
    points[:468] = outputs[468 * 3].reshape(468, 3)[:, :2]
    features = next(out for out in outputs.values() if out.ndim == 3 and out.shape[0] == _MAP_SIDE)
    rows = region_rows()
    frames = [region_frame(points[:468], rows[name], left, right) for name, left, right in _REGIONS]
    lips, right_eye, right_iris, left_eye, left_iris = run(REGION_NET, [cut_features(features, *f) for f in frames])
    laid = [(rows["lips"], lips, 0), (rows["eye_right"], right_eye, 1), (rows["eye_left"], left_eye, 2)]
    laid += [(np.array([IRIS_ROWS[0]]), right_iris[:1], 1), (np.array([IRIS_ROWS[1]]), left_iris[:1], 2)]
    for where, values, region in laid:
        linear, shift = frames[region]
        points[where] = values.astype(np.float64) / _REGION_SIDE @ linear.T + shift
    return points


def mean_refined_mesh(image: NDArray[np.uint8], run: RunNet) -> Floats:
    """Return the mean points of a face and its mirror image, (470, 2) net pixels."""
    straight = refined_mesh(image, run)
    mirrored = refined_mesh(np.ascontiguousarray(image[:, ::-1]), run)[np.append(mirror_order(), IRIS_ROWS[::-1])]
    return np.asarray((straight + np.column_stack([SIDE - mirrored[:, 0], mirrored[:, 1]])) / 2.0)


def refine_regions(photo: NDArray[np.uint8], mesh_px: Floats, run: RunNet) -> tuple[Floats, Floats]:
    """Return a face's points with lips, eyes and brows refined, and its irises.

    Parameters
    ----------
    photo : (H, W, 3) uint8
    mesh_px : (468, 2+) float64
        The mesh in photo px; its points elsewhere are kept.
    run : callable
        Runs a net.

    Returns
    -------
    (468, 2) float64 photo px, and (2, 2) float64 centres of the person's left and right iris
    """
    looks = []
    for crop in jittered_crops(mesh_crop(mesh_px)):
        photo_from_crop = photo_px_from_crop(crop, width=SIDE, height=SIDE)
        seen = mean_refined_mesh(cut(photo, crop, width=SIDE, height=SIDE), run)
        looks.append(move_points(seen - 0.5, photo_from_crop))
    refined = np.mean(looks, axis=0)
    out = mesh_px[:, :2].astype(np.float64)
    for rows in region_rows().values():
        out[rows] = refined[rows]
    return out, refined[list(IRIS_ROWS[::-1])]
