"""Shape of loose clothing: a tube around trunk and legs, the hull of its outlines in rest pose."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter1d

from cloner.frames import ViewId, m_from_mm
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.charts.tubes import convex_hull_radii, directions, ring_angles, tube_points
from cloner.geometry.meshes.triangles import triangle_sides
from cloner.hair.clothing.loose_views import LooseView
from cloner.records.arrays import Array
from cloner.records.clones import Joined

RINGS, COLUMNS = 44, 96  # of the mesh: counts, taste
HULL_RINGS, HULL_COLUMNS, STEPS = 24, 48, 54  # the hull is smooth: found coarsely, then refined
FARTHEST_M = 0.80  # cloth stands off the body's axis by no more than this
#: Exponent of a section between ellipse (2) and box: hips and legs make it a little square. Measured on 21 generated
#: people in skirts and coats (of 30501 to 30640): overlap from 45 degrees .9302 at 2.2, .9320 at 2.5, .9311 at 2.8.
ROUNDNESS = 2.5
HEM_COLUMNS = 32  # the hem is smooth too
HIDDEN = 0.15  # of half the cloth's depth: what lies farther behind its middle than this is hidden by it
CLEARANCE_MM = 6.0  # cloth hangs at least this far outside the legs
TUCK_MM, TUCK_M = 2.0, 0.03  # its upper border lies this deep in the skin and comes out within this height
SMOOTH_COLUMNS, SMOOTH_RINGS = 1.0, 1.0


def body_sections(generic: GenericHuman, joined: Joined, heights_m: Array, angles: Array) -> tuple[Array, Array]:
    """Return centres (K, 2) and hull radii (K, A) of trunk and legs at rest heights, metres."""
    names = ("torso", "pelvis", *(f"{side}_{part}" for side in ("left", "right") for part in ("thigh", "calf", "foot")))
    own = generic.segment(*names)
    triangles = body_triangles()
    triangles = triangles[own[triangles].all(axis=1)]
    edges = triangle_sides(triangles)
    edges = edges[edges[:, 0] < edges[:, 1]]
    ends = joined.vertices_m[edges]
    centres, radii = np.zeros((len(heights_m), 2)), np.zeros((len(heights_m), len(angles)))
    for k, height in enumerate(heights_m):
        above = ends[:, :, 1] > height
        cut = ends[above[:, 0] != above[:, 1]]
        if len(cut) < 3:  # above the head or below the soles
            centres[k], radii[k] = centres[k - 1], radii[k - 1]
            continue
        part = (height - cut[:, 0, 1]) / (cut[:, 1, 1] - cut[:, 0, 1])
        flat = (cut[:, 0] + part[:, None] * (cut[:, 1] - cut[:, 0]))[:, [0, 2]]
        centres[k] = (flat.min(axis=0) + flat.max(axis=0)) / 2.0
        radii[k] = convex_hull_radii(flat, centres[k], angles)
    return centres, radii


def hem_heights(views: list[LooseView], centre_m: Array, half_m: Array) -> Array:
    """Return the rest heights (COLUMNS,) of the hem: each photo tells those of the side that faces it.

    Parameters
    ----------
    centre_m : (3,) on the axis near the hem
    half_m : (2,) half width and half depth there
    """
    angles = ring_angles(HEM_COLUMNS)
    flat = directions(angles) * half_m
    places = centre_m + np.stack([flat[:, 0], np.zeros(HEM_COLUMNS), flat[:, 1]], axis=1)
    observed: list[list[tuple[float, float]]] = [[] for _ in angles]
    for view in views:
        nearer = view.depths(centre_m[None]) - view.depths(places)
        facing = nearer / max(float(np.abs(nearer).max()), 1e-9)
        for column in np.flatnonzero(facing > -HIDDEN):
            row = float(view.region.hem_row(view.across(places[column][None]))[0])
            weight = 1.0 + max(float(facing[column]), 0.0) ** 2  # the hem's outline counts, what faces the photo doubly
            observed[column].append((view.height_of(row, places[column]), weight))
    known = np.array([column for column, rows in enumerate(observed) if rows])
    heights = np.zeros(len(known))
    for k, column in enumerate(known):
        rows_m, weights = np.array(observed[column]).T
        heights[k] = np.average(rows_m, weights=weights)
    whole = np.interp(angles, angles[known], heights, period=2.0 * np.pi)
    smooth = gaussian_filter1d(whole, SMOOTH_COLUMNS, mode="wrap")
    return np.asarray(np.interp(ring_angles(COLUMNS), angles, smooth, period=2.0 * np.pi))


def loose_tube(generic: GenericHuman, joined: Joined, views: list[LooseView]) -> Array:
    """Return the (RINGS, COLUMNS, 3) points of cloth around the legs at rest, metres.

    Parameters
    ----------
    views : list of LooseView
        At least one from the front or from behind.
    """
    hip = np.array([views[0].hanging.middle_m, views[0].hanging.hip_m, 0.0])
    top = float(np.mean([view.height_of(view.region.top_px, hip) for view in views]))
    low = float(np.mean([view.height_of(float(view.region.hem_px.mean()), hip - [0.0, 0.3, 0.0]) for view in views]))
    coarse = np.linspace(top, low, HULL_RINGS)
    centres, body = body_sections(generic, joined, coarse, ring_angles(HULL_COLUMNS))
    hull = hull_sections(views, coarse, centres, body)
    hull = gaussian_filter1d(hull, SMOOTH_COLUMNS, axis=1, mode="wrap")
    half = np.array([hull[-1, HULL_COLUMNS // 2], hull[-1, HULL_COLUMNS // 4]])
    ends = hem_heights(views, np.array([centres[-1, 0], low, centres[-1, 1]]), half)
    levels = top + np.linspace(0.0, 1.0, RINGS)[:, None] * (ends - top)
    middle, body = body_sections(generic, joined, levels.mean(axis=1), ring_angles(COLUMNS))
    # seen from the finer rings' own middles the hull is the same but for millimetres that smoothing takes anyway
    flat = tube_points(centres, np.repeat(coarse[:, None], HULL_COLUMNS, axis=1), hull)[..., [0, 2]]
    rings = np.interp(np.linspace(0.0, 1.0, RINGS), np.linspace(0.0, 1.0, HULL_RINGS), np.arange(HULL_RINGS))
    radii = refined_sections(flat, rings, middle)
    rise = np.clip((top - levels) / TUCK_M, 0.0, 1.0)
    clear = body + m_from_mm(1.0) * (rise * (CLEARANCE_MM + TUCK_MM) - TUCK_MM)
    radii = np.where(rise == 0.0, clear, np.maximum(radii, clear))
    return tube_points(middle, levels, radii)


def refined_sections(flat_m: Array, rings: Array, centres_m: Array) -> Array:
    """Return radii (K, COLUMNS) around new centres of a coarse tube's sections.

    Parameters
    ----------
    flat_m : (R, C, 2) x, z of the coarse tube
    rings : (K,) coarse ring, fractional, of every fine one
    centres_m : (K, 2) x, z
    """
    angles = ring_angles(COLUMNS)
    found = np.zeros((len(rings), COLUMNS))
    for k, ring in enumerate(rings):
        low = min(int(ring), len(flat_m) - 2)
        section = flat_m[low] + (ring - low) * (flat_m[low + 1] - flat_m[low]) - centres_m[k]
        turn, reach = np.arctan2(section[:, 0], section[:, 1]), np.linalg.norm(section, axis=1)
        order = np.argsort(turn)
        found[k] = np.interp(angles, turn[order], reach[order], period=2.0 * np.pi)
    return np.asarray(gaussian_filter1d(found, SMOOTH_RINGS, axis=0, mode="nearest"))


def hull_sections(views: list[LooseView], heights_m: Array, centres_m: Array, body_m: Array) -> Array:
    """Return radii (K, HULL_COLUMNS) of the cloth's sections: rounded between the edges of the photos.

    Front and back photos bound the width, the side photo the depth; without
    one, cloth stands off before and behind the body as it does at the sides.
    """
    reach = np.linspace(0.0, FARTHEST_M, STEPS)
    direction = directions(ring_angles(HULL_COLUMNS))
    flat = centres_m[:, None, None, :] + reach[:, None] * direction[None, :, None, :]
    high = np.broadcast_to(heights_m[:, None, None], flat.shape[:3])
    points = np.stack([flat[..., 0], high, flat[..., 1]], axis=-1).reshape(-1, 3)
    wide = [np.abs(v.across(points)) ** ROUNDNESS for v in views if v.posed.view is not ViewId.BODY_SIDE]
    deep = [np.abs(v.across(points)) ** ROUNDNESS for v in views if v.posed.view is ViewId.BODY_SIDE]
    total = np.mean(wide, axis=0).reshape(flat.shape[:3])
    if deep:
        total = total + deep[0].reshape(total.shape)
    else:
        total = total + _depth_guesses(total, reach, direction, body_m) ** ROUNDNESS
    outside = total > 1.0
    outside[..., -1] = True
    first = np.maximum(np.argmax(outside, axis=-1), 1)[..., None]
    before, after = (np.take_along_axis(total, first - step, axis=-1)[..., 0] for step in (1, 0))
    part = np.clip((1.0 - before) / np.maximum(after - before, 1e-9), 0.0, 1.0)
    return np.asarray(reach[first[..., 0] - 1] + part * (reach[1] - reach[0]))


def _depth_guesses(wide: Array, reach: Array, direction: Array, body_m: Array) -> Array:
    """Return the guessed depths (K, HULL_COLUMNS, STEPS) between the front (1) and the back of cloth."""
    sides = [int(np.argmax(direction[:, 0])), int(np.argmin(direction[:, 0]))]
    out = [reach[np.argmax(wide[:, side] > 1.0, axis=-1)] - body_m[:, side] for side in sides]
    off = np.maximum(np.mean(out, axis=0), 0.0)
    deep = 0.5 * (body_m[:, int(np.argmax(direction[:, 1]))] + body_m[:, int(np.argmin(direction[:, 1]))]) + off
    return np.asarray(np.abs(direction[None, :, None, 1] * reach) / np.maximum(deep, 0.02)[:, None, None])
