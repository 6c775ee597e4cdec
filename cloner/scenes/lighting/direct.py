"""Direct light of the sun and the lamps on a panel's fine grid."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array
from cloner.scenes.building.charts import Grid
from cloner.scenes.building.pieces import from_plan
from cloner.scenes.building.plan import Lamp, Sun
from cloner.scenes.building.solids import Panel
from cloner.scenes.lighting.rays import RayQuads, sphere_directions

#: The sun's radius seen from the earth, radians (half of .53 degrees).
SUN_RADIUS: Final = 0.00463
SUN_SAMPLES: Final = 8
LAMP_SAMPLES: Final = 6
#: Side of the blocks of texels that are asked together.
BLOCK: Final = 48


def sun_direction(sun: Sun) -> Array:
    """Return the unit direction towards the sun."""
    turn, rise = np.radians(sun.towards_deg), np.radians(sun.elevation_deg)
    return np.array([np.sin(turn) * np.cos(rise), np.sin(rise), -np.cos(turn) * np.cos(rise)])


def orthogonal_pair(direction: Array) -> Array:
    """Return (2, 3) unit vectors perpendicular to a direction and to each other."""
    first = np.cross(direction, [0.0, 0.0, 1.0] if abs(direction[2]) < 0.9 else [1.0, 0.0, 0.0])
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(direction, first)])


def sun_share(panel: Panel, grid: Grid, stops: RayQuads, sun: Sun) -> Array:
    """Return the (nv, nu) share of the sun's irradiance on a panel: cosine times the visible part of the disc.

    Each texel asks from ``SUN_SAMPLES`` places in it for as many places of the sun, so that borders of light are even.
    """
    direction = sun_direction(sun)
    cosine = float(panel.normal @ direction)
    seen = np.zeros(grid.there.shape)
    if cosine <= 1e-4:
        return seen
    across = orthogonal_pair(direction)
    k = np.arange(SUN_SAMPLES) + 0.5
    disc = SUN_RADIUS * np.sqrt(k / SUN_SAMPLES)[:, None] * np.column_stack([np.cos(2.4 * k), np.sin(2.4 * k)])
    moved = np.column_stack([(k * 0.7549) % 1.0, (k * 0.5698) % 1.0]) - 0.5  # Roberts' R2 sequence
    step = np.array([one[1] - one[0] for one in (grid.u, grid.v)])
    for rows, columns in _blocks(grid.there):
        wanted = grid.there[rows, columns]
        places = grid.places[rows, columns][wanted]
        total = np.zeros(len(places))
        for jitter, off in zip(moved, disc, strict=True):
            place = places + (jitter[0] * step[0]) * panel.along + (jitter[1] * step[1]) * panel.up
            u, v = (place - panel.corner) @ panel.along, (place - panel.corner) @ panel.up
            place = panel.at(np.clip(u, 1e-3, panel.size[0] - 1e-3), np.clip(v, 1e-3, panel.size[1] - 1e-3))
            total += stops.unblocked_along(place, direction + off @ across, across)
        seen[rows, columns][wanted] = total * (cosine / SUN_SAMPLES)
    return seen


def lamp_share(panel: Panel, grid: Grid, stops: RayQuads, lamp: Lamp) -> Array:
    """Return the (nv, nu) share of a lamp's light on a panel; see :func:`lamp_share_at`."""
    share = np.zeros(grid.there.shape)
    middle = from_plan(lamp.at[0], lamp.at[1], lamp.at[2])
    if (middle - panel.corner) @ panel.normal < -lamp.radius:
        return share
    for rows, columns in _blocks(grid.there):
        wanted = grid.there[rows, columns]
        share[rows, columns][wanted] = lamp_share_at(grid.places[rows, columns][wanted], panel.normal, stops, lamp)
    return share


def lamp_share_at(places: Array, normal: Array, stops: RayQuads, lamp: Lamp) -> Array:
    """Return the (N,) share of a lamp's light at nearby (N, 3) points with one normal."""
    middle = from_plan(lamp.at[0], lamp.at[1], lamp.at[2])
    total = np.zeros(len(places))
    for off in sphere_directions(LAMP_SAMPLES):
        lamp_place = middle + lamp.radius * off
        to = lamp_place - places
        far = np.maximum((to**2).sum(axis=1), lamp.radius**2)
        cosine = np.maximum(to @ normal, 0.0) / np.sqrt(far)
        if cosine.max(initial=0.0) > 0.0:
            total += stops.visible_from(lamp_place, places) * cosine / far
    return np.asarray(total / LAMP_SAMPLES)


def _blocks(there: NDArray[np.bool_]) -> list[tuple[slice, slice]]:
    return [
        (slice(y, y + BLOCK), slice(x, x + BLOCK))
        for y in range(0, there.shape[0], BLOCK)
        for x in range(0, there.shape[1], BLOCK)
        if there[y : y + BLOCK, x : x + BLOCK].any()
    ]
