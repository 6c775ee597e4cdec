"""Dual quaternion skinning: limbs keep their thickness where linear blending lets them collapse.

References
----------
Kavan, Collins, Zara and O'Sullivan 2008, Geometric skinning with approximate dual quaternion blending.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from cloner.geometry.meshes.vectors import cross
from cloner.records.arrays import Array


def dual_quaternion_skinning(
    vertices_m: Array,
    transforms: Array,
    parents: NDArray[np.integer],
    skin_joints: NDArray[np.integer],
    skin_weights: Array,
) -> Array:
    """Return (V, 3) posed vertices, metres.

    Parameters
    ----------
    vertices_m : (V, 3) at rest
    transforms : (J, 4, 4)
        Posed from rest, rigid.
    parents : (J,)
        A joint's quaternion is taken on its parent's side, so that neighbours blend the short way.
    skin_joints, skin_weights : (V, K)
    """
    real = Rotation.from_matrix(np.array(transforms[:, :3, :3])).as_quat()
    for joint, parent in enumerate(parents):
        if parent >= 0 and real[joint] @ real[parent] < 0.0:
            real[joint] = -real[joint]
    shift = np.column_stack([transforms[:, :3, 3], np.zeros(len(transforms))])
    dual = 0.5 * _product(shift, real)
    turn = np.einsum("vk,vka->va", skin_weights, real[skin_joints])
    move = np.einsum("vk,vka->va", skin_weights, dual[skin_joints])
    length = np.linalg.norm(turn, axis=1, keepdims=True)
    turn, move = turn / length, move / length
    moved = 2.0 * _product(move, turn * (-1.0, -1.0, -1.0, 1.0))[:, :3]
    return np.asarray(Rotation.from_quat(turn).apply(np.array(vertices_m)) + moved)


def _product(first: Array, second: Array) -> Array:
    """Return products (N, 4) of quaternions x, y, z, w."""
    a, b = first[:, :3], second[:, :3]
    imaginary = first[:, 3:] * b + second[:, 3:] * a + cross(a, b)
    return np.column_stack([imaginary, first[:, 3] * second[:, 3] - np.einsum("na,na->n", a, b)])
