"""Light maps: direct light by ray tracing, and indirect light by radiosity.

Sun and lamps are worked out for every texel; the sky and light that comes over other surfaces changes slowly and is
gathered on a coarser lattice, by rays of equal weight for cosines. What the rays meet is kept, so that every further
bounce is a lookup: E = sky + mean over rays of B, B = albedo x E, until nothing changes.

Units: irradiance, of which 1 shows a white surface white. References: Goral, Torrance, Greenberg, Battaile 1984
(radiosity); Veach 1997, chapter 8 (light from areas); Ward, Rubinstein, Clear 1988 (indirect light on few places).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter
from scipy.sparse import csr_matrix

from cloner.pipeline import Progress, no_progress
from cloner.records.arrays import Array
from cloner.scenes.building.charts import (
    Chart,
    Grid,
    assemble_map,
    fill_missing,
    interpolation_weights,
    make_charts,
    make_grid,
    upsample,
)
from cloner.scenes.building.looks import Look
from cloner.scenes.building.pieces import Quad
from cloner.scenes.building.solids import Panel, Room
from cloner.scenes.lighting.direct import lamp_share, sun_share
from cloner.scenes.lighting.rays import RayQuads, hemisphere_directions

#: Steps of the lattice and of the patches that give light back, metres.
LATTICE_M, PATCH_M = 0.25, 0.5
RAYS: Final = 400
#: Openings are asked at places so far apart, metres; who is nearer than this to one counts rays that leave by it.
PORTAL_STEP_M, NEAR_PORTAL_M = 0.4, 1.2
#: Bounces end when no patch changes by more than this share of the brightest, or after so many.
SETTLED, MOST_BOUNCES = 1e-4, 200
SMOOTH_NODES, ONE_NODE = 0.7, 1.5  # gaussians end at the second: over a wall there are two nodes
#: Places at which a cell's mean is taken, along each side.
IN_CELL: Final = 12


@dataclass(frozen=True, slots=True, eq=False)
class Patches:
    """Outgoing light of surfaces, cell by cell.

    Attributes
    ----------
    first : (P + 1,) first cell of each panel
    cells : (P, 2) cells along and up
    panel_of : (Q,) panel of each quad that stops rays, -1 where none is drawn
    start, span : (Q, 2) where the quad lies in its panel, and its size, as shares of the panel's
    given : (cells, 3) radiosity B, the last cell is darkness
    """

    first: NDArray[np.int64]
    cells: NDArray[np.int64]
    panel_of: NDArray[np.int64]
    start: Array
    span: Array
    given: Array


@dataclass(frozen=True, slots=True, eq=False)
class Lit:
    """A room with its light.

    Attributes
    ----------
    charts, size : where the panels lie in the map, its (width, height)
    map : (H, W, 3) irradiance
    sun : (H, W, 1) share of the sun's own light that falls there straight, 0..1, part of the map
    patches : what surfaces give back, for probes
    stops : the room's
    """

    charts: tuple[Chart, ...]
    size: tuple[int, int]
    map: NDArray[np.float32]
    sun: NDArray[np.float32]
    patches: Patches
    stops: RayQuads


def light_room(room: Room, *, texel_m: float | None = None, rays: int = RAYS, progress: Progress = no_progress) -> Lit:
    """Return a room's light maps; ``texel_m`` overrides the panels' own texel sizes."""
    stops, portals = RayQuads(room.stops), RayQuads(room.portals)
    charts, size = make_charts(room, texel_m)
    direct, sunny, fine = _direct_light(room, charts, stops, progress)
    lattice = [make_grid(room, one, _counts(one.size, LATTICE_M, 2)) for one in room.panels]
    cells = np.array([_counts(one.size, PATCH_M, 1) for one in room.panels])
    first = np.concatenate([[0], np.cumsum(cells.prod(axis=1))])
    patches = Patches(first, cells, *_panels_of(room), np.zeros((int(first[-1]) + 1, 3)))
    met, sky = _gather_weights(room, lattice, stops, portals, patches, rays, progress)
    albedo = np.concatenate(
        [np.tile(_albedo(one, room.looks), (count, 1)) for one, count in zip(room.panels, np.diff(first), strict=True)]
    )
    steady = [_cell_means(own, grid.there, _averaging_matrices(grid, count))
              for own, grid, count in zip(direct, fine, cells, strict=True)]  # fmt: skip
    means = [_averaging_matrices(grid, count) for grid, count in zip(lattice, cells, strict=True)]
    given = patches.given
    for _ in range(MOST_BOUNCES):
        back = [_indirect_light(own, more, grid, given) for own, more, grid in zip(met, sky, lattice, strict=True)]
        soft = [_cell_means(own, None, mean) for own, mean in zip(back, means, strict=True)]
        now = albedo * (np.concatenate(steady) + np.concatenate(soft))
        change = np.abs(now - given[:-1]).max()
        given[:-1] = now
        if change <= SETTLED * max(float(now.max()), 1e-9):
            break
    values = []
    for own, grid, coarse, more in zip(direct, fine, lattice, back, strict=True):
        whole = fill_missing(own, grid.there) + upsample(more, coarse, grid)
        values.append(np.maximum(whole, 0.0))
    progress("light", 1.0)
    sun = [fill_missing(own[..., None], grid.there) for own, grid in zip(sunny, fine, strict=True)]
    return Lit(charts, size, assemble_map(charts, values, size), assemble_map(charts, sun, size), patches, stops)


def cells_at(patches: Patches, quad: NDArray[np.int64], where: Array) -> NDArray[np.int64]:
    """Return the cells at (N, 2) positions, 0..1, on quads; the dark cell where nothing is hit or drawn."""
    held = patches.panel_of[quad]
    share = patches.start[quad] + np.clip(where, 0.0, 1.0) * patches.span[quad]
    cells = patches.cells[held]
    column, row = np.clip((share * cells).astype(np.int64), 0, cells - 1).T
    dark = (quad < 0) | (held < 0)
    return np.where(dark, len(patches.given) - 1, patches.first[held] + row * cells[:, 0] + column)


def _counts(size: tuple[float, float], step: float, more: int) -> tuple[int, int]:
    if more == 1:
        return max(round(size[0] / step), 1), max(round(size[1] / step), 1)
    return max(int(np.ceil(size[0] / step)) + 1, 2), max(int(np.ceil(size[1] / step)) + 1, 2)


def _albedo(panel: Panel, looks: Mapping[str, Look]) -> Array:
    """Return a panel's albedo, averaged over its parts by area."""
    areas = np.array([(u1 - u0) * (v1 - v0) for (u0, v0, u1, v1), _ in panel.parts])
    own = np.array([looks[look].albedo for _, look in panel.parts])
    return np.asarray((areas[:, None] * own).sum(axis=0) / areas.sum())


def _direct_light(
    room: Room, charts: tuple[Chart, ...], stops: RayQuads, progress: Progress
) -> tuple[list[Array], list[Array], list[Grid]]:
    """Return each panel's light from sun and lamps, (nv, nu, 3), the sun's share in it, (nv, nu), and its fine grid."""
    found, sunny, grids = [], [], []
    for k, chart in enumerate(charts):
        grid = make_grid(room, chart.panel, chart.size)
        light, share = np.zeros((*grid.there.shape, 3)), np.zeros(grid.there.shape)
        if room.plan.sun:
            share = sun_share(chart.panel, grid, stops, room.plan.sun)
            light += share[..., None] * room.plan.sun.light
        for lamp in room.plan.lamps:
            light += lamp_share(chart.panel, grid, stops, lamp)[..., None] * lamp.light
        found.append(light)
        sunny.append(share)
        grids.append(grid)
        progress("sun and lamps", (k + 1) / len(charts))
    return found, sunny, grids


def _panels_of(room: Room) -> tuple[NDArray[np.int64], Array, Array]:
    """Return each quad's panel, -1 for those that are not drawn, its position on it and its size."""
    found = np.full(len(room.stops), -1)
    start, span = np.zeros((len(room.stops), 2)), np.ones((len(room.stops), 2))
    corner, along, up, normal = (
        np.array([getattr(one, name) for one in room.panels]) for name in ("corner", "along", "up", "normal")
    )
    size = np.array([one.size for one in room.panels])
    for k, quad in enumerate(room.stops):
        own = quad.middle() - corner
        u, v = (own * along).sum(axis=1), (own * up).sum(axis=1)
        near = (normal @ quad.normal > 1.0 - 1e-6) & (np.abs((own * normal).sum(axis=1)) < 1e-5)
        near &= (u >= 0.0) & (v >= 0.0) & (u <= size[:, 0]) & (v <= size[:, 1])
        for number in np.flatnonzero(near).tolist():
            if any(
                u0 <= u[number] <= u1 and v0 <= v[number] <= v1 for (u0, v0, u1, v1), _ in room.panels[number].parts
            ):
                found[k] = number
                low = quad.corner - corner[number]
                start[k] = np.array([low @ along[number], low @ up[number]]) / size[number]
                span[k] = np.array([np.linalg.norm(quad.along), np.linalg.norm(quad.up)]) / size[number]
    return found, start, span


def _gather_weights(
    room: Room, lattice: list[Grid], stops: RayQuads, portals: RayQuads, patches: Patches, rays: int, progress: Progress
) -> tuple[list[csr_matrix], list[Array]]:
    """Return for each panel its nodes' shares of all cells, (nodes there, cells), and the sky's light on them."""
    directions, sky = hemisphere_directions(rays), np.array(room.plan.sky.light)
    met, light = [], []
    done, whole = 0, sum(int(one.there.sum()) for one in lattice)
    for panel, grid in zip(room.panels, lattice, strict=True):
        turned = directions @ np.array([panel.along, panel.up, panel.normal])
        places = grid.places[grid.there] + panel.normal * 1e-3
        cells = np.zeros((len(places), rays), np.int32)
        own = np.zeros((len(places), 3))
        for k, place in enumerate(places):
            quad, _, where = stops.first_hits(place, turned, panel.normal)
            cells[k] = cells_at(patches, quad, where)
            free = (quad < 0) & (turned[:, 1] > 0.0)
            if len(portals.corner) and sky.any():
                door, _, _ = portals.first_hits(place, turned, panel.normal)
                near = _near_portals(portals, place)
                free &= (door < 0) | near[door]
            own[k] = sky * (free.sum() / rays)
        for number, quad_ in enumerate(room.portals):
            if sky.any() and len(places):
                own += sky * _sky_through(places, panel.normal, stops, portals, number, quad_)[:, None]
        done += len(places)
        progress("light from surfaces", done / max(whole, 1))
        met.append(_lookup(cells, len(patches.given)))
        light.append(own)
    return met, light


def _lookup(cells: NDArray[np.int32], count: int) -> csr_matrix:
    """Return the (N, count) shares of each cell in the mean over (N, R) rays."""
    starts = np.arange(0, cells.size + 1, cells.shape[1])
    made = csr_matrix(
        (np.full(cells.size, 1.0 / cells.shape[1], np.float32), cells.ravel(), starts), (len(cells), count)
    )
    made.sum_duplicates()
    return made


def _near_portals(portals: RayQuads, place: Array) -> NDArray[np.bool_]:
    """Return which openings are so near to a point that their sky is sampled by rays."""
    away = place - np.clip(place, portals.low, portals.high)
    return np.asarray((away**2).sum(axis=1) < NEAR_PORTAL_M**2)


def _sky_through(places: Array, normal: Array, stops: RayQuads, portals: RayQuads, number: int, portal: Quad) -> Array:
    """Return the (N,) share of the sky's light that reaches (N, 3) points through an opening, zero where it is near."""
    out = np.zeros(len(places))
    reach = (portals.corners[number] - places[:, None]) @ normal
    facing = (places - portal.corner) @ portal.normal > 1e-4
    away = places - np.clip(places, portals.low[number], portals.high[number])
    asked = np.flatnonzero(facing & (reach.max(axis=1) > 0.0) & ((away**2).sum(axis=1) >= NEAR_PORTAL_M**2))
    if not len(asked):
        return out
    sides = [float(np.linalg.norm(one)) for one in (portal.along, portal.up)]
    counts = [max(int(np.ceil(one / PORTAL_STEP_M)), 2) for one in sides]
    area = sides[0] * sides[1] / (counts[0] * counts[1])
    own = places[asked]
    total = np.zeros(len(asked))
    for u in (np.arange(counts[0]) + 0.5) / counts[0]:
        for v in (np.arange(counts[1]) + 0.5) / counts[1]:
            point = portal.corner + u * portal.along + v * portal.up
            to = point - own
            far = (to**2).sum(axis=1)
            cosine = np.maximum(to @ normal, 0.0) * np.maximum(-to @ portal.normal, 0.0) / far
            cosine[to[:, 1] <= 0.0] = 0.0
            total += stops.visible_from(point + portal.normal * 1e-3, own) * cosine * area / (np.pi * far)
    out[asked] = total
    return out


def _indirect_light(met: csr_matrix, sky: Array, grid: Grid, given: Array) -> Array:
    """Return a grid's (nv, nu, 3) light from sky and surfaces, smoothed a little if it is large enough."""
    own = np.zeros((*grid.there.shape, 3))
    if met.shape[0]:
        own[grid.there] = sky + met @ given
    if min(own.shape[:2]) >= 4:
        there = grid.there[..., None].astype(float)
        own = gaussian_filter(own * there, (SMOOTH_NODES, SMOOTH_NODES, 0.0), mode="nearest", truncate=ONE_NODE)
        own /= np.maximum(
            gaussian_filter(there, (SMOOTH_NODES, SMOOTH_NODES, 0.0), mode="nearest", truncate=ONE_NODE), 1e-9
        )
    return fill_missing(own, grid.there)


def _averaging_matrices(grid: Grid, cells: NDArray[np.int64]) -> tuple[Array, Array]:
    """Return (cells up, nv) and (cells along, nu) matrices that average a grid over cells."""
    found = []
    for nodes, count in ((grid.v, cells[1]), (grid.u, cells[0])):
        samples = (np.arange(count * IN_CELL) + 0.5) / (count * IN_CELL) * nodes[-1]
        found.append(interpolation_weights(nodes, samples).reshape(count, IN_CELL, -1).mean(axis=1))
    return found[0], found[1]


def _cell_means(values: Array, there: NDArray[np.bool_] | None, means: tuple[Array, Array]) -> Array:
    """Return the (cells, 3) means of a grid's (nv, nu, 3) values over the present part of each cell."""
    up, along = means
    if there is None:
        return np.asarray((up @ values.transpose(2, 0, 1) @ along.T).reshape(3, -1).T)
    own = up @ (values * there[..., None]).transpose(2, 0, 1) @ along.T
    return np.asarray((own / np.maximum(up @ there @ along.T, 1e-9)).reshape(3, -1).T)
