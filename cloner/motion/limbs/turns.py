"""Rotations of many joints over many frames."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from cloner.records.arrays import Array


def rotations_between(first: Array, second: Array) -> Array:
    """Return the smallest rotations (..., 3, 3) from directions ``first`` (..., 3) to ``second``.

    Opposite directions turn about whatever axis is perpendicular to them.
    """
    a = np.asarray(first / np.linalg.norm(first, axis=-1, keepdims=True))
    b = np.asarray(second / np.linalg.norm(second, axis=-1, keepdims=True))
    a, b = np.broadcast_arrays(a, b)
    axis = np.cross(a, b)
    sine, cosine = np.linalg.norm(axis, axis=-1), np.einsum("...k,...k->...", a, b)
    spare = np.cross(a, np.eye(3)[np.argmin(np.abs(a), axis=-1)])
    axis = np.where((sine < 1e-9)[..., None] & (cosine < 0.0)[..., None], spare, axis)
    length = np.linalg.norm(axis, axis=-1, keepdims=True)
    vector = axis / np.maximum(length, 1e-12) * np.arctan2(sine, cosine)[..., None]
    return matrices(vector)


def matrices(vectors: Array) -> Array:
    """Return (..., 3, 3) rotation matrices of (..., 3) rotation vectors, radians."""
    flat = Rotation.from_rotvec(np.array(vectors, dtype=np.float64).reshape(-1, 3)).as_matrix()
    return np.asarray(flat.reshape(*np.shape(vectors)[:-1], 3, 3))


def vectors(turns: Array) -> Array:
    """Return (..., 3) rotation vectors, radians, of (..., 3, 3) rotation matrices."""
    flat = Rotation.from_matrix(np.array(turns, dtype=np.float64).reshape(-1, 3, 3)).as_rotvec()
    return np.asarray(flat.reshape(*np.shape(turns)[:-2], 3))


def rotations_about(axis: int, angles: Array) -> Array:
    """Return rotations (..., 3, 3) about a model axis (0, 1, 2) by ``angles``, radians."""
    turning = np.zeros((*np.shape(angles), 3))
    turning[..., axis] = angles
    return matrices(turning)


def interpolated_rotations(first: Array, second: Array, part: float) -> Array:
    """Return the rotations (..., 3, 3) at ``part`` of the way from ``first`` to ``second``."""
    return np.asarray(first @ matrices(part * vectors(np.swapaxes(first, -1, -2) @ second)))


def world_from_local(rotations: Array, parents: NDArray[np.integer]) -> Array:
    """Return (F, J, 3, 3) model-frame orientations of joints turned by (F, J, 3) vectors against their parents."""
    world = matrices(rotations)
    for joint, parent in enumerate(parents):
        if parent >= 0:
            world[:, joint] = world[:, parent] @ world[:, joint]
    return world


def local_from_world(world: Array, parents: NDArray[np.integer]) -> Array:
    """Return (F, J, 3) rotation vectors against the parents, radians, of (F, J, 3, 3) orientations."""
    local = world.copy()
    child = np.flatnonzero(np.asarray(parents) >= 0)
    local[:, child] = np.swapaxes(world[:, np.asarray(parents)[child]], -1, -2) @ world[:, child]
    return vectors(local)


def joint_positions(world: Array, joints_m: Array, parents: NDArray[np.integer], root_m: Array) -> Array:
    """Return the joints' positions (F, J, 3), metres, for orientations (F, J, 3, 3) and root displacements (F, 3)."""
    found = np.empty((len(world), len(joints_m), 3))
    for joint, parent in enumerate(parents):
        if parent < 0:
            found[:, joint] = joints_m[joint] + root_m
        else:
            found[:, joint] = found[:, parent] + world[:, parent] @ (joints_m[joint] - joints_m[parent])
    return found
