"""Evidence that an edge separates person and background, from the colours on both sides of it.

A strong edge inside the shirt, or a poster's border just behind it, has the same kind of colour on
both sides as the surely-inside, or as the surely-outside, beside it.  The outline has not.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.vision.contours.edges import sample
from cloner.vision.contours.loops import MaskLoop

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Image = NDArray[np.float32]

#: How far from the contour, in band widths, colours are taken as surely inside or outside.
SURE_DEPTHS = (1.0, 1.5, 2.0, 2.5)
#: Probability beyond which a sample counts as surely inside; below one minus it, outside.
SURE_PROBABILITY = 0.85
#: Stations of the colour model on either side of an edge point, one per half band width.
REACH = 8
#: Colour distances are blurred by this many grey levels: shading and noise.  Measurement.
COLOUR_NOISE = 8.0
#: Where an edge point's own two sides are read, px: past the blur of the edge itself.
SIDE_STEP_PX = 2.5
#: Value of the product of both sides' evidence that counts as certain.
CERTAIN = 0.64


@dataclass(frozen=True, slots=True, eq=False)
class ColourModel:
    """Samples of certain inside and outside colours at stations along a contour.

    Attributes
    ----------
    inside, outside : ndarray, shape (K, D, 3), float64
        Colours at D depths; NaN where the mask is not sure.
    step : float
        Contour points per station.
    """

    inside: Floats
    outside: Floats
    step: float


def colour_model(smooth: Image, mask: Image, loop: MaskLoop, *, band_px: float) -> ColourModel:
    """Sample the colours on both sides of a contour where the mask is sure of them.

    Parameters
    ----------
    smooth : ndarray, shape (H, W, 3), float32
        The photo, blurred a little, grey levels.
    mask : ndarray, shape (H, W), float32
        Person probability 0..1.
    loop : MaskLoop
    band_px : float
        Half width of the vicinity band, px.
    """
    count = max(round(len(loop.points) / max(band_px / 2, 1.0)), 1)
    at = (np.arange(count) * len(loop.points) / count).astype(np.intp)
    sides = []
    height, width = mask.shape
    for sign in (1.0, -1.0):
        reach = sign * band_px * np.array(SURE_DEPTHS)
        points = loop.points[at, None] + reach[None, :, None] * loop.inward[at, None]
        flat = points.reshape(-1, 2)
        colours = sample(smooth, flat)
        probability = sample(mask, flat)
        sure = probability > SURE_PROBABILITY if sign > 0 else probability < 1 - SURE_PROBABILITY
        seen = ((flat >= 0) & (flat <= [width - 1, height - 1])).all(axis=1)
        colours[~(sure & seen)] = np.nan
        sides.append(colours.reshape(count, len(SURE_DEPTHS), 3))
    return ColourModel(sides[0], sides[1], len(loop.points) / count)


def _nearest_colour(colours: Floats, known: Floats, stations: Ints) -> Floats:
    """Return the distance of each colour from the nearest known one around its station."""
    around = (stations[:, None] + np.arange(-REACH, REACH + 1)) % len(known)
    around = np.unique(around, axis=1) if len(known) <= 2 * REACH else around
    best = np.full(len(colours), np.inf)
    for depth in range(known.shape[1]):
        gap = known[around, depth] - colours[:, None]
        square = np.einsum("nkc,nkc->nk", gap, gap)
        best = np.fmin(best, np.fmin.reduce(square, axis=1))
    return np.asarray(np.sqrt(best))


def colour_side_evidence(
    smooth: Image,
    model: ColourModel,
    points_px: Floats,
    inward: Floats,
    nearest: Ints,
) -> Floats:
    """Return how well edge points separate inside from outside colours.

    Parameters
    ----------
    smooth : ndarray, shape (H, W, 3), float32
        The photo, blurred a little, grey levels.
    model : ColourModel
    points_px : ndarray, shape (P, 2), float64
        Edge points, px.
    inward : ndarray, shape (P, 2), float64
        Unit vectors across the edge towards the person.
    nearest : ndarray, shape (P,), intp
        Index of the nearest contour point.

    Returns
    -------
    ndarray, shape (P,), float64
        0..1; 1 where one side looks like the person and the other like the background, about
        0.4 where the colours do not tell, near 0 for edges inside the person or behind it.
    """
    stations = (nearest / model.step).astype(np.intp) % len(model.inside)
    likeness = []
    for sign in (1.0, -1.0):
        colours = sample(smooth, points_px + sign * SIDE_STEP_PX * inward)
        inner = _nearest_colour(colours, model.inside, stations) + COLOUR_NOISE
        outer = _nearest_colour(colours, model.outside, stations) + COLOUR_NOISE
        known = np.isfinite(inner) & np.isfinite(outer)
        ratio = np.divide(outer, inner + outer, out=np.full(len(outer), 0.5), where=known)
        likeness.append(ratio if sign > 0 else 1.0 - ratio)
    return np.asarray(np.minimum(likeness[0] * likeness[1] / CERTAIN, 1.0))
