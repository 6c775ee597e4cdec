"""Masks spoilt on purpose, by up to a fiftieth of the figure's height."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.loops import figure_height, mask_loops

Mask = NDArray[np.float32]

#: How far masks are spoilt, figure heights.
WRONG: Final = 0.02
#: Bites and blobs of that radius along one photo's outline.
SPOTS: Final = 8
DISTURBED: Final = ("shifted", "eroded", "dilated", "blurred", "bitten", "blobs added")


def disturb(mask: Mask, kind: str, rng: np.random.Generator) -> Mask:
    """Return a mask (H, W, 0..1) spoilt in one of the ways of ``DISTURBED``."""
    height = figure_height(mask)
    most = WRONG * height
    if kind == "shifted":
        turn, far = rng.uniform(0.0, 2.0 * np.pi), most * rng.uniform(0.5, 1.0)
        move = np.array([[1.0, 0.0, far * np.cos(turn)], [0.0, 1.0, far * np.sin(turn)]])
        return np.asarray(cv2.warpAffine(mask, move, mask.shape[::-1], borderMode=cv2.BORDER_REPLICATE), np.float32)
    if kind in ("eroded", "dilated"):
        # half at most: more would cut hands and feet off altogether
        radius = round(0.5 * most * rng.uniform(0.6, 1.0))
        disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1, 2 * radius + 1))
        return np.asarray((cv2.erode if kind == "eroded" else cv2.dilate)(mask, disc), np.float32)
    if kind == "blurred":
        return np.asarray(cv2.GaussianBlur(mask, (0, 0), most * rng.uniform(0.5, 1.0)), np.float32)
    spoilt = mask.copy()
    outline = np.concatenate([loop.points for loop in mask_loops(mask, height_px=height)])
    for centre in outline[rng.integers(0, len(outline), SPOTS)]:
        cv2.circle(spoilt, tuple(int(v) for v in centre), round(most), 0.0 if kind == "bitten" else 1.0, -1)
    return spoilt
