"""Sweeps: a rounded profile along a path."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.meshes.vectors import cross, unit
from cloner.records.arrays import Array

#: Sides of the profile, and the power of its superellipse: 2 is an ellipse, more is flatter.
SIDES: Final = 8
SQUARE: Final = 2.6


def sweep_profile(
    path_m: Array, across: Array, halves_m: Array, *, closed: bool
) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return vertices (N, 3), uv (N, 2) and triangles (T, 3) of a swept rod; open ends have caps.

    Parameters
    ----------
    path_m : (K, 3)
        Without the first point again where the rod is closed.
    across : (K, 3) directions, about perpendicular to the path
    halves_m : (2,)
        Half the thickness along ``across``, and perpendicular to it.
    closed : bool

    Returns
    -------
    uv : u along the path, v around it, each 0 to 1
    """
    if closed:
        path_m, across = (np.concatenate([each, each[:1]]) for each in (path_m, across))
        before = np.concatenate([path_m[-2:-1], path_m[:-1]])
        along = unit(np.concatenate([path_m[1:], path_m[1:2]]) - before)
    else:
        along = unit(np.gradient(path_m, axis=0))
    across = unit(across - np.einsum("kc,kc->k", across, along)[:, None] * along)
    other = cross(along, across)
    turn = np.arange(SIDES + 1) * (2.0 * np.pi / SIDES)
    wave = np.column_stack([np.cos(turn), np.sin(turn)])
    around = np.sign(wave) * np.abs(wave) ** (2.0 / SQUARE) * halves_m
    points = path_m[:, None] + around[None, :, :1] * across[:, None] + around[None, :, 1:] * other[:, None]
    rows, columns = points.shape[:2]
    uv = np.stack(np.meshgrid(np.linspace(0.0, 1.0, rows), np.linspace(0.0, 1.0, columns), indexing="ij"), axis=-1)
    corner = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, :-1], corner[1:, 1:]))
    triangles = [np.column_stack([a, b, c]), np.column_stack([b, d, c])]
    if not closed:
        fan = np.arange(1, SIDES - 1)
        triangles.append(np.column_stack([np.zeros_like(fan), fan + 1, fan]) + corner[0, 0])
        triangles.append(np.column_stack([np.zeros_like(fan), fan, fan + 1]) + corner[-1, 0])
    return points.reshape(-1, 3), uv.reshape(-1, 2), np.concatenate(triangles)
