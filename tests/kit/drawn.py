"""A drawn figure whose outline is known to a hundredth of a pixel, photographed badly."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.contours.loops import fill_polygon

HEIGHT, WIDTH = 600, 400
CENTRE, AXES = np.array([200.3, 300.6]), np.array([110.0, 240.0])
SKIN, WALL = (190, 120, 90), (90, 130, 150)
Photo = NDArray[np.uint8]


def ellipse(count: int = 4000, *, scale: float = 1.0) -> NDArray[np.float64]:
    t = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return CENTRE + scale * AXES * np.column_stack([np.cos(t), np.sin(t)])


def draw(canvas: Photo, polygon: NDArray[np.float64], colour: tuple[int, int, int]) -> Photo:
    """Fill a polygon with exact, anti-aliased coverage."""
    k = 8
    shape = (canvas.shape[0] * k, canvas.shape[1] * k)
    inside = fill_polygon((polygon + 0.5) * k - 0.5, shape).astype(np.float32)
    alpha = inside.reshape(canvas.shape[0], k, canvas.shape[1], k).mean(axis=(1, 3))[..., None]
    return np.rint(canvas * (1 - alpha) + np.array(colour) * alpha).astype(np.uint8)


def photograph(*, noise: float = 3.0, seed: int = 7, wall: tuple[int, int, int] = WALL) -> Photo:
    canvas = np.full((HEIGHT, WIDTH, 3), wall, np.uint8)
    return with_noise(draw(canvas, ellipse(), SKIN), noise, seed)


def with_noise(photo: Photo, noise: float, seed: int) -> Photo:
    rng = np.random.default_rng(seed)
    return np.clip(np.rint(photo + rng.normal(0, noise, photo.shape)), 0, 255).astype(np.uint8)


def rough_mask(*, shift: float = 3.0, blur: float = 4.0) -> NDArray[np.float32]:
    """Return a mask whose contour waves ``shift`` px about the truth, softly."""
    t = np.linspace(0, 2 * np.pi, 4000, endpoint=False)
    wave = 1.0 + shift * np.sin(7 * t)[:, None] / AXES
    polygon = CENTRE + wave * (ellipse() - CENTRE)
    hard = fill_polygon(polygon, (HEIGHT, WIDTH)).astype(np.float32)
    return cv2.GaussianBlur(hard, (0, 0), blur)
