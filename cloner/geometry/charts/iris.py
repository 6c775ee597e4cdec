"""Colours of irises, sclera and skin around the eyes in a photo."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array
from cloner.records.labels import Label, shows

#: Outer and inner corner of both eyes in the 468-point face mesh.
EYE_CORNERS: Final = ((33, 133), (263, 362))
#: The white begins this far from an iris' middle, share of the eye's width: an iris of 11.7 mm in an opening of 30 mm.
WHITE_FROM: Final = 0.23
#: Fewer pixels tell no colour.
LEAST_PIXELS: Final = 12


def sample_iris(rgb: NDArray[np.uint8], labels: NDArray[np.uint8], centres_px: Array, radius_px: float) -> Array | None:
    """Return the median colour (3,) of the irises' rings, None when too small, covered or outside the photo.

    The ring from 0.45 to 0.85 of the radius leaves out pupil and rim; the lid shades its upper half, which does not
    count; the brightest tenth are reflections.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    labels : (H, W) uint8
        Values of ``Label``: an iris behind hair or a frame by more than half does not count, and where the eyes are
        labelled nothing else does: lids and lashes are no iris.
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
        ring = (away > 0.45) & (away < 0.85) & (grid_y > y)
        colours, kinds = rgb[grid_y[ring], grid_x[ring]].astype(np.float64), labels[grid_y[ring], grid_x[ring]]
        veiled, eye = shows(kinds, Label.HAIR, Label.ACCESSORY), kinds == Label.EYES
        if veiled.mean() < 0.5:
            samples.append(colours[eye if eye.sum() >= LEAST_PIXELS else ~veiled])
    if not samples:
        return None
    colours = np.concatenate(samples)
    light = colours.sum(axis=1)
    return np.asarray(np.median(colours[light <= np.quantile(light, 0.9)], axis=0))


def sclera_to_skin(rgb: NDArray[np.uint8], labels: NDArray[np.uint8], face_px: Array, irises_px: Array) -> Array | None:
    """Return how much lighter the sclera is than the skin around the eyes, None where too little is seen.

    Lids shade the upper white and lashes its rim, so the lighter half of what lies beside the irises counts.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    labels : (H, W) uint8
        Values of ``Label``.
    face_px : (468, 2)
        Face mesh.
    irises_px : (2, 2)
        Centres of the irises.

    Returns
    -------
    (3,) float64
        Ratio of levels per channel.
    """
    width_px = _eye_px(face_px)
    white = labels == Label.EYES
    rows, columns = np.nonzero(white)
    if len(rows) < LEAST_PIXELS:
        return None
    away = np.stack([np.hypot(columns - x, rows - y) for x, y in irises_px]).min(axis=0)
    beside = (away > WHITE_FROM * width_px) & (away < width_px)
    skin_rgb = skin_around_eyes(rgb, labels, face_px, irises_px)
    if int(beside.sum()) < LEAST_PIXELS or skin_rgb is None:
        return None
    colours = rgb[rows[beside], columns[beside]].astype(np.float64)
    light = colours.sum(axis=1)
    lighter = np.median(colours[light >= np.median(light)], axis=0)
    return np.asarray(lighter / skin_rgb)


def skin_around_eyes(
    rgb: NDArray[np.uint8], labels: NDArray[np.uint8], face_px: Array, irises_px: Array
) -> Array | None:
    """Return the median colour (3,) of the skin around both eyes, at least 1 level, None where too little is seen.

    Parameters are those of :func:`sclera_to_skin`.
    """
    reach = int(_eye_px(face_px))
    top, left = max(int(irises_px[:, 1].min()) - reach, 0), max(int(irises_px[:, 0].min()) - reach, 0)
    box = np.s_[top : int(irises_px[:, 1].max()) + reach, left : int(irises_px[:, 0].max()) + reach]
    skin = rgb[box][labels[box] == Label.FACE_SKIN].astype(np.float64)
    return None if len(skin) < LEAST_PIXELS else np.maximum(np.median(skin, axis=0), 1.0)


def _eye_px(face_px: Array) -> float:
    """Return the width of an eye's opening, pixels."""
    return float(np.mean([np.hypot(*(face_px[a] - face_px[b])) for a, b in EYE_CORNERS]))
