"""The layout of panels in the light map, and the grids on which light is computed.

A chart's outer texels have their middles on the panel's borders, so neighbours that meet there are asked for light at
the same places, and a linear lookup never reaches beyond; two more texels repeat them, for what is drawn from afar.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from cloner.records.arrays import Array
from cloner.scenes.building.solids import Panel, Room, inside_solids

#: Sides of texels, metres: floors as the issue wants them, small things as floors, walls and ceilings coarser.
FLOOR_M, SMALL_M, WALL_M = 0.04, 0.05, 0.08
#: A panel with no side longer than this is small, metres.
SMALL_PANEL_M: Final = 1.2
PAD: Final = 2
#: Light is not asked for nearer to a border than this, metres: in the very corner a ray starts inside two walls.
INSET_M: Final = 0.004
#: Nearer to a solid a place is in it: exactly on a wall's face it would see through.
TOUCHING_M: Final = 0.003


@dataclass(frozen=True, slots=True, eq=False)
class Chart:
    """A panel's place in the light map: texels from (x, y), top row v = 0."""

    panel: Panel
    size: tuple[int, int]
    x: int
    y: int

    def uv(self, u: Array, v: Array, map_size: tuple[int, int]) -> Array:
        """Return (..., 2) texture coordinates, origin at the top, of places in metres on the panel."""
        wide, tall = self.panel.size
        px = np.stack([self.x + 0.5 + u / wide * (self.size[0] - 1), self.y + 0.5 + v / tall * (self.size[1] - 1)], -1)
        return np.asarray(px / map_size)


def make_charts(room: Room, texel_m: float | None = None) -> tuple[tuple[Chart, ...], tuple[int, int]]:
    """Return a chart for each panel, and the map's (width, height), texels."""
    sizes = []
    for panel in room.panels:
        step = texel_m or _texel_m(panel)
        wide, tall = (max(int(np.ceil(one / step - 1e-9)) + 1, 2) for one in panel.size)
        sizes.append((wide, tall))
    pads = np.array(sizes) + 2 * PAD
    across = int(max(np.ceil(np.sqrt(pads.prod(axis=1).sum() * 1.05)), pads[:, 0].max()))
    across += -across % 4
    places: dict[int, tuple[int, int]] = {}
    x = y = shelf = 0
    for k in sorted(range(len(sizes)), key=lambda one: (-sizes[one][1], -sizes[one][0], one)):
        if x + pads[k, 0] > across:
            x, y, shelf = 0, y + shelf, 0
        places[k] = (x + PAD, y + PAD)
        x += int(pads[k, 0])
        shelf = max(shelf, int(pads[k, 1]))
    made = tuple(Chart(panel, sizes[k], *places[k]) for k, panel in enumerate(room.panels))
    down = y + shelf
    return made, (across, down + -down % 4)


def _texel_m(panel: Panel) -> float:
    if panel.normal[1] > 0.99 and panel.corner[1] < 1e-6:
        return FLOOR_M
    return SMALL_M if min(panel.size) <= SMALL_PANEL_M else WALL_M


@dataclass(frozen=True, slots=True, eq=False)
class Grid:
    """Points on a panel: (n,) u and v, metres; (nv, nu) whether light falls there; positions on request."""

    u: Array
    v: Array
    there: NDArray[np.bool_]
    places: Array


def make_grid(room: Room, panel: Panel, size: tuple[int, int]) -> Grid:
    """Return a grid of (nu, nv) points whose outermost lie on the panel's borders."""
    axes = [np.linspace(0.0, long, count) for long, count in zip(panel.size, size, strict=True)]
    asked = [np.clip(one, min(INSET_M, long / 4), long - min(INSET_M, long / 4))
             for one, long in zip(axes, panel.size, strict=True)]  # fmt: skip
    u, v = np.meshgrid(*asked)
    places = panel.at(u, v)
    there = np.zeros(u.shape, bool)
    for (u0, v0, u1, v1), _ in panel.parts:
        there |= (u >= u0 - 1e-6) & (u <= u1 + 1e-6) & (v >= v0 - 1e-6) & (v <= v1 + 1e-6)
    flat = (places + panel.normal * 2.0 * TOUCHING_M).reshape(-1, 3)
    low, high = flat.min(axis=0), flat.max(axis=0)
    near = (room.boxes[:, 0] < high + INSET_M).all(axis=1) & (room.boxes[:, 1] > low - INSET_M).all(axis=1)
    there &= ~inside_solids(flat, room.boxes[near], -TOUCHING_M).reshape(there.shape)
    return Grid(axes[0], axes[1], there, places)


def fill_missing(values: Array, there: NDArray[np.bool_]) -> Array:
    """Return (nv, nu, ...) values with missing ones taken from the nearest present ones."""
    if there.all() or not there.any():
        return values
    nearest = distance_transform_edt(~there, return_distances=False, return_indices=True)
    return np.asarray(values[tuple(nearest)])


def assemble_map(charts: tuple[Chart, ...], values: list[Array], size: tuple[int, int]) -> NDArray[np.float32]:
    """Return the (H, W, k) map of each chart's (nv, nu, k) values, their borders repeated."""
    out = np.zeros((size[1], size[0], values[0].shape[2]), np.float32)
    for chart, own in zip(charts, values, strict=True):
        padded = np.pad(own, ((PAD, PAD), (PAD, PAD), (0, 0)), mode="edge")
        y, x = chart.y - PAD, chart.x - PAD
        out[y : y + padded.shape[0], x : x + padded.shape[1]] = padded
    return out


def interpolation_weights(nodes: Array, wanted: Array) -> Array:
    """Return the (wanted, nodes) weights of linear interpolation."""
    right = np.clip(np.searchsorted(nodes, wanted, side="right"), 1, len(nodes) - 1)
    share = np.clip((wanted - nodes[right - 1]) / (nodes[right] - nodes[right - 1]), 0.0, 1.0)
    weights = np.zeros((len(wanted), len(nodes)))
    weights[np.arange(len(wanted)), right - 1] = 1.0 - share
    weights[np.arange(len(wanted)), right] += share
    return weights


def upsample(values: Array, coarse: Grid, fine: Grid) -> Array:
    """Return a coarse grid's values interpolated to a fine grid of the same panel.

    Nodes in solids have no say where others have: light would come through walls.
    """
    up, along = interpolation_weights(coarse.v, fine.v), interpolation_weights(coarse.u, fine.u)
    there = coarse.there[..., None]
    weight = np.einsum("ai,bj,ijc->abc", up, along, there.astype(float), optimize=True)
    own = np.einsum("ai,bj,ijc->abc", up, along, values * there, optimize=True) / np.maximum(weight, 1e-9)
    return np.asarray(np.where(weight > 1e-6, own, np.einsum("ai,bj,ijc->abc", up, along, values, optimize=True)))
