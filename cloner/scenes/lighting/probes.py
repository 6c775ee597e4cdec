"""Light probes for people: incoming light in two bands of spherical harmonics.

A probe's row is four numbers a colour, so that a surface of unit normal n gets E(n) = c0 + c . n (what is below nothing
is nothing): cosines keep these bands of the light around best (Ramamoorthi and Hanrahan 2001). The sun would be smeared
by them, so each probe tells instead how much of the sun is seen from it.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.crowd.staged.rooms import Probes
from cloner.pipeline import Progress, no_progress
from cloner.records.arrays import Array
from cloner.scenes.building.charts import fill_missing
from cloner.scenes.building.pieces import from_plan
from cloner.scenes.building.solids import Room, inside_solids
from cloner.scenes.lighting.direct import lamp_share_at, orthogonal_pair, sun_direction
from cloner.scenes.lighting.light import Lit, cells_at
from cloner.scenes.lighting.rays import sphere_directions

#: Step of the grid on the plan and heights of the probes, metres: knees, chest, a little above a head.
STEP_M: Final = 1.0
HEIGHTS_M: Final = (0.45, 1.1, 1.75)
RAYS: Final = 512
#: The sun is looked for from so far around a probe, metres: a body's half width.
AROUND_M: Final = 0.2


def make_probes(room: Room, lit: Lit, progress: Progress = no_progress) -> Probes:
    """Return the probes over all floors of a lit room."""
    low = np.min([one.low for one in room.plan.floors], axis=0)
    high = np.max([one.high for one in room.plan.floors], axis=0)
    nx, nz = (int(np.ceil((b - a) / STEP_M)) + 1 for a, b in zip(low, high, strict=True))
    corner = np.array([low[0], HEIGHTS_M[0], -low[1] - (nz - 1) * STEP_M])
    light = np.zeros((len(HEIGHTS_M), nz, nx, 3, 4), np.float32)
    sun = np.zeros(light.shape[:3], np.float32)
    there = np.zeros(light.shape[:3], bool)
    directions = sphere_directions(RAYS)
    for h, height in enumerate(HEIGHTS_M):
        for z in range(nz):
            for x in range(nx):
                place = np.array([corner[0] + x * STEP_M, height, corner[2] + z * STEP_M])
                if not _is_free(room, place):
                    continue
                there[h, z, x] = True
                light[h, z, x], sun[h, z, x] = make_probe(room, lit, place, directions)
            progress("probes", (h * nz + z + 1) / (len(HEIGHTS_M) * nz))
        light[h], sun[h] = fill_missing(light[h], there[h]), fill_missing(sun[h], there[h])
    return Probes(corner, np.array(HEIGHTS_M), STEP_M, light, sun)


def make_probe(room: Room, lit: Lit, place: Array, directions: Array) -> tuple[Array, float]:
    """Return the (3, 4) incoming light at a point, and the visible share of the sun."""
    quad, _, where = lit.stops.first_hits(place, directions)
    given = lit.patches.given[cells_at(lit.patches, quad, where)]
    given[(quad < 0) & (directions[:, 1] > 0.0)] = room.plan.sky.light
    found = np.concatenate([given.mean(axis=0)[:, None], 2.0 * (given.T @ directions) / len(directions)], axis=1)
    for lamp in room.plan.lamps:
        direction = from_plan(*lamp.at) - place
        direction /= np.linalg.norm(direction)
        share = float(lamp_share_at(place[None], direction, lit.stops, lamp)[0])
        found += np.outer(lamp.light, share * np.concatenate([[0.25], 0.5 * direction]))
    seen = 0.0
    if room.plan.sun:
        direction = sun_direction(room.plan.sun)
        around = place + AROUND_M * np.concatenate(
            [np.zeros((1, 3)), orthogonal_pair(direction), -orthogonal_pair(direction)]
        )
        seen = float(lit.stops.unblocked_along(around, direction, orthogonal_pair(direction)).mean())
    return found, seen


def _is_free(room: Room, place: Array) -> bool:
    """Return whether a person can stand there: over a floor and in no solid."""
    over = any(one.low[0] - STEP_M <= place[0] <= one.high[0] + STEP_M
               and one.low[1] - STEP_M <= -place[2] <= one.high[1] + STEP_M for one in room.plan.floors)  # fmt: skip
    return over and not inside_solids(place[None], room.boxes, -0.02)[0]
