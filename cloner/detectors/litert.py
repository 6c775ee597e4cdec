"""Learned points and masks by Google's published nets; only home of ai_edge_litert.

All functions are pure: same photo, same answer. Photos are (H, W, 3) uint8 RGB, upright;
points come back in photo px, (0, 0) being the centre of the top-left pixel.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from functools import lru_cache
from importlib.resources import files
from typing import Any, Final, Literal

import numpy as np
from ai_edge_litert.interpreter import Interpreter
from numpy.typing import NDArray

from cloner.detectors.anchors import decode, join, make_anchors, overlaps
from cloner.detectors.results import POSE_NAMES, Box, FaceResult, PoseResult
from cloner.vision.crops import Crop, cut, move_points, paste, photo_px_from_crop

__all__ = [
    "POSE_NAMES", "Box", "FaceResult", "PoseResult",
    "detect_face", "detect_people", "detect_pose",
]  # fmt: skip

Photo = NDArray[np.uint8]
Floats = NDArray[np.float64]

THREADS: Final = 2  # taste: the booth's computers have two cores to spare
POSE_SIDE: Final = 256
FACE_SIDE: Final = 192
_LOCK: Final = threading.Lock()


@lru_cache(maxsize=8)
def _net(name: str) -> Interpreter:
    """Load a net once per process."""
    data = (files("cloner_models") / "nets" / name).read_bytes()
    net = Interpreter(model_content=data, num_threads=THREADS)
    net.allocate_tensors()
    return net


def _run(name: str, image: Photo, *, low: float) -> list[NDArray[np.float32]]:
    """Run a net on an image scaled to low..1; return its outputs without the batch axis."""
    values = image.astype(np.float32) * np.float32((1.0 - low) / 255.0) + np.float32(low)
    with _LOCK:  # an interpreter has one set of buffers
        net: Any = _net(name)
        net.set_tensor(net.get_input_details()[0]["index"], values[None])
        net.invoke()
        return [net.get_tensor(d["index"])[0] for d in net.get_output_details()]


def _sigmoid(values: NDArray[np.float32]) -> Floats:
    return 1.0 / (1.0 + np.exp(-np.clip(values.astype(np.float64), -60.0, 60.0)))


# Detectors ------------------------------------------------------------------------------

_DETECTORS: Final[dict[str, tuple[int, tuple[tuple[int, int], ...]]]] = {
    "pose_detection": (224, ((8, 2), (16, 2), (32, 6))),
    "face_detection_short_range": (128, ((8, 2), (16, 6))),
    "face_detection_full_range": (192, ((4, 1),)),
}


def _detect(
    name: str, photo: Photo, crop: Crop, kind: Literal["person", "face"], threshold: float
) -> list[Box]:
    """Run one detector on a square crop; return boxes in photo px, the best first."""
    side, layers = _DETECTORS[name]
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
        boxes.append(Box(kind, *map(float, moved[:2].ravel()), float(score), moved[2:]))
    return boxes


def _whole(photo: Photo) -> Crop:
    """Return the smallest square round the photo."""
    height, width = photo.shape[:2]
    side = float(max(height, width))
    return Crop((width - 1) / 2.0, (height - 1) / 2.0, side, side)


def _same(first: Box, second: Box, overlap: float) -> bool:
    rows = [
        np.array([[b.left_px + b.right_px, b.top_px + b.bottom_px], [2 * b.width_px, 2 * b.height_px]])
        / 2.0
        for b in (first, second)
    ]
    return bool(overlaps(rows[0], rows[1][None])[0] > overlap)


def _distinct(boxes: list[Box], overlap: float = 0.2) -> list[Box]:
    """Return the boxes without repeats, the best first."""
    kept: list[Box] = []
    for box in sorted(boxes, key=lambda b: -b.score):
        if not any(_same(box, other, overlap) for other in kept):
            kept.append(box)
    return kept


def _find_faces(photo: Photo, threshold: float = 0.5) -> list[Box]:
    """Return the faces in a photo, near and far, the best first."""
    whole = _whole(photo)
    boxes = _detect("face_detection_short_range", photo, whole, "face", threshold)
    boxes += _detect("face_detection_full_range", photo, whole, "face", threshold)
    return _distinct(boxes)
