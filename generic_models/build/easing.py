"""Weights eased where limbs press on the trunk: creases that open over a hand's breadth do not go through themselves.

A limb bent by 90 degrees lets the skin of its crease, r before the joint, touch itself without crossing if the weights
change over r above and below the joint (two rigid halves and their linear blend, drawn in a plane). The default rig
changes them within half of that at groin and armpit. Diffusion over the skin widens the change.

References
----------
Implicit diffusion with cotangent weights: Desbrun et al. 1999, "Implicit fairing of irregular meshes".
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import hanim
import numpy as np
from cage import Cage
from scipy.sparse import csr_matrix, diags
from scipy.sparse.linalg import splu
from skinning import Shares
from source import FloatArray, IntArray


@dataclass(frozen=True, slots=True)
class Crease:
    """How far weights are eased around a joint of the left side.

    Attributes
    ----------
    joint : str
    towards : tuple of float
        From the joint to where skin is pressed, model axes, left side.
    full_m, end_m : float
        Eased fully up to the first distance from the joint, no longer from the second on.
    pressed_m, stretched_m : float
        By how much weights spread, on the crease's side and on the other.
    """

    joint: str
    towards: tuple[float, float, float]
    full_m: float
    end_m: float
    pressed_m: float
    stretched_m: float


#: The least easing with which folds close (docs/mesh.md). A narrow blend behind a wide one, at seat or shin, costs more
#: volume than a wide one on both sides; above the shoulder a wide one would round what stands out in T-pose.
CREASES: Final = (
    Crease("hip", (-0.4, 0.0, 1.0), 0.14, 0.26, 0.06, 0.06),
    Crease("shoulder", (-0.3, -1.0, 0.0), 0.09, 0.20, 0.05, 0.02),
    Crease("knee", (0.0, 0.0, -1.0), 0.08, 0.17, 0.03, 0.03),
)
#: The crease's side turns into the other one over so much of the cosine.
_TURN: Final = 0.7
_STEPS: Final = 4
#: Cotangents of slivers are bounded, so that every vertex takes a mean of its neighbours.
_COTANGENT: Final = (0.02, 5.0)


def eased(carried: Shares, cage: Cage, vertices_m: FloatArray, joints_m: FloatArray) -> Shares:
    """Return the shares diffused over the skin within reach of the creases.

    Parameters
    ----------
    vertices_m, joints_m : (V, 3) and (94, 3), the rest shape, metres.
    """
    columns = np.column_stack([carried.joints, carried.spine, carried.neck])
    body = cage.part("body")
    columns[body] /= columns[body].sum(axis=1, keepdims=True)
    length = np.max([_lengths(crease, vertices_m, joints_m) for crease in CREASES], axis=0)
    between, area = _laplacian(vertices_m, _triangles(cage))
    spread = between.multiply(length[:, None]).multiply(length[None, :]).tocsr() / _STEPS
    solve = splu((diags(area) + diags(np.asarray(spread.sum(axis=1)).ravel()) - spread).tocsc())
    for _ in range(_STEPS):
        columns = solve.solve(area[:, None] * columns)
    return Shares(columns[:, :-2], columns[:, -2], columns[:, -1])


def _smooth(x: FloatArray) -> FloatArray:
    x = np.clip(x, 0.0, 1.0)
    return np.asarray(x * x * (3.0 - 2.0 * x))


def _lengths(crease: Crease, vertices_m: FloatArray, joints_m: FloatArray) -> FloatArray:
    """Return (V,) by how much weights spread at every vertex, metres."""
    lengths = []
    for side, sign in (("l_", 1.0), ("r_", -1.0)):
        away = vertices_m - joints_m[hanim.INDEX[side + crease.joint]]
        far = np.linalg.norm(away, axis=1)
        way = np.array(crease.towards) * [sign, 1.0, 1.0]
        pressed = _smooth(0.5 + 0.5 / _TURN * (away @ way) / (np.linalg.norm(way) * np.maximum(far, 1e-9)))
        fade = _smooth((crease.end_m - far) / (crease.end_m - crease.full_m))
        lengths.append(fade * (crease.stretched_m + (crease.pressed_m - crease.stretched_m) * pressed))
    return np.maximum(*lengths)


def _triangles(cage: Cage) -> IntArray:
    quads = cage.quads[cage.quad_part == 0]
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def _laplacian(vertices_m: FloatArray, triangles: IntArray) -> tuple[csr_matrix, FloatArray]:
    """Return the symmetric cotangent weights between neighbours (V, V), and every vertex's area, m2."""
    count = len(vertices_m)
    area, pairs, values = np.zeros(count), [], []
    for k in range(3):
        first, second, third = (triangles[:, (k + step) % 3] for step in range(3))
        one, other = vertices_m[first] - vertices_m[third], vertices_m[second] - vertices_m[third]
        twice = np.maximum(np.linalg.norm(np.cross(one, other), axis=1), 1e-12)
        np.add.at(area, first, twice / 6.0)
        pairs += [(first, second), (second, first)]
        values += [np.clip(0.5 * (one * other).sum(axis=1) / twice, *_COTANGENT)] * 2
    rows, columns = (np.concatenate(side) for side in zip(*pairs, strict=True))
    between = csr_matrix((np.concatenate(values), (rows, columns)), shape=(count, count))
    return between, np.maximum(area, 1e-9)
