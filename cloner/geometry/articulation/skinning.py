"""Joint rotations to transforms, and linear blend skinning."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from cloner.records.arrays import Array

#: Joints that a vertex follows.
INFLUENCES: Final = 4


def dense_weights(joints: NDArray[np.integer], weights: Array, count: int) -> Array:
    """Return the weights (N, J) of ``count`` joints on vertices with joints and weights (N, k)."""
    whole = np.zeros((len(joints), count))
    np.add.at(whole, (np.arange(len(joints))[:, None], joints), weights)
    return whole


def strongest_weights(weights: Array) -> tuple[NDArray[np.int32], Array]:
    """Return the joints and weights (N, 4) of the four largest of all joints' weights (N, J), summing to one."""
    joints = np.argsort(-weights, axis=1, kind="stable")[:, :INFLUENCES]
    kept = np.take_along_axis(weights, joints, axis=1)
    return joints.astype(np.int32), kept / np.maximum(kept.sum(axis=1, keepdims=True), 1e-12)


def skew(vectors: Array) -> Array:
    """Return the cross product matrices (..., 3, 3) of vectors (..., 3)."""
    x, y, z = np.moveaxis(vectors, -1, 0)
    zero = np.zeros_like(x)
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(*vectors.shape, 3)


def rotation_matrices(rotations: Array) -> Array:
    """Return (..., 3, 3) matrices of (..., 3) rotation vectors (Rodrigues), radians."""
    angle = np.linalg.norm(rotations, axis=-1)
    cross = skew(rotations / np.maximum(angle, 1e-12)[..., None])
    sine, cosine = np.sin(angle)[..., None, None], np.cos(angle)[..., None, None]
    return np.asarray(np.eye(3) + sine * cross + (1.0 - cosine) * (cross @ cross))


def rotation_axes(rotations: Array) -> Array:
    """Return (..., 3, 3), columns: rotation axes for each component of rotation vectors (..., 3)."""
    angle = np.linalg.norm(rotations, axis=-1)[..., None, None]
    safe = np.maximum(angle, 1e-9)
    axis = rotations / safe[..., 0]
    sine = np.where(angle < 1e-9, 1.0, np.sin(angle) / safe)
    cosine = (1.0 - np.cos(angle)) / safe
    return np.asarray(sine * np.eye(3) + (1.0 - sine) * axis[..., :, None] * axis[..., None, :] + cosine * skew(axis))


def joint_transforms(joints_m: Array, parents: NDArray[np.integer], rotations: Array) -> Array:
    """Return (..., J, 4, 4) posed-from-rest transforms of all joints; leading axes are alternative poses.

    Parameters
    ----------
    joints_m : (..., J, 3) rest positions, model frame, metres
    parents : (J,) parent index, -1 for the root; parents come before children
    rotations : (..., J, 3) rotation vectors in model axes, radians
    """
    local = np.zeros((*rotations.shape[:-1], 4, 4))
    local[..., 3, 3] = 1.0
    local[..., :3, :3] = rotation_matrices(rotations)
    local[..., :3, 3] = joints_m - np.einsum("...jab,...jb->...ja", local[..., :3, :3], joints_m)
    moved = np.any(rotations != 0.0, axis=(*range(rotations.ndim - 2), -1))
    posed = np.empty_like(local)
    for joint, parent in enumerate(parents):
        if parent < 0:
            posed[..., joint, :, :] = local[..., joint, :, :]
        else:
            above = posed[..., parent, :, :]
            posed[..., joint, :, :] = above @ local[..., joint, :, :] if moved[joint] else above
    return posed


def blend_transforms(transforms: Array, skin_joints: NDArray[np.integer], skin_weights: Array) -> Array:
    """Return the (V, 3, 4) weighted transform of every vertex.

    One sparse product: it gathers no transform a vertex and influence, which is what einsum spends its time on.
    """
    count, width = skin_joints.shape
    rows = np.arange(0, count * width + 1, width)
    shares = csr_matrix((skin_weights.ravel(), skin_joints.ravel(), rows), shape=(count, len(transforms)))
    return np.asarray(shares @ transforms[:, :3].reshape(-1, 12)).reshape(count, 3, 4)


def posed_joints(transforms: Array, joints_m: Array) -> Array:
    """Return the (J, 3) places of joints after their `joint_transforms`, metres."""
    return np.asarray(np.einsum("jab,jb->ja", transforms[:, :3, :3], joints_m) + transforms[:, :3, 3])


def linear_blend_skinning(
    vertices_m: Array, transforms: Array, skin_joints: NDArray[np.integer], skin_weights: Array
) -> Array:
    """Return (V, 3) posed vertices by linear blend skinning, metres."""
    blended = blend_transforms(transforms, skin_joints, skin_weights)
    return np.asarray(np.einsum("vab,vb->va", blended[:, :, :3], vertices_m) + blended[:, :, 3])
