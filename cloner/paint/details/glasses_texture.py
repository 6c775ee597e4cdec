"""The picture of glasses: the photo's own colours along rims and bridge and on dark lenses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.frames import mm_from_m
from cloner.geometry.meshes.vectors import arc_lengths, places_along
from cloner.paint.details.frame_shape import FrameShape
from cloner.paint.details.rims import SIDES, outward_normals
from cloner.records.arrays import Array

#: Texels around a rod and along it, and of a lens' side.
BAND_PX, WIDE_PX, LENS_PX = 12, 256, 128
#: Rods: two rims, the bridge, two temples.
RODS: Final = 5
#: A rod is looked at so far from its middle, as a share of its half width: its edge is half skin.
INNER: Final = 0.75
#: From what a place shows of the frame on its colour is believed a little, and wholly.
FRAME_SHARES: Final = (0.5, 0.8)

#: Samples the photo at points (N, 2) of the frame's plane, mm from the nasion: colours (N, 3), levels, and how much is
#: frame (N,), 0 to 1.
Sampler = Callable[[Array], tuple[NDArray[np.float32], Array]]


@dataclass(frozen=True, slots=True, eq=False)
class Picture:
    """A picture of glasses.

    Attributes
    ----------
    rgba : (H, WIDE_PX, 4) uint8
        A band a rod from the top, then both lenses side by side where they are dark.
    """

    rgba: NDArray[np.uint8]

    def uv(self, uv: Array, part: int) -> Array:
        """Return where the uv (N, 2) of a part lie in the picture: rods by their place in `RODS`, then lenses."""
        height, width = self.rgba.shape[:2]
        if part < RODS:
            corner, size = (0, part * BAND_PX), (WIDE_PX, BAND_PX)
        else:
            corner, size = ((part - RODS) * LENS_PX, RODS * BAND_PX), (LENS_PX, LENS_PX)
        return np.asarray((np.array(corner) + 0.5 + uv * (np.array(size) - 1.0)) / (width, height))


def paint_glasses(shape: FrameShape, at: Sampler) -> Picture:
    """Return the picture of a frame: what one rim hides the other one shows, and temples have the rims' mean colour."""
    rims = [_rim_band(shape, sign, middle, at) for sign, middle in zip(SIDES, shape.middles_m, strict=True)]
    colours, weights = (np.stack([rim[k] for rim in rims]) for k in (0, 1))
    mean = _usual_colour(colours, weights)
    other = _blend(mean, colours[::-1], weights[::-1])
    bands = [*_blend(other, colours, weights), _blend(mean, *_bridge_band(shape, at))]
    bands += [np.broadcast_to(mean, (BAND_PX, WIDE_PX, 3))] * (RODS - len(bands))
    rows = [np.concatenate(bands)]
    if shape.dark:
        rows.append(np.concatenate([_lens_picture(shape, k, at) for k in range(len(SIDES))], axis=1))
    rgb = np.clip(np.rint(np.concatenate(rows)), 0.0, 255.0).astype(np.uint8)
    return Picture(np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)]))


def _blend(below: Array, colours: Array, weights: Array) -> Array:
    """Return colours (..., 3) over others by weights (...)."""
    return np.asarray(below + weights[..., None] * (colours - below))


def _usual_colour(colours: Array, weights: Array) -> Array:
    """Return the median (3,) of the colours (..., 3) that are believed, of all where none is."""
    sure = weights > 0.5
    return np.asarray(np.median(colours[sure] if sure.any() else colours.reshape(-1, 3), axis=0))


def _read(at: Sampler, places_m: Array) -> tuple[Array, Array]:
    """Return colours (h, w, 3) at places (h, w, 2), and how far they are believed (h, w)."""
    colours, frame = at(mm_from_m(1.0) * places_m.reshape(-1, 2))
    weights = np.clip((frame - FRAME_SHARES[0]) / (FRAME_SHARES[1] - FRAME_SHARES[0]), 0.0, 1.0)
    return colours.reshape(*places_m.shape[:-1], 3).astype(float), weights.reshape(places_m.shape[:-1])


def _band_places(path_m: Array, outward: Array, half_m: float) -> Array:
    """Return where the texels (BAND_PX, WIDE_PX, 2) of a rod lie: around it and back, along its path (K, 2)."""
    length = arc_lengths(path_m)
    wanted = np.linspace(0.0, length[-1], WIDE_PX)
    middle, way = (places_along(each, length, wanted) for each in (path_m, outward))
    aside = INNER * half_m * np.cos(np.linspace(0.0, 2.0 * np.pi, BAND_PX))
    return np.asarray(middle + aside[:, None, None] * way)


def _rim_band(shape: FrameShape, sign: float, middle_m: Array, at: Sampler) -> tuple[Array, Array]:
    """Return the colours (BAND_PX, WIDE_PX, 3) of a rim, and how far they are believed."""
    rim, outward = (np.concatenate([each, each[:1]]) for each in (shape.rim_m, outward_normals(shape.rim_m)))
    mirrored = np.array([sign, 1.0])
    return _read(at, _band_places(rim * mirrored + middle_m, outward * mirrored, 0.5 * shape.thick_m))


def _bridge_band(shape: FrameShape, at: Sampler) -> tuple[Array, Array]:
    """Return the colours (BAND_PX, WIDE_PX, 3) of the bridge, and how far they are believed."""
    inner = float(shape.rim_m[:, 0].min())
    ends = shape.middles_m + np.column_stack([np.multiply(SIDES, inner), np.full(2, shape.bridge_m[0])])
    return _read(at, _band_places(ends, np.tile([0.0, 1.0], (2, 1)), 0.5 * float(shape.bridge_m[1])))


def _lens_picture(shape: FrameShape, side: int, at: Sampler) -> Array:
    """Return the colours (LENS_PX, LENS_PX, 3) of a dark lens; what hides it takes the lens' mean colour."""
    half = np.linspace(-1.0, 1.0, LENS_PX)
    across, down = np.meshgrid(half, half)
    steps = np.arctan2(down, across) / (2.0 * np.pi) * len(shape.rim_m)
    radius = np.minimum(np.hypot(across, down), 1.0)
    turns = np.arange(len(shape.rim_m) + 1)
    rim = np.concatenate([shape.rim_m, shape.rim_m[:1]])
    edge = places_along(rim, turns.astype(float), np.mod(steps, len(shape.rim_m)).ravel()).reshape(LENS_PX, LENS_PX, 2)
    colours, weights = _read(at, shape.middles_m[side] + radius[..., None] * edge * (SIDES[side], 1.0))
    return _blend(_usual_colour(colours, weights), colours, weights)
