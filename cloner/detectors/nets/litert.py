"""Points and masks by Google's published nets; the only module that uses ai_edge_litert.

All functions are pure: same photo, same answer. Photos are (H, W, 3) uint8 RGB, upright;
points come back in photo px, (0, 0) being the centre of the top-left pixel.
"""

from __future__ import annotations

import math
import os
import threading
from collections.abc import Sequence
from functools import lru_cache
from importlib.resources import files
from typing import Any, Final, Literal

import numpy as np
from ai_edge_litert.interpreter import Interpreter
from numpy.typing import NDArray

from cloner.detectors.nets.anchors import DETECTOR_LAYERS, decode, join, make_anchors, sigmoid
from cloner.detectors.nets.chatter import chatter_logged
from cloner.detectors.nets.face_regions import refine_regions
from cloner.detectors.nets.inner_tensors import with_outputs
from cloner.detectors.nets.mask_crops import body_mask, portrait_mask
from cloner.detectors.nets.placing import (
    body_crop,
    distinct,
    enlarged_crop,
    face_crop,
    jittered_crops,
    mesh_crop,
    mirror_crop,
    mirror_order,
    overlap_enough,
    square_around_photo,
)  # fmt: skip
from cloner.detectors.nets.pose_passes import (
    POSE_SIDE,
    PosePass,
    run_portrait_pose,
    run_pose,
    run_pose_twice,
    shows_hips,
)
from cloner.detectors.nets.results import Box, FaceResult, PoseResult
from cloner.vision.photographs.crops import Crop, cut, move_points, photo_px_from_crop

Photo = NDArray[np.uint8]
Floats = NDArray[np.float64]

#: Taste: a booth computer has two cores to spare; a worker of a batch has one, and waiting threads would spin on it.
THREADS: Final = 1 if os.environ.get("OMP_NUM_THREADS") == "1" else 2
FACE_SIDE: Final = 192
#: Inner tensors that the label decoder reads, by net. Of all that were tried these carried the labels (see
#: ``generic_models/build/train_labels.py``); the numbers belong to exactly these files.
INNER: Final = {
    "pose_landmark_heavy.tflite": (415, 430, 448, 499, 545, 557),
    "selfie_segmentation.tflite": (25, 48, 91),
}
_LOADING: Final = threading.Lock()


@lru_cache(maxsize=8)
def _net(name: str) -> tuple[Interpreter, threading.Lock]:
    """Load a net once per process; its lock keeps one thread at a time in its buffers."""
    data = (files("cloner_models") / "nets" / name).read_bytes()
    with chatter_logged():
        net = Interpreter(model_content=with_outputs(data, INNER.get(name, ())), num_threads=THREADS)
        net.allocate_tensors()
    return net, threading.Lock()


def release_nets() -> None:
    """Unload all nets: loaded they take 180 MiB, and loading them takes .15 CPU seconds."""
    with _LOADING:
        _net.cache_clear()


def _invoke(name: str, inputs: Sequence[NDArray[np.float32]], *, inner: bool = False) -> list[NDArray[np.float32]]:
    """Run a net on inputs without the batch axis; return its outputs, or those and the inner tensors."""
    with _LOADING:
        net: Any
        net, turn = _net(name)
    with turn:
        for detail, values in zip(net.get_input_details(), inputs, strict=True):
            net.set_tensor(detail["index"], values[None])
        net.invoke()
        given = net.get_output_details()
        own = len(given) - len(INNER.get(name, ()))
        return [net.get_tensor(d["index"])[0] for d in (given if inner else given[:own])]


def _run(name: str, image: Photo, *, low: float) -> list[NDArray[np.float32]]:
    """Run a net on an image scaled to low..1; return its outputs without the batch axis."""
    return _invoke(name, [image.astype(np.float32) * np.float32((1.0 - low) / 255.0) + np.float32(low)])


def detect(name: str, photo: Photo, crop: Crop, kind: Literal["person", "face"], threshold: float) -> list[Box]:
    """Run one detector on a square crop; return boxes in photo px, the best first."""
    side, layers = DETECTOR_LAYERS[name]
    image = cut(photo, crop, width=side, height=side)
    raw, logits = sorted(_run(f"{name}.tflite", image, low=-1.0), key=lambda a: -a.shape[-1])
    anchors = make_anchors(side, layers)
    rows, scores = join(*decode(raw, logits[:, 0], anchors, side=side, threshold=threshold))
    photo_from_crop = photo_px_from_crop(crop, width=side, height=side)
    boxes = []
    for row, score in zip(rows, scores, strict=True):
        corners = np.stack([row[0] - row[1] / 2, row[0] + row[1] / 2])
        points = np.concatenate([corners, row[2:]]) * side - 0.5
        moved = move_points(points, photo_from_crop)
        left, top, right, bottom = map(float, moved[:2].ravel())
        boxes.append(Box(kind, left, top, right, bottom, float(score), moved[2:]))
    return boxes


def find_faces(photo: Photo, threshold: float = 0.5) -> list[Box]:
    """Return the faces in a photo, near and far, the best first."""
    whole = square_around_photo(photo)
    boxes = detect("face_detection_short_range", photo, whole, "face", threshold)
    boxes += detect("face_detection_full_range", photo, whole, "face", threshold)
    return distinct(boxes)


def pose_net(photo: Photo, crop: Crop) -> dict[int, NDArray[np.float32]]:
    """Run the heavy pose net; return its outputs by number of values."""
    image = cut(photo, crop, width=POSE_SIDE, height=POSE_SIDE)
    return {out.size: out for out in _run("pose_landmark_heavy.tflite", image, low=0.0)}


def detect_pose(rgb: Photo, person: Box | None = None) -> PoseResult | None:
    """Find the person's 33 points and mask.

    Two passes: the detector's circle gives first points, these give a better circle. Where the
    lower edge cuts the person, the circle follows from the mask when the detector's pose does not fit.
    The mask of a whole body is the mean of three answers (``body_mask``); that
    of a portrait comes from the selfie net, which sees the half body larger.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    person : Box, optional
        Whom :func:`cloner.detectors.nets.people.detect_people` found: the look that confirmed a body is the first pass.

    Returns
    -------
    PoseResult or None
        None where no person is seen. A low `score` asks for doubt.

    Notes
    -----
    The net was taught on people facing the camera: on backs left and right come out
    right as a rule, on pure side views the hidden limbs are guesses and the two sides
    may be exchanged. Use `visibility`.
    """
    found: PosePass | None = None
    if person is not None and person.kind == "person":
        found = run_pose(rgb, body_crop(person), pose_net)
    else:
        boxes = detect("pose_detection", rgb, square_around_photo(rgb), "person", 0.3)
        found = run_pose_twice(rgb, body_crop(boxes[0]), pose_net) if boxes else None
    if found is None or shows_hips(found, rgb):
        found = run_portrait_pose(rgb, pose_net, selfie_net, found)
    if found is None:
        return None
    if shows_hips(found, rgb):
        return found.result(body_mask(rgb, found.crop, _pose_mask_net))
    return found.result(portrait_mask(rgb, selfie_net))


def _pose_mask_net(photo: Photo, crop: Crop) -> Floats:
    return sigmoid(pose_net(photo, crop)[POSE_SIDE * POSE_SIDE].reshape(POSE_SIDE, POSE_SIDE))


def selfie_net(photo: Photo, crop: Crop) -> Floats:
    """Return the (256, 256) probability of a person in a crop, 0..1."""
    image = cut(photo, crop, width=256, height=256)
    return np.asarray(_run("selfie_segmentation.tflite", image, low=0.0)[0][..., 0], np.float64)


def label_features(rgb: Photo) -> list[NDArray[np.float32]]:
    """Return the inner features of the pose and selfie nets for the label decoder.

    Parameters
    ----------
    rgb : (256, 256, 3) uint8
        A crop.

    Returns
    -------
    list of 11 (h, w, C) float32
        Six tensors of the pose net, three of the selfie net, then both nets' person masks (256, 256, 1) in 0..1.
    """
    image = rgb.astype(np.float32) * np.float32(1.0 / 255.0)
    pose, selfie = "pose_landmark_heavy.tflite", "selfie_segmentation.tflite"
    posed, near = _invoke(pose, [image], inner=True), _invoke(selfie, [image], inner=True)
    mask = next(out for out in posed if out.shape == (POSE_SIDE, POSE_SIDE, 1))
    person = np.asarray(sigmoid(mask), np.float32)
    return [*posed[-len(INNER[pose]) :], *near[-len(INNER[selfie]) :], person, near[0]]


def face_mesh(photo: Photo, crop: Crop) -> tuple[Floats, float]:
    """Return 468 points (x, y photo px; depth px) and the probability that a face is present."""
    image = cut(photo, crop, width=FACE_SIDE, height=FACE_SIDE)
    points, flag = sorted(_run("face_landmark.tflite", image, low=0.0), key=lambda a: -a.size)
    table = points.reshape(468, 3).astype(np.float64)
    photo_from_crop = photo_px_from_crop(crop, width=FACE_SIDE, height=FACE_SIDE)
    moved = move_points(table[:, :2] - 0.5, photo_from_crop)
    depth = table[:, 2] * crop.width_px / FACE_SIDE
    return np.column_stack([moved, depth]), float(sigmoid(flag).ravel()[0])


def _mean_mesh(photo: Photo, crop: Crop) -> tuple[Floats, float]:
    """Return the mean mesh of a crop and its mirror image; halves the net's jitter."""
    straight, presence = face_mesh(photo, crop)
    flipped, other_crop = mirror_crop(photo, crop)
    mirrored, other = face_mesh(flipped, other_crop)
    mirrored = mirrored[mirror_order()]
    mirrored[:, 0] = photo.shape[1] - 1 - mirrored[:, 0]
    return (straight + mirrored) / 2, min(presence, other)


def detect_face(rgb: Photo) -> FaceResult | None:
    """Find the 468 points of the largest face, near or in a whole-body photo.

    What the detectors take for a face need not be one (knees, a pattern on a shirt): the mesh net decides.

    Parameters
    ----------
    rgb : (H, W, 3) uint8

    Returns
    -------
    FaceResult or None
        None where no face is seen, as on backs. On profiles the far half is invented
        and `presence` does not tell; look at `turn_deg`.
    """
    found = find_faces(rgb, 0.3)
    likely = [box for box in found if box.score > 0.6] or found
    largest_first = sorted(likely, key=lambda box: -box.width_px)
    return next((face for box in largest_first if (face := _face_at(rgb, box, 0.5)) is not None), None)


def guess_hidden_face(rgb: Photo) -> FaceResult | None:
    """Return the 468 points of the likeliest face, however little of it the mesh net sees.

    Hair before a face leaves the detector sure and the mesh net in doubt; so do backs of heads and profiles.
    """
    best = max(find_faces(rgb, 0.3), key=lambda box: box.score, default=None)
    return None if best is None else _face_at(rgb, best, 0.0)


def _face_at(rgb: Photo, box: Box, least: float) -> FaceResult | None:
    """Return the face in a detected box, None where its presence is below ``least``."""
    box = _detect_again(rgb, box)
    points, presence = face_mesh(rgb, face_crop(box))
    if presence < least:
        return None
    points, presence = _mean_mesh(rgb, mesh_crop(points))
    if presence < least:
        return None
    # The second crop comes from the first points, as in MediaPipe.
    points = np.mean([_mean_mesh(rgb, near)[0] for near in jittered_crops(mesh_crop(points))], axis=0)
    across = float(np.hypot(*(points[263, :2] - points[33, :2])))
    turn = math.degrees(math.atan2(points[263, 2] - points[33, 2], across))
    closer, irises = refine_regions(rgb, points, _invoke)
    return FaceResult(closer, points[:, 2], presence, turn, box, irises, points[:, :2])


def _detect_again(photo: Photo, box: Box) -> Box:
    """Detect a small face again in a crop around it, where its eyes are sharper."""
    near = detect("face_detection_short_range", photo, enlarged_crop(box), "face", 0.5)
    return near[0] if near and overlap_enough(near[0], box, 0.3) else box
