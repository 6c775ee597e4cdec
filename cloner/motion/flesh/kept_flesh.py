"""Volume of a bent joint under dual quaternion skinning, as corrective offsets at rest for linear blend skinning.

References
----------
Kavan et al. 2008 (dual quaternions). The volume of a mesh that moves along straight lines is a cubic of how far.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.geometry.articulation.dual import dual_quaternion_skinning
from cloner.geometry.articulation.skinning import blend_transforms, joint_transforms
from cloner.motion.flesh.bending import flesh
from cloner.records.arrays import Array
from cloner.records.clones import Clone

Ints = NDArray[np.int64]

#: What is left to a joint's volume is put on by no more than this along the normals, metres; with 8 mm a man in a suit
#: lacks 7 % of his shoulder when arms of a T-pose hang, with 14 nobody more than 3.
MOST_ON_M: Final = 0.014
_STEP_M: Final = 1e-3
#: Smaller offsets are left out, metres: nobody sees them.
SMALLEST_M: Final = 3e-4


def corrective_offsets(
    clone: Clone, parents: NDArray[np.integer], normals: Array, side: str, joint: str, rotations: Array
) -> tuple[Ints, Array]:
    """Return the vertices that a bend moves wrongly, and the offsets (N, 3) at rest that correct them, metres.

    Dual quaternions are mixed in as far as the joint's volume at rest wants them; what is left is put on along the
    normals.

    Parameters
    ----------
    clone : Clone
    parents : (94,)
    normals : (V, 3)
        Of the clone's skin.
    side, joint : str
        Whose flesh is kept; see `cloner.motion.flesh.bending.flesh`.
    rotations : (94, 3)
        The pose, rotation vectors of the joints, radians.
    """
    around = flesh(side, joint)
    rows, joints, weights, share, moving = _bent_skin(side, joint)
    rotations = np.where(moving[:, None], rotations, 0.0)  # what other joints do to this flesh is put right by theirs
    rest, count = clone.vertices_m[rows], len(around.rows)
    wanted = around.volume(rest[:count])
    transforms = joint_transforms(clone.joints_m, parents, rotations)
    blend = blend_transforms(transforms, joints, weights)
    linear = np.einsum("vab,vb->va", blend[:, :, :3], rest) + blend[:, :, 3]
    dual = dual_quaternion_skinning(rest, transforms, parents, joints, weights)

    def missing(points: Array) -> float:
        return wanted - around.volume(points[:count])

    way = dual - linear
    shaped = linear + _part(lambda part: missing(linear + part * way)) * way
    out = np.einsum("vab,vb->va", blend[:, :, :3], normals[rows])
    out *= (4.0 * share * (1.0 - share) / np.maximum(np.linalg.norm(out, axis=1), 1e-9))[:, None]
    shaped = shaped + _put_on(lambda far_m: missing(shaped + far_m * out)) * out
    offsets = np.linalg.solve(blend[:, :, :3], (shaped - linear)[..., None])[..., 0]
    moved = np.flatnonzero(np.abs(offsets).max(axis=1) > SMALLEST_M)
    order = moved[np.argsort(rows[moved])]
    return rows[order], offsets[order]


@functools.cache
def _bent_skin(side: str, joint: str) -> tuple[Ints, Ints, Array, Array, NDArray[np.bool_]]:
    """Return the skin that a joint bends, its flesh first, and the joints (94,) that rotate it.

    The skin is vertices (N,), joints and weights (N, 4), and the limb's share (N,).
    """
    generic = load_generic()
    weights, joints = generic.skin_weights.astype(np.float64), generic.skin_joints.astype(np.int64)
    weights /= weights.sum(axis=1, keepdims=True)
    parents, limb = generic.joint_parents, {generic.joint(f"{side}_{joint}")}
    limb |= {k for k in range(len(parents)) if _hangs_on(k, parents, limb)}
    share = (weights * np.isin(joints, sorted(limb))).sum(axis=1)
    turning = [generic.joint(f"{side}_{joint}")]
    if joint == "shoulder":  # its collarbone rises with it
        turning += [generic.joint(f"{side}_{name}") for name in ("sternoclavicular", "acromioclavicular")]
    moved = (weights * np.isin(joints, [*limb, *turning])).sum(axis=1)
    single = weights.max(axis=1) > 0.999
    first = flesh(side, joint).rows
    rest = np.setdiff1d(np.flatnonzero((moved > 0.0) & ~single & (generic.vertex_part == 0)), first)
    rows = np.concatenate([first, rest])
    return rows, joints[rows], weights[rows], share[rows], np.isin(np.arange(len(parents)), turning)


def _hangs_on(joint: int, parents: NDArray[np.integer], above: set[int]) -> bool:
    while joint >= 0:
        if joint in above:
            return True
        joint = int(parents[joint])
    return False


def _part(missing: Callable[[float], float]) -> float:
    """Return the share 0..1 at which nothing is missing; the end that is nearer to it where there is none."""
    known = np.array([0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0])
    values = np.array([missing(float(share)) for share in known])
    if values[0] <= 0.0 or values[-1] >= 0.0:
        return 0.0 if values[0] <= 0.0 else 1.0
    roots = np.roots(np.polyfit(known, values / np.abs(values).max(), 3))
    inside = roots.real[(np.abs(roots.imag) < 1e-9) & (roots.real > 0.0) & (roots.real < 1.0)]
    return float(inside.min()) if len(inside) else 1.0


def _put_on(missing: Callable[[float], float]) -> float:
    """Return the displacement that restores the volume, metres: two secant steps within `MOST_ON_M`."""
    way, left = 0.0, missing(0.0)
    for _ in range(2):
        gain = (left - missing(way + _STEP_M)) / _STEP_M
        way = float(np.clip(way + left / gain, -MOST_ON_M, MOST_ON_M)) if gain > 0.0 else way
        left = missing(way)
    return way
