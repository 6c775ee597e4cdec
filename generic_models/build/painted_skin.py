"""What photographs of skin show beyond its tone: freckles, moles, folds beside the mouth, make-up, JPEG's traces."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from painted_heads import Head, _soft, _to_polyline
from painted_people_bodies import waves

from cloner.generic.load import load_generic

Array = NDArray[np.float64]

FRECKLED, FOLDED, MADE_UP, PACKED = 0.25, 0.4, 0.25, 0.6
#: Sizes of freckles and moles, metres.
SPOTS_M: Final = (0.004, 0.010)
QUALITY: Final = (45, 95)


def marked(head: Head, colours: Array, lips: NDArray[np.bool_], rng: np.random.Generator) -> Array:
    """Return colours (V', 3) with freckles, folds and make-up, each on some people only."""
    out = colours.copy()
    if rng.random() < FRECKLED:
        spots = np.clip(waves(head.mean, SPOTS_M, 48, rng) - rng.uniform(1.2, 2.2), 0.0, 1.0)
        out *= 1.0 - rng.uniform(0.15, 0.5) * spots[:, None] * [0.7, 1.0, 1.0]
    if rng.random() < FOLDED:
        out *= 1.0 - rng.uniform(0.1, 0.45) * folds(head, rng)[:, None]
    if rng.random() < MADE_UP:
        tint = np.array([0.75, 0.2, 0.25]) * rng.uniform(0.5, 1.2, 3)
        out[lips] += rng.uniform(0.3, 0.9) * (tint - out[lips])
        shadow = np.array([0.35, 0.25, 0.3]) * rng.uniform(0.3, 1.5, 3)
        for inner, outer in head.eyes.values():
            above = (inner + outer) / 2.0 + [0.0, rng.uniform(0.004, 0.009), 0.0]
            share = head.front * _soft(np.linalg.norm((head.mean - above)[:, :2] * [1.0, 1.8], axis=1), 0.014, 0.006)
            out += rng.uniform(0.2, 0.7) * share[:, None] * (shadow - out)
    return np.clip(out, 0.01, 1.0)


def folds(head: Head, rng: np.random.Generator) -> Array:
    """Return (V',) 0..1 the folds from the wings of the nose past the corners of the mouth."""
    generic, out = load_generic(), np.zeros(len(head.mean))
    for side, sign in (("L", 1.0), ("R", -1.0)):
        wing, corner = (generic.vertices_m[generic.feature(f"{n}_{side}")][:2] for n in ("ala", "mouth_corner"))
        aside = np.array([sign, 0.0])
        line = np.stack([wing + [0.0, 0.004], wing + 0.007 * aside - [0.0, 0.006],
                         corner + rng.uniform(0.006, 0.012) * aside, corner + [sign * 0.008, -0.012]])  # fmt: skip
        out += head.front * _soft(_to_polyline(head.mean[:, :2], line), 0.001, rng.uniform(0.0015, 0.003))
    return np.clip(out, 0.0, 1.0)


def packed(picture: NDArray[np.uint8], rng: np.random.Generator) -> NDArray[np.uint8]:
    """Return an RGB picture as JPEG leaves it, mostly."""
    if rng.random() > PACKED:
        return picture
    _, data = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(*QUALITY))])
    return np.asarray(cv2.imdecode(data, cv2.IMREAD_COLOR), dtype=np.uint8)
