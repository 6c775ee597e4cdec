"""Read the boxes out of single-shot detector nets: anchors, decoding, joining."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

#: Input side, px, and layers (stride px, anchors a cell) of the detector nets by name.
DETECTOR_LAYERS: Final[dict[str, tuple[int, tuple[tuple[int, int], ...]]]] = {
    "pose_detection": (224, ((8, 2), (16, 2), (32, 6))),
    "face_detection_short_range": (128, ((8, 2), (16, 6))),
    "face_detection_full_range": (192, ((4, 1),)),
}


def sigmoid(values: NDArray[Any]) -> NDArray[np.float64]:
    """Return 0..1 of a net's logits."""
    return 1.0 / (1.0 + np.exp(-np.clip(values.astype(np.float64), -60.0, 60.0)))


@lru_cache(maxsize=8)
def make_anchors(side: int, layers: tuple[tuple[int, int], ...]) -> NDArray[np.float64]:
    """Return anchor centres (N, 2) in 0..1 for layers of (stride px, anchors a cell).

    References
    ----------
    Bazarevsky et al. 2019, "BlazeFace", section 3; MediaPipe SsdAnchorsCalculator
    with fixed_anchor_size.
    """
    blocks = []
    for stride, count in layers:
        cells = -(-side // stride)
        axis = (np.arange(cells) + 0.5) / cells
        grid = np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2)
        blocks.append(np.repeat(grid, count, axis=0))
    anchors = np.concatenate(blocks)
    anchors.flags.writeable = False
    return anchors


def decode(
    raw: NDArray[np.float32],
    logits: NDArray[np.float32],
    anchors: NDArray[np.float64],
    *,
    side: int,
    threshold: float,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return kept rows and scores of a detector's output.

    Parameters
    ----------
    raw : (N, 4 + 2 K) float32
        Per anchor: centre x, y, width, height, K key points; net px.
    logits : (N,) float32
    anchors : (N, 2) float64
    side : int
        Side of the net's input in px.
    threshold : float
        Least score kept, 0..1.

    Returns
    -------
    rows : (M, 2 + K, 2) float64
        Per box: centre, size, key points; 0..1 of the net's input.
    scores : (M,) float64
    """
    scores = 1.0 / (1.0 + np.exp(-np.clip(logits.astype(np.float64), -100.0, 100.0)))
    keep = scores >= threshold
    rows = raw[keep].astype(np.float64).reshape(int(keep.sum()), raw.shape[1] // 2, 2) / side
    rows[:, 0] += anchors[keep]
    rows[:, 2:] += anchors[keep][:, None]
    return rows, scores[keep]


def overlaps(box: NDArray[np.float64], boxes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the intersection over union of one (2+, 2) box row with many."""
    low = np.maximum(box[0] - box[1] / 2, boxes[:, 0] - boxes[:, 1] / 2)
    high = np.minimum(box[0] + box[1] / 2, boxes[:, 0] + boxes[:, 1] / 2)
    shared = np.prod(np.maximum(high - low, 0.0), axis=-1)
    union = np.prod(box[1]) + np.prod(boxes[:, 1], axis=-1) - shared
    return np.asarray(shared / np.maximum(union, 1e-12), np.float64)


def join(
    rows: NDArray[np.float64], scores: NDArray[np.float64], *, overlap: float = 0.3
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Average overlapping boxes by score, the best first.

    Weighted non-maximum suppression of the BlazeFace paper: the mean of all boxes that
    overlap the best one jitters less than the best one.
    """
    kept_rows, kept_scores = [], []
    left = np.argsort(-scores)
    while len(left):
        near = overlaps(rows[left[0]], rows[left]) > overlap
        near[0] = True
        group = left[near]
        weights = scores[group] / scores[group].sum()
        kept_rows.append(np.tensordot(weights, rows[group], axes=1))
        kept_scores.append(float(scores[left[0]]))
        left = left[~near]
    shape = (0, *rows.shape[1:])
    stacked = np.stack(kept_rows) if kept_rows else np.zeros(shape)
    return stacked, np.array(kept_scores, np.float64)
