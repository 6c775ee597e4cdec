"""A skinned mesh cut into rigid pieces, one per joint."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class Piece:
    """The triangles that one joint moves most.

    Attributes
    ----------
    joint : int
    rows : (T',) rows of the triangle table
    vertex : (N,) mesh vertex of every local vertex, ascending
    triangles : (T', 3) local vertices
    """

    joint: int
    rows: NDArray[np.int64]
    vertex: NDArray[np.int32]
    triangles: NDArray[np.int32]


def dominant_joint(skin_joints: NDArray[np.integer], skin_weights: NDArray[np.floating]) -> NDArray[np.int64]:
    """Return the (N,) joint with the largest weight of every vertex."""
    return np.asarray(np.take_along_axis(skin_joints, skin_weights.argmax(axis=1)[:, None], axis=1)[:, 0], np.int64)


def partition(
    triangles: NDArray[np.int32],
    skin_joints: NDArray[np.integer],
    skin_weights: NDArray[np.floating],
    parents: NDArray[np.integer],
    *,
    overlap: int | NDArray[np.integer] = 0,
) -> tuple[Piece, ...]:
    """Return the pieces of a mesh.

    A triangle goes to the joint with the largest sum of weights over its
    corners, so neighbouring pieces repeat the very same border vertices.

    Parameters
    ----------
    parents : (J,) int
        Parent joint of every joint, -1 for the root.
    overlap : int or (J,) int
        Rings of triangles of the joints above that every piece, or every joint's piece, repeats: a bent joint then
        opens no gap between rigid pieces, and what is repeated turns inwards. With 0 every triangle lies in just one.
    """
    if len(triangles) == 0:
        return ()
    place = len(parents) * np.arange(len(triangles))[:, None, None] + skin_joints[triangles]
    total = np.bincount(place.ravel(), skin_weights[triangles].ravel(), minlength=len(triangles) * len(parents))
    owner = total.reshape(len(triangles), len(parents)).argmax(axis=1)
    rings = np.broadcast_to(overlap, len(parents))
    pieces = []
    for joint in np.unique(owner):
        above = np.isin(owner, _above(int(joint), parents))
        rows = np.flatnonzero(_dilated(owner == joint, above, triangles, int(rings[joint])))
        vertex, local = np.unique(triangles[rows], return_inverse=True)
        pieces.append(Piece(int(joint), rows, vertex.astype(np.int32), local.reshape(-1, 3).astype(np.int32)))
    return tuple(pieces)


def _above(joint: int, parents: NDArray[np.integer]) -> list[int]:
    """Return the joints between a joint and the root, the root too."""
    found = []
    while parents[joint] >= 0:
        joint = int(parents[joint])
        found.append(joint)
    return found


def _dilated(
    own: NDArray[np.bool_], open_: NDArray[np.bool_], triangles: NDArray[np.int32], rings: int
) -> NDArray[np.bool_]:
    """Return the own triangles with the open ones that lie at most ``rings`` neighbours away."""
    for _ in range(rings):
        touched = np.zeros(int(triangles.max()) + 1, dtype=bool)
        touched[triangles[own]] = True
        own = own | (open_ & touched[triangles].any(axis=1))
    return own
