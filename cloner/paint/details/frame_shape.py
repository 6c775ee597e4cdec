"""The shape of a spectacle frame: two rims, bridge and hinges, fitted to a picture of it.

A photo shows some of a thin frame, some of it behind hair and some of it as brows: both rims are one shape, mirrored,
a superellipse whose quarters are squarer or rounder each, which may lean and taper, fitted to what both sides show.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.frames import m_from_mm
from cloner.geometry.meshes.vectors import arc_lengths, places_along, unit
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample

#: Reads how much is frame at points (..., 2), mm.
Reader = Callable[[Array], Array]

#: A lens: logarithms of half its width and half its height, mm; how it leans, radians; how much it narrows downwards;
#: logarithms of the powers of its quarters, from up and outwards round to down and outwards. Usual lenses are 48 to
#: 56 mm wide and two thirds as high; how far others differ, one standard deviation (taste).
USUAL_LENS: Final = np.log([25.0, 17.0, 1.0, 1.0, 2.6, 2.6, 2.6, 2.6])
DIFFER: Final = np.array([0.2, 0.4, 0.08, 0.1, 0.3, 0.3, 0.3, 0.3])
#: Roundest and squarest quarter, logarithms of the powers.
POWERS: Final = (np.log(1.7), np.log(6.0))
#: A usual frame's thickness, mm.
USUAL_THICK_MM: Final = 2.5
#: Points of a rim, and of the curve they are taken from.
POINTS, FINE_POINTS = 72, 360
#: Distances along a ray from a lens' middle: where from, where to, how fine, mm.
NEAREST_MM, FARTHEST_MM, STEP_MM = 5.0, 42.0, 0.25
REACH_MM: Final = np.arange(NEAREST_MM, FARTHEST_MM, STEP_MM)
#: How far a point of the rim may lie off before it counts less, mm, in the first and in the last round.
DOUBT_MM: Final = (6.0, 1.5)
#: A band is looked for so near to the rim so far, mm, and stands out of what is beside by more.
NEAR_MM, STANDS = 6.0, 0.3
#: Weight against one point of lenses that stay where the eyes are: apart, up, aside, round.
HELD: Final = np.array([0.5, 0.5, 10.0, 60.0])
ROUNDS: Final = 12
#: How both lenses' places (x, y, x, y) change as they move apart, up, aside and round.
MOVES: Final = np.array([[1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 1.0], [-1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, -1.0]])
#: The wearer's left and right: what is on the right is mirrored.
SIDES: Final = (1.0, -1.0)
#: A rim is seen where frame is met within so much of it, mm, and made out from this share of its points on.
SEEN_MM, LEAST_SEEN = 3.0, 0.3
#: Thinnest and thickest frame believed, mm.
THICK_MM = (1.0, 8.0)
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


@dataclass(slots=True, eq=False)
class Rims:
    """Both rims while they are fitted, in the wearer's left's frame.

    Attributes
    ----------
    eyes_mm : (2, 2)
    lens : (8,) as `USUAL_LENS`
    moved : (4,) of both lenses from the eyes: apart, up, aside, round, mm
    seen : float
        Share of the points that lie where the picture shows frame on one side at least.
    """

    eyes_mm: Array
    lens: Array
    moved: Array
    seen: float = 0.0

    @property
    def middles_mm(self) -> Array:
        """The middles (2, 2) of the lenses."""
        return np.asarray(self.eyes_mm + (MOVES @ self.moved).reshape(2, 2))


def rim_points_mm(lens: Array) -> Array:
    """Return points (POINTS, 2) of a left rim against its middle, mm, evenly from outwards over up."""
    turn = np.linspace(0.0, 2.0 * np.pi, FINE_POINTS + 1)
    power = 2.0 / np.exp(lens[4:])[np.minimum(4 * np.arange(FINE_POINTS + 1) // FINE_POINTS, 3)]
    wave = np.column_stack([np.cos(turn), np.sin(turn)])
    unit_rim = np.sign(wave) * np.abs(wave) ** power[:, None]
    unit_rim[:, 0] *= 1.0 + lens[3] * unit_rim[:, 1]
    curve = unit_rim * np.exp(lens[:2]) @ np.array([
        [np.cos(lens[2]), np.sin(lens[2])], [-np.sin(lens[2]), np.cos(lens[2])]
    ])  # fmt: skip
    length = arc_lengths(curve)
    return places_along(curve, length, np.linspace(0.0, length[-1], POINTS, endpoint=False))


def usual_rims_m(eyes_m: Array) -> Array:
    """Return points (N, 2) of usual rims around both eyes (2, 2), metres."""
    rim = m_from_mm(1.0) * rim_points_mm(USUAL_LENS)
    return np.concatenate([eye + rim * (sign, 1.0) for eye, sign in zip(eyes_m, SIDES, strict=True)])


def outward_normals(rim: Array) -> Array:
    """Return unit normals (N, 2) of a closed rim (N, 2) that runs from outwards over up."""
    along = np.roll(rim, -1, axis=0) - np.roll(rim, 1, axis=0)
    return unit(np.column_stack([along[:, 1], -along[:, 0]]))


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
    rays = _lens_ends if dark else _frame_starts
    seen = _iterate_fit(rims, lambda middle, sign, rim: rays(at, middle, sign, rim))
    across = USUAL_THICK_MM
    if dark:
        rims.lens[:2] = np.log(np.exp(rims.lens[:2]) - 0.5 * across)
    else:
        for reader in (at, coloured):
            across = _thickness_mm(reader, rims)
            seen = _iterate_fit(rims, lambda middle, sign, rim, wide=across: _bands(at, middle, sign, rim, wide))
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


def _iterate_fit(rims: Rims, read: Callable[[Array, float, Array], Array]) -> float:
    """Fit the rims; return the share of their points at which frame lies on one side at least.

    ``read`` gives how far outwards of the points (POINTS, 2) of a rim the frame lies, mm, by the lens' middle and its
    side; NaN where nothing is met.
    """
    away = np.full((2, POINTS), np.nan)
    for doubt in np.geomspace(*DOUBT_MM, ROUNDS):
        rim = rim_points_mm(rims.lens)
        away = np.stack([read(middle, sign, rim) for middle, sign in zip(rims.middles_mm, SIDES, strict=True)])
        step = _rim_step(rims, rim, away, doubt)
        rims.lens = rims.lens + step[:-4]
        rims.lens[4:] = np.clip(rims.lens[4:], *POWERS)
        rims.moved = rims.moved + step[-4:]
    return float((np.abs(away) < SEEN_MM).any(axis=0).mean())


def _rim_step(rims: Rims, rim_mm: Array, away_mm: Array, doubt_mm: float) -> Array:
    """Return one Gauss-Newton step (12,) of the lens and of both lenses' places towards what is read (2, POINTS)."""
    normals = outward_normals(rim_mm)
    small = 1e-4
    moved = [rim_points_mm(rims.lens + small * row) - rim_mm for row in np.eye(len(rims.lens))]
    shape = np.stack([(one * normals).sum(axis=1) / small for one in moved], axis=1)
    # apart, up, aside, round: on the right side, which is mirrored, the last two are the other way round
    along = np.column_stack([normals, normals])
    places = along, along * (1.0, 1.0, -1.0, -1.0)
    weights = np.sqrt(np.nan_to_num(1.0 / (1.0 + (away_mm / doubt_mm) ** 2)))
    rows = [np.column_stack([shape, place]) * one[:, None] for place, one in zip(places, weights, strict=True)]
    prior = np.concatenate([1.0 / DIFFER, np.sqrt(HELD)])
    held = prior * np.concatenate([USUAL_LENS - rims.lens, -rims.moved])
    values = np.concatenate([*(weights * np.nan_to_num(away_mm)), held])
    return np.asarray(np.linalg.lstsq(np.concatenate([*rows, np.diag(prior)]), values, rcond=None)[0])


def _ray_profiles(at: Reader, middle_mm: Array, sign: float, rim_mm: Array) -> tuple[Array, Array, Array]:
    """Return the frame's share (POINTS, R) along rays through a rim's points, their radii and cosines (POINTS,)."""
    ways = unit(rim_mm)
    places = middle_mm + REACH_MM[None, :, None] * (ways * (sign, 1.0))[:, None, :]
    share = np.where(sign * places[..., 0] > 0.0, at(places), 0.0)  # beyond the nose is the other lens
    return share, np.linalg.norm(rim_mm, axis=1), (ways * outward_normals(rim_mm)).sum(axis=1)


def _frame_starts(at: Reader, middle_mm: Array, sign: float, rim_mm: Array) -> Array:
    """Return how far outwards of a rim rays meet the frame of a clear lens, (POINTS,) mm; NaN where they do not."""
    share, radii, cosines = _ray_profiles(at, middle_mm, sign, rim_mm)
    frame = share > 0.5
    return np.where(frame.any(axis=1), (REACH_MM[frame.argmax(axis=1)] - radii) * cosines, np.nan)


def _lens_ends(at: Reader, middle_mm: Array, sign: float, rim_mm: Array) -> Array:
    """Return how far outwards of a rim rays leave a dark lens, (POINTS,) mm; NaN where they do not."""
    share, radii, cosines = _ray_profiles(at, middle_mm, sign, rim_mm)
    clear = share <= 0.5
    met = ~clear[:, 0] & clear.any(axis=1)
    return np.where(met, (REACH_MM[clear.argmax(axis=1)] - radii) * cosines, np.nan)


def _across_profiles(at: Reader, middle_mm: Array, sign: float, rim_mm: Array, reach_mm: Array) -> Array:
    """Return the frame's share (POINTS, R) across a rim, at distances (R,) outwards of it, mm."""
    points = rim_mm[:, None] + reach_mm[None, :, None] * outward_normals(rim_mm)[:, None]
    places = middle_mm + points * (sign, 1.0)
    return np.where(sign * places[..., 0] > 0.0, at(places), 0.0)


def _bands(at: Reader, middle_mm: Array, sign: float, rim_mm: Array, across_mm: float) -> Array:
    """Return how far outwards of a rim the strongest band of the frame's thickness lies, (POINTS,) mm; NaN where none.

    Lashes are thinner and a brow that touches the frame is thicker than it.
    """
    wide, beside = (max(round(size / STEP_MM), 1) for size in (across_mm, 0.5 * across_mm))
    ends = NEAR_MM + across_mm
    reach = np.arange(-ends, ends, STEP_MM)
    total = np.cumsum(np.pad(_across_profiles(at, middle_mm, sign, rim_mm, reach), ((0, 0), (1, 0))), axis=1)
    starts = np.arange(beside, len(reach) - wide - beside)

    def mean(first: NDArray[np.int64], count: int) -> Array:
        return (total[:, first + count] - total[:, first]) / count

    stands = mean(starts, wide) - 0.5 * (mean(starts - beside, beside) + mean(starts + wide, beside))
    middles = reach[starts] + 0.5 * STEP_MM * (wide - 1)
    return np.where(stands.max(axis=1) > STANDS, middles[stands.argmax(axis=1)], np.nan)


def _thickness_mm(at: Reader, rims: Rims) -> float:
    """Return the frame's thickness, mm: its width at half height, the median over the points where it is seen."""
    rim = rim_points_mm(rims.lens)
    reach = np.arange(-THICK_MM[1], THICK_MM[1], STEP_MM)
    sides = zip(rims.middles_mm, SIDES, strict=True)
    profiles = np.concatenate([_across_profiles(at, middle, sign, rim, reach) for middle, sign in sides])
    widths = [_half_width_mm(profile, np.abs(reach) < SEEN_MM) for profile in profiles]
    seen = [width for width in widths if width is not None and width < THICK_MM[1]]
    return float(np.clip(np.median(seen), *THICK_MM)) if seen else USUAL_THICK_MM


def _half_width_mm(profile: Array, near: NDArray[np.bool_]) -> float | None:
    """Return the width of a peak of a profile (R,) at half its height; None where none stands out near its middle."""
    peak = int(np.where(near, profile, -np.inf).argmax())
    base = max(float(profile[:peak].min(initial=1.0)), float(profile[peak:].min()))
    if profile[peak] - base < STANDS:
        return None
    low = profile < 0.5 * (profile[peak] + base)
    before, after = np.flatnonzero(low[:peak]), np.flatnonzero(low[peak:])
    if not before.size or not after.size:
        return None
    return STEP_MM * float(peak + after[0] - before[-1] - 1)


def _bridge_mm(at: Reader, coloured: Reader, middles_mm: Array, rim_mm: Array, across_mm: float) -> Array:
    """Return the bridge's height over the centres of the lenses, and its thickness, mm."""
    low, high = float(rim_mm[:, 1].min()), float(rim_mm[:, 1].max())
    rise = np.arange(low, high, STEP_MM)
    between = middles_mm.mean(axis=0) + np.column_stack([np.zeros(len(rise)), rise])
    frame = at(between) > 0.5
    if not frame.any():
        return np.array([BRIDGE * high, across_mm])
    thick = _half_width_mm(coloured(between), frame)
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
