"""The shape of a spectacle frame: two rims, bridge and hinges, fitted to a picture of it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from cloner.frames import m_from_mm
from cloner.paint.details.rims import (
    LEAST_SEEN,
    SIDES,
    STEP_MM,
    THICK_MM,
    USUAL_LENS,
    USUAL_THICK_MM,
    Reader,
    Rims,
    fit_rims,
    frame_bands,
    frame_starts,
    half_width_mm,
    lens_ends,
    rim_points_mm,
    thickness_mm,
)
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample

#: Lenses are dark where frame covers this share of this much of their middle, mm.
DARK, DARK_MM = 0.6, 8.0
#: Usual heights over the lens' middle of bridge and hinge, in halves of the lens' height.
BRIDGE, HINGE = 0.35, 0.45
#: How far beyond the rim a hinge lies at most, and usually, mm.
HINGE_MM = (12.0, 4.0)


@dataclass(frozen=True, slots=True, eq=False)
class FrameShape:
    """A frame in its own plane, x to the wearer's left and y up from the nasion, metres.

    Attributes
    ----------
    middles_m : (2, 2)
        Of the left and the right lens.
    rim_m : (POINTS, 2)
        The middle of the left rim against its lens' middle, from outwards over up; the right one is mirrored.
    thick_m : float
        Across the rim.
    bridge_m : (2,) height over the middle of the lenses, and thickness
    hinges_m : (2, 2)
        Of the left and the right temple.
    dark : bool
        Whether the lenses hide the eyes.
    """

    middles_m: Array
    rim_m: Array
    thick_m: float
    bridge_m: Array
    hinges_m: Array
    dark: bool


def picture_px(points_mm: Array, corner_mm: tuple[float, float], pixel_mm: float) -> Array:
    """Return the pixels (..., 2) of points of the frame's plane, mm, in a picture as `frame_reader` samples it."""
    return np.asarray((points_mm - corner_mm) * (1.0, -1.0) / pixel_mm)


def frame_reader(picture: NDArray[np.float32], corner_mm: tuple[float, float], pixel_mm: float) -> Reader:
    """Return a sampler of a picture of the frame's plane.

    Parameters
    ----------
    picture : (h, w) float32 in 0..1
        How much of each pixel is frame; rows run down, columns to the wearer's left.
    corner_mm : (x, y) of the first pixel, mm from the nasion
    pixel_mm : float
    """

    def at(points_mm: Array) -> Array:
        place = picture_px(points_mm, corner_mm, pixel_mm)
        return np.nan_to_num(sample(picture, place.reshape(-1, 2))[:, 0]).reshape(place.shape[:-1]).astype(np.float64)

    return at


def has_dark_lenses(at: Reader, eyes_mm: Array) -> bool:
    """Return whether the frame covers the eyes (2, 2), mm."""
    side = np.arange(-DARK_MM, DARK_MM + 1.0)
    square = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    disc = square[np.hypot(square[:, 0], square[:, 1]) < DARK_MM]
    return bool(np.mean([at(eye + disc).mean() for eye in eyes_mm]) > DARK)


def fit_frame(at: Reader, coloured: Reader, eyes_mm: Array, *, dark: bool) -> FrameShape | None:
    """Return the frame, None where too little of it is seen.

    Parameters
    ----------
    at : Reader
        By labels and colours.
    coloured : Reader
        By colours alone: labels exaggerate how thick a frame is.
    eyes_mm : (2, 2)
        The left and the right eye in the plane, mm from the nasion.
    dark : bool
        Whether the lenses count as frame.
    """
    rims = Rims(eyes_mm, USUAL_LENS.copy(), np.zeros(4))
    rays = lens_ends if dark else frame_starts
    seen = fit_rims(rims, partial(rays, at))
    across = USUAL_THICK_MM
    if dark:
        rims.lens[:2] = np.log(np.exp(rims.lens[:2]) - 0.5 * across)
    else:
        for reader in (at, coloured):
            across = thickness_mm(reader, rims)
            seen = fit_rims(rims, partial(frame_bands, at, across))
    if seen < LEAST_SEEN:
        return None
    rim, middles = rim_points_mm(rims.lens), rims.middles_mm
    usual = HINGE * float(rim[:, 1].max())
    hinges = [_hinge_mm(at, middle, rim, sign, across, usual) for middle, sign in zip(middles, SIDES, strict=True)]
    metre = m_from_mm(1.0)
    return FrameShape(
        metre * middles,
        metre * rim,
        metre * across,
        metre * _bridge_mm(at, coloured, middles, rim, across),
        metre * np.stack(hinges),
        dark,
    )


def _bridge_mm(at: Reader, coloured: Reader, middles_mm: Array, rim_mm: Array, across_mm: float) -> Array:
    """Return the bridge's height over the centres of the lenses, and its thickness, mm."""
    low, high = float(rim_mm[:, 1].min()), float(rim_mm[:, 1].max())
    rise = np.arange(low, high, STEP_MM)
    between = middles_mm.mean(axis=0) + np.column_stack([np.zeros(len(rise)), rise])
    frame = at(between) > 0.5
    if not frame.any():
        return np.array([BRIDGE * high, across_mm])
    thick = half_width_mm(coloured(between), frame)
    return np.array([float(np.median(rise[frame])), float(np.clip(thick or across_mm, *THICK_MM))])


def _hinge_mm(at: Reader, middle_mm: Array, rim_mm: Array, sign: float, across_mm: float, usual_mm: float) -> Array:
    """Return the position (2,) of a temple's hinge, mm."""
    end = float(rim_mm[:, 0].max()) + 0.5 * across_mm
    far = np.arange(end + 0.5, end + HINGE_MM[0], STEP_MM)
    rise = np.arange(float(rim_mm[:, 1].min()), float(rim_mm[:, 1].max()) + across_mm, STEP_MM)
    frame: NDArray[np.bool_] = np.greater(at(middle_mm + np.stack(np.meshgrid(sign * far, rise), axis=-1)), 0.5)
    if not frame.any():
        return middle_mm + (sign * (end + HINGE_MM[1]), usual_mm)
    out = np.flatnonzero(frame.any(axis=0))
    reach = far[out[-1]] if out[0] == 0 else end + HINGE_MM[1]
    return middle_mm + (sign * reach, float(np.median(np.broadcast_to(rise[:, None], frame.shape)[frame])))
