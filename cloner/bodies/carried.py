"""Joints that follow the skin around them, and hair and loose cloth that follow the skin below."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from dataclasses import replace

import numpy as np
from scipy.sparse import csr_array
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.records.arrays import Array
from cloner.records.heads import Shell

#: A joint whose skin it shares with its parent less than this, in vertices, goes with its parent.
LEAST: float = 0.5
#: Skin points that carry a point of hair or loose cloth.
NEAREST: int = 4


@functools.cache
def _rings() -> csr_array:
    """Return (94, V) shares of the skin round each joint, where it and its parent move skin together."""
    generic = load_generic()
    count = len(generic.vertices_m)
    weight = np.zeros((len(generic.joint_names), count))
    for column in range(generic.skin_joints.shape[1]):
        np.add.at(weight, (generic.skin_joints[:, column], np.arange(count)), generic.skin_weights[:, column])
    both = np.zeros_like(weight)
    for row, parent in enumerate(generic.joint_parents):
        if int(parent) >= 0:
            both[row] = weight[row] * weight[parent]
        own = float(both[row].sum())
        both[row] = both[row] / own if own > LEAST else (both[int(parent)] if int(parent) >= 0 else both[row])
    return csr_array(both)


def joint_shifts(shift_m: Array) -> Array:
    """Return the displacements (94, 3) of joints for displacements of the skin (V, 3), metres."""
    return np.asarray(_rings() @ shift_m)


def move_with_skin(points_m: Array, skin_m: Array, shift_m: Array) -> Array:
    """Return points (N, 3) moved with the nearest skin."""
    away, rows = cKDTree(skin_m).query(points_m, k=NEAREST)
    weight = 1.0 / np.maximum(away, 1e-4)
    weight /= weight.sum(axis=1, keepdims=True)
    return np.asarray(points_m + np.einsum("nk,nka->na", weight, shift_m[rows]))


def move_shells_with_skin(shells: Iterable[Shell], skin_m: Array, shift_m: Array) -> tuple[Shell, ...]:
    """Return hair and loose cloth moved with the skin (N, 3) below them, displacements (N, 3) metres."""
    return tuple(replace(shell, vertices_m=move_with_skin(shell.vertices_m, skin_m, shift_m)) for shell in shells)
