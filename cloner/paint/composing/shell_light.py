"""Lighting of loose clothing, matched to the garment that it continues.

A skirt or a coat's lower part is a surface of its own and its photos were evened by themselves; where it leaves the
body the same cloth is seen on both, and its colours must meet.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.geometry.charts.atlas import colours_at, map_atlas
from cloner.records.arrays import Array
from cloner.records.heads import Shell
from cloner.records.labels import SURFACES
from cloner.vision.photographs.blending import push_pull
from cloner.vision.retouching.normalising import apply_light, beyond_light, log_levels

#: Upper edge of a shell: so far below the highest place of its sector (of so many) it is the body's neighbour.
RIM_M, SECTORS = 0.03, 24
REACH_M: Final = 0.04  # the body's skin beside that edge lies no farther away
#: Of one vertex's say: how much a gain is held at none, so that a rim of few vertices changes little.
HOLD: Final = 4.0
WORN: Final = [SURFACES.index(name) for name in ("upper_clothes", "lower_clothes")]


def match_light_of_body(shell: Shell, vertices_m: Array, worn_rgb: Array, surfaces: Array) -> Shell:
    """Return loose clothing with its upper edge in the body's colours, by the angle around it.

    Parameters
    ----------
    shell : Shell
        Of kind ``cloth``; one whose upper edge shows something else than the body there, a scarf, stays as it is.
    vertices_m : (V, 3) of the body
    worn_rgb : (V, 3) levels of its clothes
    surfaces : (V, 6) shares of ``SURFACES``
    """
    places = shell.vertices_m
    turn = np.arctan2(places[:, 0] - places[:, 0].mean(), places[:, 2] - places[:, 2].mean())
    sector = ((turn / (2.0 * np.pi) + 0.5) * SECTORS).astype(np.int64) % SECTORS
    top = np.full(SECTORS, -np.inf)
    np.maximum.at(top, sector, places[:, 1])
    rim = np.flatnonzero(places[:, 1] > top[sector] - RIM_M)
    away, near = cKDTree(vertices_m).query(places[rim])
    own = colours_at(shell.rgba[..., :3], shell.uv[rim]).astype(np.float64)
    gap = np.asarray(log_levels(worn_rgb[near])) - np.asarray(log_levels(own))
    weight = surfaces[near][:, WORN].sum(axis=1) * (away < REACH_M) / (1.0 + beyond_light(gap) ** 4)
    basis = _angular_basis(turn)
    weighted = basis[rim] * weight[:, None]
    gains = np.linalg.solve(weighted.T @ basis[rim] + HOLD * np.eye(basis.shape[1]), weighted.T @ gap)
    rgba = shell.rgba.copy()
    rgba[..., :3] = np.rint(
        apply_light(rgba[..., :3].astype(np.float64), _interpolate_over_texture(shell, basis @ gains))
    )
    return replace(shell, rgba=rgba)


def _angular_basis(turn: Array) -> Array:
    """Return the basis (N, 5) of light around a person: constant, first and second harmonics."""
    return np.column_stack([np.ones(len(turn)), *(f(k * turn) for k in (1, 2) for f in (np.cos, np.sin))])


def _interpolate_over_texture(shell: Shell, values: Array) -> NDArray[np.float32]:
    """Return values (S, S, 3) of vertices (N, 3) over the texture, extended beyond the charts."""
    atlas = map_atlas(shell.uv, shell.triangles, shell.triangles, shell.rgba.shape[0])
    picture = np.zeros((*atlas.shape, 3), np.float32)
    picture.reshape(-1, 3)[atlas.texel] = atlas.interpolate(values)
    return push_pull(picture, atlas.covered().astype(np.float32))
