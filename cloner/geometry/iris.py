"""Colour of the irises, sampled in a photo."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def sample_iris(rgb: NDArray[np.uint8], centres_px: Array, radius_px: float) -> Array | None:
    """Return the median colour (3,) of the irises' rings, or None when they are too small or off the photo.

    The ring from 0.45 to 0.85 of the radius leaves out pupil and rim; its upper part lies under the lid, so only what
    is below 0.3 radius above the middle counts; the brightest tenth are reflections.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    centres_px : (N, 2)
    radius_px : float
    """
    if radius_px < 3.0:
        return None
    samples = []
    height, width = rgb.shape[:2]
    reach = int(np.ceil(radius_px))
    for x, y in centres_px:
        columns = np.arange(round(x) - reach, round(x) + reach + 1)
        rows = np.arange(round(y) - reach, round(y) + reach + 1)
        if columns[0] < 0 or rows[0] < 0 or columns[-1] >= width or rows[-1] >= height:
            continue
        grid_x, grid_y = np.meshgrid(columns, rows)
        away = np.hypot(grid_x - x, grid_y - y) / radius_px
        ring = (away > 0.45) & (away < 0.85) & (grid_y - y > -0.3 * radius_px)
        samples.append(rgb[grid_y[ring], grid_x[ring]].astype(np.float64))
    if not samples:
        return None
    colours = np.concatenate(samples)
    light = colours.sum(axis=1)
    return np.asarray(np.median(colours[light <= np.quantile(light, 0.9)], axis=0))
