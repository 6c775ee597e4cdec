"""Both rims of a spectacle frame, fitted to a picture of it.

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

#: Reads how much is frame at points (..., 2), mm.
Reader = Callable[[Array], Array]

#: A lens: logarithms of half its width and half its height, mm; how it leans, radians; how much it narrows downwards;
#: logarithms of the powers of its quarters, from up and outwards round to down and outwards. Usual lenses are 48 to
#: 56 mm wide and two thirds as high; how far others differ, one standard deviation (taste).
USUAL_LENS: Final = np.array([np.log(25.0), np.log(17.0), 0.0, 0.0, *4 * [np.log(2.6)]])
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


@dataclass(slots=True, eq=False)
class Rims:
    """Both rims while they are fitted, in the wearer's left's frame.

    Attributes
    ----------
    eyes_mm : (2, 2)
    lens : (8,) as `USUAL_LENS`
    moved : (4,) of both lenses from the eyes: apart, up, aside, round, mm
    """

    eyes_mm: Array
    lens: Array
    moved: Array

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


def fit_rims(rims: Rims, read: Callable[[Array, float, Array], Array]) -> float:
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


def frame_starts(at: Reader, middle_mm: Array, sign: float, rim_mm: Array) -> Array:
    """Return how far outwards of a rim rays meet the frame of a clear lens, (POINTS,) mm; NaN where they do not."""
    share, radii, cosines = _ray_profiles(at, middle_mm, sign, rim_mm)
    frame = share > 0.5
    return np.where(frame.any(axis=1), (REACH_MM[frame.argmax(axis=1)] - radii) * cosines, np.nan)


def lens_ends(at: Reader, middle_mm: Array, sign: float, rim_mm: Array) -> Array:
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


def frame_bands(at: Reader, across_mm: float, middle_mm: Array, sign: float, rim_mm: Array) -> Array:
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


def thickness_mm(at: Reader, rims: Rims) -> float:
    """Return the frame's thickness, mm: its width at half height, the median over the points where it is seen."""
    rim = rim_points_mm(rims.lens)
    reach = np.arange(-THICK_MM[1], THICK_MM[1], STEP_MM)
    sides = zip(rims.middles_mm, SIDES, strict=True)
    profiles = np.concatenate([_across_profiles(at, middle, sign, rim, reach) for middle, sign in sides])
    widths = [half_width_mm(profile, np.abs(reach) < SEEN_MM) for profile in profiles]
    seen = [width for width in widths if width is not None and width < THICK_MM[1]]
    return float(np.clip(np.median(seen), *THICK_MM)) if seen else USUAL_THICK_MM


def half_width_mm(profile: Array, near: NDArray[np.bool_]) -> float | None:
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
