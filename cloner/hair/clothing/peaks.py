"""The peak of a cap: too thin for a visual hull, but measurable in each outline.

From aside a peak is a thin run of headwear before all of the head: its length, slope, curve and thickness. From the
front its lower edge tells how wide it is and how far it is arched. From above no photo shows it: it ends in an ellipse
around the head's middle through what both measured. A cap worn backwards has its peak behind.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d, label

from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array
from cloner.records.labels import Label, labels_at
from cloner.records.proposals import Proposals
from cloner.vision.retouching.aligning import sample

STEP_M: Final = 0.0015  # of profiles: a pixel of a face photo
REACH_M: Final = 0.15  # peaks are some 70 mm long, this is how far beyond the cap they are looked for
THICK_MM: Final = 25.0  # a round cap seen from aside is thinner than this over its last 2 mm only
SHORTEST_MM: Final = 20.0  # taste: what stands out less is a fold, and the hull shows it
WORN_SHARE: Final = 0.5  # of a peak is labelled as worn: fringes and tails can lie as thin
THINNEST_MM, THICKEST_MM = 2.5, 10.0  # of cardboard in cloth; labels are a pixel unsure on either side
TIP_SHARE: Final = 0.4  # of the run, from the tip: there the drooping sides do not hide the thickness
SLIM: Final = 0.1  # quantile of the thickness seen there: sides that droop hide how thin it is
SMOOTH_MM: Final = 4.0  # of the profile, against the steps of labels
WIDEST: Final = 1.1  # against the cap's own width: hair beside the face is no peak
ROOT_M: Final = 0.02  # so far the slab goes on inside the cap
SQUARE_RAD: Final = 0.9  # the arch is read this far to either side, where the front photo sees the edge before skin
WIDE_RAD: Final = 1.35  # beyond this the edge lies in the cap
MOST_ARCH_MM: Final = 25.0  # taste: no peak is bent more
NODS_MM: Final = 40.0  # a nod of 15 degrees between photos moves a peak so far
EDGE_MM: Final = 4.0  # the width is read this far above the lower edge
SPOKES, RINGS = 33, 9  # 6 mm between vertices
AROUND_M: Final = 0.02  # the cap's width and depth are told from what lies this near to the peak's height

SIDES: Final = (ViewId.FACE_SIDE, ViewId.BODY_SIDE)
FACING: Final = {1.0: (ViewId.FACE_FRONT, ViewId.BODY_FRONT), -1.0: (ViewId.BODY_BACK,)}


@dataclass(frozen=True, slots=True, eq=False)
class PeakProfile:
    """A peak seen from the side.

    Attributes
    ----------
    way : float
        1 before the face, -1 behind the head.
    out_m : (N,) float64
        Distance from the head's middle, ascending; the last is the tip's.
    top_m : (N,) float64
        Heights of the upper side, rest frame.
    thickness_m : float
    arch_m : float
        How far its sides hang below its middle at most: else they would be seen below it.
    """

    way: float
    out_m: Array
    top_m: Array
    thickness_m: float
    arch_m: float


@dataclass(frozen=True, slots=True, eq=False)
class Peak:
    """A measured peak; arch is how far its sides hang below its middle, metres."""

    profile: PeakProfile
    middle_m: tuple[float, float]
    half_width_m: float
    arch_m: float


def find_peak(views: list[HairView], proposals: Proposals, cap_m: Array, least_m: float) -> Peak | None:
    """Return the peak of the cap in the photos, None where they show none.

    Parameters
    ----------
    views : list of HairView
    proposals : Proposals
    cap_m : (N, 3)
        Vertices of the cap's surface, or the hair's, rest frame, metres.
    least_m : float
        Height below which no peak is.
    """
    above = cap_m[cap_m[:, 1] > least_m]
    if not len(above):
        return None
    middle = tuple(0.5 * (above[:, axis].min() + above[:, axis].max()) for axis in (0, 2))
    for name in SIDES:
        for view in (view for view in views if view.posed.view is name and view.flip_m is None):
            for direction in FACING:
                profile = peak_profile(view, proposals, above, middle, direction)
                peak = profile and _with_front_measures(headwear_views(views, proposals), profile, above, middle)
                if peak:
                    return peak
    return None


def peak_profile(
    view: HairView, proposals: Proposals, cap_m: Array, middle_m: tuple[float, float], direction: float
) -> PeakProfile | None:
    """Return the thin run of headwear beyond the cap in a side photo, None where there is none."""
    out = np.arange(0.0, float(np.abs(cap_m[:, 2] - middle_m[1]).max()) + REACH_M, STEP_M)
    heights = np.arange(cap_m[:, 1].min(), cap_m[:, 1].max(), STEP_M)
    x, y, z = np.broadcast_arrays(middle_m[0], heights[:, None], middle_m[1] + direction * out[None, :])
    points = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    pixel = view.posed.camera.project(view.to_view(points))
    shown = (sample(np.maximum(view.outline_px, view.hair_px), pixel)[:, 0] > 0.0).reshape(len(heights), len(out))
    pieces, count = label(shown)
    if not count:
        return None
    shown = pieces == 1 + int(np.bincount(pieces[shown])[1:].argmax())
    last = int(np.flatnonzero(shown.any(axis=0))[-1])
    first, run = last, _run_around(shown[:, last], int(np.flatnonzero(shown[:, last])[-1]))
    low, high = [], []
    while run is not None and (run[1] - run[0]) * STEP_M < m_from_mm(THICK_MM) and first > 0:
        low.append(run[0])
        high.append(run[1])
        first -= 1
        run = _run_around(shown[:, first], (run[0] + run[1] - 1) // 2)
    if run is None or len(low) * STEP_M < m_from_mm(SHORTEST_MM) or last == len(out) - 1:
        return None
    rows = np.concatenate(
        [np.arange(a, b) * len(out) + last - k for k, (a, b) in enumerate(zip(low, high, strict=True))]
    )
    worn = labels_at(proposals.views[view.posed.view].labels, pixel[rows]) == Label.ACCESSORY
    if worn.mean() < WORN_SHARE:
        return None
    bottom, top = (heights[0] + (np.array(ends[::-1]) - 0.5) * STEP_M for ends in (low, high))
    outer = (top - bottom)[int((1.0 - TIP_SHARE) * len(top)) :]
    thickness = float(np.clip(np.quantile(outer, SLIM), m_from_mm(THINNEST_MM), m_from_mm(THICKEST_MM)))
    top = gaussian_filter1d(top, m_from_mm(SMOOTH_MM) / STEP_M, mode="nearest")
    out = out[last - len(top) + 1 : last + 1]
    # The edge, an ellipse seen from its side, hangs by the arch times this share.
    hanging = (1.0 - (out / out[-1]) ** 2)[: len(out) // 2]
    arch = float(np.median((top[-1] - thickness - bottom[: len(out) // 2]) / hanging))
    return PeakProfile(direction, out, top, thickness, float(np.clip(arch, 0.0, m_from_mm(MOST_ARCH_MM))))


def _run_around(column: NDArray[np.bool_], row: int) -> tuple[int, int] | None:
    """Return first and last plus one of the True values around a row, None where it is False."""
    if not column[row]:
        return None
    below, above = np.flatnonzero(~column[:row]), np.flatnonzero(~column[row:])
    return int(below[-1]) + 1 if below.size else 0, row + int(above[0]) if above.size else len(column)


def _with_front_measures(
    views: list[HairView], profile: PeakProfile, cap_m: Array, middle_m: tuple[float, float]
) -> Peak | None:
    """Return the peak with width and arch, None where the front photo contradicts it."""
    near = np.abs(cap_m[:, 1] - profile.top_m[0]) < AROUND_M
    if not near.any():
        return None
    widest = WIDEST * float(np.abs(cap_m[near, 0] - middle_m[0]).max())
    whole = Peak(profile, middle_m, widest, 0.0)
    for name in FACING[profile.way]:
        for view in (view for view in views if view.posed.view is name):
            return _measured_from_front(view, whole)
    return whole


def _measured_from_front(view: HairView, peak: Peak) -> Peak | None:
    """Return a peak with the width and arch of a front photo, None where it shows no headwear.

    Heads nod between photos: only how the edge runs is read, not how high it lies; the side photo tells that better.
    """
    angles = np.linspace(-SQUARE_RAD, SQUARE_RAD, SPOKES)
    drop = m_from_mm(1.0) * np.arange(-NODS_MM, NODS_MM, mm_from_m(STEP_M))
    edge = peak_surface(peak, angles, np.ones(1))[:, 0] - (0.0, peak.profile.thickness_m, 0.0)
    below = np.repeat(edge[:, None], len(drop), axis=1)
    below[..., 1] -= drop
    shown = view.evidence(below.reshape(-1, 3))[0].reshape(below.shape[:2]) > 0.0
    ends = np.array([_lower_end(one) for one in shown]) * STEP_M + drop[0]
    level = ends[len(ends) // 2]
    if not np.isfinite(level):
        return None if not shown[len(ends) // 2].any() else peak
    good = np.isfinite(ends)
    half_width = _half_width(view, peak, edge[len(edge) // 2] - (0.0, level, 0.0))
    slope = np.median((ends[good] - level) / np.maximum(np.sin(angles[good]) ** 2, 0.1))
    return Peak(peak.profile, peak.middle_m, half_width, float(np.clip(slope, 0.0, peak.profile.arch_m)))


def _half_width(view: HairView, peak: Peak, end_m: Array) -> float:
    """Return half the widest run of headwear around the peak's middle, from its lower edge to its root, metres."""
    height = max(float(np.ptp(peak.profile.top_m)), m_from_mm(EDGE_MM)) + m_from_mm(EDGE_MM)
    up, wide = np.arange(m_from_mm(EDGE_MM), height, STEP_M), np.arange(0.0, peak.half_width_m, STEP_M)
    lines = np.tile(end_m, (2, len(up), len(wide), 1))
    lines[..., 0] += np.stack([-wide, wide])[:, None]
    lines[..., 1] += up[:, None]
    inside = view.evidence(lines.reshape(-1, 3))[0].reshape(lines.shape[:3]) > 0.0
    runs = np.where(inside.all(axis=2), wide[-1], wide[inside.argmin(axis=2)])
    # The tip is nearer to the camera than where the peak is widest: the same pixels are more there.
    there, here = (view.to_view(p[None])[0] for p in (end_m * (1.0, 1.0, 0.0) + (0.0, 0.0, peak.middle_m[1]), end_m))
    camera = view.posed.camera
    nearness = camera.metres_per_pixel(there) / camera.metres_per_pixel(here)
    return min(float(runs.mean(axis=0).max()) * nearness, peak.half_width_m)


def _lower_end(column: NDArray[np.bool_]) -> float:
    """Return the position, nearest to the middle, where True values end, from the top; NaN where they do not."""
    ends = np.flatnonzero(column[:-1] & ~column[1:])
    return float(ends[np.abs(ends - len(column) // 2).argmin()]) if ends.size else np.nan


def peak_surface(peak: Peak, angles: Array, shares: Array) -> Array:
    """Return points (A, R, 3) of the upper side, rest frame, at angles from the middle and shares of the reach."""
    profile = peak.profile
    tip = profile.out_m[-1]
    angle, share = np.meshgrid(angles, shares, indexing="ij")
    x = peak.middle_m[0] + peak.half_width_m * np.sin(angle) * share
    z = peak.middle_m[1] + profile.way * tip * np.cos(angle) * share
    y = np.interp(share * tip, profile.out_m, profile.top_m) - peak.arch_m * np.sin(angle) ** 2
    return np.stack([x, y, z], axis=-1)


def peak_mesh(peak: Peak) -> tuple[Array, NDArray[np.int32]]:
    """Return vertices (N, 3) and triangles (T, 3) of a peak, a closed slab whose root lies in the cap."""
    profile = peak.profile
    root = max((profile.out_m[0] - ROOT_M) / profile.out_m[-1], 0.1)
    upper = peak_surface(peak, np.linspace(-WIDE_RAD, WIDE_RAD, SPOKES), np.linspace(root, 1.0, RINGS))
    lower = upper - (0.0, profile.thickness_m, 0.0)
    points = np.concatenate([upper.reshape(-1, 3), lower.reshape(-1, 3)])
    count = SPOKES * RINGS
    first = np.arange(count).reshape(SPOKES, RINGS)
    a, b, c, d = first[:-1, :-1], first[1:, :-1], first[1:, 1:], first[:-1, 1:]
    sheet = np.concatenate([np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, d, c), (a, c, b))])
    around = np.concatenate([first[:, 0], first[-1, 1:], first[-2::-1, -1], first[0, -2:0:-1]])
    following = np.roll(around, -1)
    rim = np.concatenate(
        [
            np.stack([around, following, following + count], axis=-1),
            np.stack([around, following + count, around + count], axis=-1),
        ]
    )
    faces = np.concatenate([sheet, sheet[:, ::-1] + count, rim]).astype(np.int32)
    return points, np.ascontiguousarray(faces if faces_outward(points, faces) else faces[:, ::-1])


def headwear_views(views: list[HairView], proposals: Proposals) -> list[HairView]:
    """Return the views with headwear alone, without the hair around it."""
    found = []
    for view in views:
        own = view.hair & (proposals.views[view.posed.view].labels == Label.ACCESSORY)
        hair, to_hair, to_line, _ = distances_px(own, view.outline_px > 0.0)
        found.append(replace(view, hair=hair, hair_px=to_hair, line_px=to_line))
    return found


def under_headwear(worn: list[HairView], points_m: Array) -> NDArray[np.bool_]:
    """Return which rest points (N, 3) some photo shows as headwear; `worn` from :func:`headwear_views`."""
    found = np.zeros(len(points_m), np.bool_)
    for view in worn:
        if view.hair.any():
            inside_mm, judged = view.evidence(points_m)
            found |= judged & (inside_mm > 0.0)
    return found


def faces_outward(points_m: Array, triangles: NDArray[np.int32]) -> bool:
    """Return whether a closed surface's triangles face outwards (positive volume)."""
    a, b, c = (points_m[triangles[:, k]] - points_m.mean(axis=0) for k in range(3))
    return bool(np.einsum("nk,nk->", a, np.cross(b, c)) > 0.0)
