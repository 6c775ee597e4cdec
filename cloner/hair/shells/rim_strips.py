"""Photo strips along the outlines of a hair's shell, unrolled: roots below, ends above, the crown at the left.

Front and back photos show the rim that runs from ear to ear, side photos the one from forehead to nape.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d, uniform_filter1d

from cloner.frames import ViewId, mm_from_m
from cloner.hair.shells.mattes import Matte
from cloner.hair.shells.rims import STEP_MM, HalfOutline, Mesh, half_outlines
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array

#: Strips begin so deep in the shell, and size of a texel, mm.
ROOT_MM, TEXEL_MM = 8.0, 0.5
#: Photos of each rim, the best first: of front and back the face's has three times the pixels.
ACROSS: Final = (ViewId.FACE_FRONT, ViewId.BODY_FRONT, ViewId.BODY_BACK)
ALONG: Final = (ViewId.FACE_SIDE, ViewId.BODY_SIDE)
#: Where the halves of those rims lie around the head, degrees: left and right, forehead and nape.
LEFT, RIGHT, FOREHEAD, NAPE = 90, 270, 0, 180
#: The last share of a strip fades: farther out no photo's hair was believed.
FADE: Final = 0.25
#: Where more than this of that last share is hair, over so many mm of rim, a photo shows a wall like hair.
WALL_SHARE, BROAD_MM = 0.2, 40.0
#: Columns in which hair and wall look alike in more than the rest are unknown.
TOLD_SHARE: Final = 0.7
#: So many times the usual amount of hair and so many mm more, over as much of a rim, is a wall like hair too.
USUAL, SLACK_MM = 1.3, 2.0
#: Columns with less hair beyond the shell, mm, tell nothing of the usual amount.
LEAST_MM: Final = 0.5
#: Shorter runs of known columns tell nothing, mm.
RUN_MM: Final = 12.0
#: Of all rims' columns: of a wall that hides more nearly everything told is its own clutter (a dark fringe before dark
#: boards, .24, wore rods of it; curls and spikes before plain and cluttered walls have .39 to .85).
LEAST_KNOWN: Final = 0.3
#: A rim of fewer steps shows nothing.
FEWEST: Final = 3
#: Where hair begins and ends along a rim cards fade over so many mm; taste.
END_MM: Final = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class RimStrip:
    """The strip of one half outline.

    Attributes
    ----------
    rgba : (h, w, 4) float32, levels
        Colours of hair and its share; the crown in the first column, roots in the last row, `TEXEL_MM` a texel.
    known : (w,) bool
        Columns that some photo shows.
    """

    rgba: NDArray[np.float32]
    known: NDArray[np.bool_]


def make_strips(
    grown: Mesh,
    body_triangles: NDArray[np.int32],
    bodies: Mapping[ViewId, Array],
    views: list[HairView],
    mattes: Mapping[ViewId, Matte],
    reach_mm: float,
    crown_m: Array,
) -> dict[int, RimStrip]:
    """Return the strips along the outlines by azimuth (`LEFT` ...); nothing where none is known.

    Parameters
    ----------
    grown : vertices (N, 3) at rest, m, and triangles of the hair
    body_triangles : (T, 3)
    bodies : mapping of ViewId to (V, 3)
        The body as each photo shows it.
    views : list of HairView
    mattes : mapping of ViewId to Matte
    reach_mm : float
        How far hair stands out of its core (:func:`cloner.hair.shells.mattes.hair_rim_mm`).
    crown_m : (3,)
        A point below the crown, at rest.
    """
    found: dict[int, RimStrip] = {}
    by_view = {view.posed.view: view for view in views if view.flip_m is None}
    shown = [name for name in (*ACROSS, *ALONG) if name in by_view and name in mattes]
    for name in sorted(shown, key=lambda name: not mattes[name].clear):
        view, matte = by_view[name], mattes[name]
        posed = view.to_view(grown[0])
        top = view.to_view(crown_m[None])
        rims = half_outlines((posed, grown[1]), (bodies[name], body_triangles), view.posed.camera, top[0])
        for rim in rims or ():
            if len(rim.place_px) < FEWEST:
                continue
            half = len(rim.place_m) // 3 + 1
            way = view.to_rest(rim.place_m[:half]).mean(axis=0) - crown_m
            if name in ACROSS:
                side = LEFT if way[0] > 0.0 else RIGHT
            else:
                side = FOREHEAD if way[2] > 0.0 else NAPE
            strip = _strip(rim, matte, view.posed.camera.metres_per_pixel(top[0]), reach_mm)
            found[side] = _merged(found[side], strip) if side in found else strip
    found = _without_walls(found, reach_mm) if found else {}
    if not found or np.concatenate([strip.known for strip in found.values()]).mean() < LEAST_KNOWN:
        return {}
    if {LEFT, RIGHT} <= found.keys():  # heads are as hairy left as right
        found[LEFT], found[RIGHT] = _merged(found[LEFT], found[RIGHT]), _merged(found[RIGHT], found[LEFT])
    whole = {side: _fill_unknown(strip) for side, strip in found.items()}
    return {side: strip for side, strip in whole.items() if strip is not None}


def _without_walls(strips: Mapping[int, RimStrip], reach_mm: float) -> dict[int, RimStrip]:
    """Return strips without columns of far more hair than usual: there a photo shows a wall like hair."""
    amounts = {side: hair_beyond_mm(strip, reach_mm, BROAD_MM) for side, strip in strips.items()}
    known = np.concatenate([amounts[side][strip.known] for side, strip in strips.items()])
    shown = known[known > LEAST_MM]
    most = USUAL * float(np.median(shown)) + SLACK_MM if shown.size else np.inf
    return {side: RimStrip(strip.rgba, strip.known & (amounts[side] < most)) for side, strip in strips.items()}


def hair_beyond_mm(strip: RimStrip, reach_mm: float, over_mm: float) -> Array:
    """Return how much hair (w,) a strip's columns show beyond the shell, mm, over a length of outline."""
    hair_mm = strip.rgba[: round(reach_mm / TEXEL_MM), :, 3].sum(axis=0) / 255.0 * TEXEL_MM
    return np.asarray(uniform_filter1d(np.where(strip.known, hair_mm, 0.0), round(over_mm / TEXEL_MM)))


def _fill_unknown(strip: RimStrip) -> RimStrip | None:
    """Return a strip with unknown runs filled from the nearest known run, mirrored; None without any."""
    edges = np.flatnonzero(np.diff(strip.known.astype(np.int8), prepend=0, append=0)).reshape(-1, 2)
    runs = edges[np.ptp(edges, axis=1) >= round(RUN_MM / TEXEL_MM)]
    if not len(runs):
        return None
    columns = np.arange(len(strip.known))
    away = np.maximum(runs[:, 0] - columns[:, None], columns[:, None] - runs[:, 1] + 1).clip(0)
    first, end = runs[away.argmin(axis=1)].T
    back = np.mod(columns - first, 2 * (end - first))
    source = first + np.where(back < end - first, back, 2 * (end - first) - 1 - back)
    return RimStrip(strip.rgba[:, source], np.ones_like(strip.known))


def _strip(rim: HalfOutline, matte: Matte, pixel_m: float, reach_mm: float) -> RimStrip:
    """Return one photo's strip along an outline."""
    columns = round(STEP_MM / TEXEL_MM)
    along = np.arange((len(rim.place_px) - 1) * columns) / columns
    row = np.floor(along).astype(int)
    share = (along - row)[:, None]
    place = rim.place_px[row] * (1.0 - share) + rim.place_px[row + 1] * share
    out = rim.outward[row] * (1.0 - share) + rim.outward[row + 1] * share
    free = np.asarray(rim.free[row] | rim.free[row + 1], np.float64)
    away_mm = np.arange(reach_mm, -ROOT_MM, -TEXEL_MM)
    pixel = place[None] + out[None] * (away_mm / mm_from_m(pixel_m))[:, None, None]
    at = matte.window_px(pixel.reshape(-1, 2)).reshape(*pixel.shape).astype(np.float32)
    rgb, alpha, separable = (
        cv2.remap(picture, at[..., 0], at[..., 1], cv2.INTER_LINEAR)
        for picture in (matte.rgb, matte.share, matte.separable.astype(np.float32))
    )
    height, width = matte.share.shape
    inside = np.all((at >= 0.0) & (at <= np.array([width - 1.0, height - 1.0])), axis=-1)
    alpha = np.where(inside, alpha, 0.0)
    outer = uniform_filter1d(alpha[away_mm > (1.0 - FADE) * reach_mm].mean(axis=0), round(BROAD_MM / TEXEL_MM))
    known = inside.all(axis=0) & (outer < WALL_SHARE) & (separable[away_mm > 0.0].mean(axis=0) > TOLD_SHARE)
    fade = np.clip((reach_mm - away_mm) / (FADE * reach_mm), 0.0, 1.0)
    alpha = alpha * fade[:, None] * gaussian_filter1d(free, END_MM / TEXEL_MM)
    return RimStrip(np.dstack([np.where(inside[..., None], rgb, 0.0), 255.0 * alpha]).astype(np.float32), known)


def _merged(first: RimStrip, second: RimStrip) -> RimStrip:
    """Return a strip with the unknown parts of the first filled by the second."""
    width = max(first.rgba.shape[1], second.rgba.shape[1])
    rgba, known = np.zeros((first.rgba.shape[0], width, 4), np.float32), np.zeros(width, np.bool_)
    for strip in (second, first):
        own = np.flatnonzero(strip.known)
        rgba[:, own], known[own] = strip.rgba[:, own], True
    return RimStrip(rgba, known)
