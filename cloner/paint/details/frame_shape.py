"""The shape of a spectacle frame: two rims, bridge and hinges, fitted to a picture of it.

A photo shows some of a thin frame, some of it behind hair and some of it as brows: both rims are one shape, mirrored,
smooth and closed, fitted to what both sides show.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.frames import m_from_mm
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample

#: Reads how much is frame at points (..., 2), mm.
Reader = Callable[[Array], Array]

#: Half the width and half the height of a usual lens, and the power of its superellipse; a frame's usual thickness, mm
#: (lenses are 48 to 56 mm wide and two thirds as high: taste).
USUAL_MM, SQUARE, USUAL_THICK_MM = (25.0, 17.0), 2.6, 2.5
#: Rays from a lens' middle: how many, from where to where, how fine, mm.
RAYS: Final = 72
NEAREST_MM, FARTHEST_MM, STEP_MM = 8.0, 42.0, 0.25
#: Harmonics of a rim's radius; corners need four.
HARMONICS: Final = 6
#: Weight of the usual shape against one ray, and how far a ray may lie off before it counts less, mm.
PRIOR, DOUBT_MM = 0.15, 1.5
#: Distances along a ray; a band is looked for so near to the rim so far, mm, and stands out of what is beside by more.
REACH_MM: Final = np.arange(NEAREST_MM, FARTHEST_MM, STEP_MM)
NEAR_MM, STANDS = 6.0, 0.3
#: Weight against one ray of lenses that stay where the eyes are: apart, up, aside, round.
HELD: Final = np.array([0.5, 0.5, 10.0, 60.0])
ROUNDS: Final = 8
#: How both lenses' places (x, y, x, y) change as they move apart, up, aside and round.
MOVES: Final = np.array([[1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 1.0], [-1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, -1.0]])
#: The wearer's left and right: what is on the right is mirrored.
SIDES: Final = (1.0, -1.0)
#: A rim is seen where a ray meets frame within so much of it, mm, and made out from this share of rays on.
SEEN_MM, LEAST_SEEN = 3.0, 0.3
#: Thinnest and thickest frame believed, mm.
THICK_MM = (1.0, 8.0)
#: Lenses are dark where frame covers this share of their middle.
DARK: Final = 0.6
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
    rim_m : (RAYS, 2)
        The middle of the left rim against its lens' middle, by angle from outwards over up; the right one is mirrored.
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


def angles() -> Array:
    """Return the angles (RAYS,) of the rays, radians: 0 is outwards, a quarter turn is up."""
    return np.linspace(0.0, 2.0 * np.pi, RAYS, endpoint=False)


def usual_rim_mm() -> Array:
    """Return (RAYS,) radii of a usual lens, mm: a superellipse."""
    turn = angles()
    across, up = np.abs(np.cos(turn)) / USUAL_MM[0], np.abs(np.sin(turn)) / USUAL_MM[1]
    return np.asarray((across**SQUARE + up**SQUARE) ** (-1.0 / SQUARE))


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
    return bool(np.mean([at(eye + _disc_points(NEAREST_MM)).mean() for eye in eyes_mm]) > DARK)


def fit_frame(at: Reader, eyes_mm: Array, *, dark: bool) -> FrameShape | None:
    """Return the frame, None where too little of it is seen.

    Parameters
    ----------
    at : Reader
    eyes_mm : (2, 2)
        The left and the right eye in the plane, mm from the nasion.
    dark : bool
        Whether the lenses count as frame.
    """
    rays = _lens_ends if dark else _frame_starts
    radii = usual_rim_mm()
    radii, moved, measured = _iterate_fit(lambda middle, sign, _: rays(at, middle, sign), eyes_mm, radii, np.zeros(4))
    across = USUAL_THICK_MM
    if not dark:
        across = _thickness_mm(at, eyes_mm, radii, moved)
        radii, moved, measured = _iterate_fit(
            lambda middle, sign, rim: _strongest_bands(at, middle, sign, rim, across), eyes_mm, radii, moved
        )
    if (np.abs(measured - radii) < SEEN_MM).any(axis=0).mean() < LEAST_SEEN:
        return None
    radii = radii + (-0.5 if dark else 0.5) * across
    rim, middles = radii[:, None] * _ray_directions(), _lens_centres(eyes_mm, moved)
    usual = HINGE * float(rim[:, 1].max())
    hinges = [_hinge_mm(at, middle, rim, sign, across, usual) for middle, sign in zip(middles, SIDES, strict=True)]
    metre = m_from_mm(1.0)
    return FrameShape(
        metre * middles,
        metre * rim,
        metre * across,
        metre * _bridge_mm(at, middles, rim, across),
        metre * np.stack(hinges),
        dark,
    )


def _lens_centres(eyes_mm: Array, moved: Array) -> Array:
    """Return the lenses' centres (2, 2), mm, after a motion (4,): apart, up, sideways, rotation."""
    return np.asarray(eyes_mm + (MOVES @ moved).reshape(2, 2))


def _iterate_fit(
    read: Callable[[Array, float, Array], Array], eyes_mm: Array, radii_mm: Array, moved: Array
) -> tuple[Array, Array, Array]:
    """Return the rim (RAYS,), the lenses' motion (4,) and the last ray readings (2, RAYS), mm.

    ``read`` gives what the rays of a lens tell by its middle, its side and the rim so far.
    """
    known = np.zeros((2, RAYS))
    for _ in range(ROUNDS):
        lenses = zip(_lens_centres(eyes_mm, moved), SIDES, strict=True)
        known = np.stack([read(middle, sign, radii_mm) for middle, sign in lenses])
        radii_mm, more = _fit_rim(known, radii_mm)
        moved = moved + more
    return radii_mm, moved, known


def _thickness_mm(at: Reader, eyes_mm: Array, radii_mm: Array, moved: Array) -> float:
    """Return the frame's thickness, mm: the median over the rays that meet it at the rim."""
    runs = [_runs(at, middle, sign) for middle, sign in zip(_lens_centres(eyes_mm, moved), SIDES, strict=True)]
    first, last, met = (np.stack(each) for each in zip(*runs, strict=True))
    thick = STEP_MM * (last - first)
    measured_mm = thick[met & (np.abs(REACH_MM[first] - radii_mm) < SEEN_MM) & (thick < THICK_MM[1])]
    return float(np.clip(np.median(measured_mm), *THICK_MM)) if measured_mm.size else USUAL_THICK_MM


def _ray_directions() -> Array:
    """Return the rays' directions (RAYS, 2) on the wearer's left."""
    return np.column_stack([np.cos(angles()), np.sin(angles())])


def _disc_points(most_mm: float) -> Array:
    """Return (N, 2) points of a disc."""
    side = np.arange(-most_mm, most_mm + 1.0)
    points = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    return np.asarray(points[np.hypot(points[:, 0], points[:, 1]) < most_mm])


def _runs(at: Reader, middle_mm: Array, sign: float) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.bool_]]:
    """Return the steps (RAYS,) at which rays from a lens's centre enter and leave the frame, and which do both."""
    frame = _profiles(at, middle_mm, sign) > 0.5
    first = frame.argmax(axis=1)
    after = ~frame & (np.arange(len(REACH_MM)) > first[:, None])
    return first, after.argmax(axis=1), frame.any(axis=1) & after.any(axis=1)


def _frame_starts(at: Reader, middle_mm: Array, sign: float) -> Array:
    """Return where rays meet the frame of a clear lens, (RAYS,) mm; NaN where they do not."""
    first, _, met = _runs(at, middle_mm, sign)
    return np.where(met, REACH_MM[first], np.nan)


def _lens_ends(at: Reader, middle_mm: Array, sign: float) -> Array:
    """Return where rays leave a dark lens, (RAYS,) mm; NaN where they do not."""
    first, last, met = _runs(at, middle_mm, sign)
    return np.where(met & (first == 0), REACH_MM[last], np.nan)


def _strongest_bands(at: Reader, middle_mm: Array, sign: float, radii_mm: Array, across_mm: float) -> Array:
    """Return the strongest band of the frame's thickness on each ray near a rim, (RAYS,) mm; NaN where none.

    Lashes are thinner and a brow that touches the frame is thicker than it.
    """
    total = np.cumsum(np.pad(_profiles(at, middle_mm, sign), ((0, 0), (1, 0))), axis=1)
    wide, beside = (max(round(size / STEP_MM), 1) for size in (across_mm, 0.5 * across_mm))
    starts = np.arange(beside, total.shape[1] - 1 - wide - beside)

    def mean(first: NDArray[np.int64], count: int) -> Array:
        return (total[:, first + count] - total[:, first]) / count

    stands = mean(starts, wide) - 0.5 * (mean(starts - beside, beside) + mean(starts + wide, beside))
    stands[np.abs(REACH_MM[starts] - radii_mm[:, None]) > NEAR_MM] = -np.inf
    best = stands.argmax(axis=1)
    return np.where(stands.max(axis=1) > STANDS, REACH_MM[starts[best]], np.nan)


def _profiles(at: Reader, middle_mm: Array, sign: float) -> Array:
    """Return the frame's share (RAYS, R) along the rays at `REACH_MM`; beyond the nose is the other lens."""
    places = middle_mm + REACH_MM[None, :, None] * (_ray_directions() * (sign, 1.0))[:, None, :]
    return np.where(sign * places[..., 0] > 0.0, at(places), 0.0)


def _fit_rim(told_mm: Array, radii_mm: Array) -> tuple[Array, Array]:
    """Return a smooth rim (RAYS,) through the readings of both sides, and the motion of both lenses, mm.

    Lenses move apart and up together, and with the whole frame aside and round, of which little is believed.

    Parameters
    ----------
    told_mm : (2, RAYS), NaN where nothing is met
    radii_mm : (RAYS,) the rim so far
    """
    away = told_mm - radii_mm
    sure = np.nan_to_num(1.0 / (1.0 + (away / DOUBT_MM) ** 2))
    usual = usual_rim_mm()
    if np.isfinite(told_mm).any():
        usual = usual * np.exp(np.nanmedian(np.log(told_mm / usual)))
    turn = angles()
    # without the first harmonic, which moves a rim as a whole
    kept = [wave(k * turn) for k in range(2, HARMONICS + 1) for wave in (np.cos, np.sin)]
    waves = np.column_stack([np.ones(RAYS), *kept])
    # apart, up, aside, round: on the right side, which is mirrored, the last two are the other way round
    along = np.column_stack([_ray_directions(), _ray_directions()])
    moves = [along, along * (1.0, 1.0, -1.0, -1.0)]
    rows = [np.column_stack([waves, move]) * np.sqrt(one)[:, None] for move, one in zip(moves, sure, strict=True)]
    values = [np.sqrt(one) * np.nan_to_num(measured) for measured, one in zip(told_mm, sure, strict=True)]
    prior = np.sqrt(PRIOR) * np.column_stack([waves, np.zeros((RAYS, 4))])
    held = np.sqrt(HELD)[:, None] * np.eye(waves.shape[1] + 4)[-4:]
    solved = np.linalg.lstsq(
        np.concatenate([*rows, prior, held]),
        np.concatenate([*values, np.sqrt(PRIOR) * usual, np.zeros(4)]),
        rcond=None,
    )[0]
    return np.asarray(waves @ solved[:-4]), solved[-4:]


def _bridge_mm(at: Reader, middles_mm: Array, rim_mm: Array, across_mm: float) -> Array:
    """Return the bridge's height over the centres of the lenses, and its thickness, mm."""
    between = middles_mm.mean(axis=0)
    low, high = float(rim_mm[:, 1].min()), float(rim_mm[:, 1].max())
    rise = np.arange(low, high, STEP_MM)
    frame = at(between + np.column_stack([np.zeros(len(rise)), rise])) > 0.5
    if not frame.any():
        return np.array([BRIDGE * high, across_mm])
    return np.array([float(np.median(rise[frame])), float(np.clip(STEP_MM * frame.sum(), across_mm, THICK_MM[1]))])


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
