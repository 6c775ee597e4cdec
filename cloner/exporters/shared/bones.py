"""Skeletons of exported files: all 94 H-Anim joints, or fewer under other names.

Where joints are left out, the next kept one above carries their skin; kept joints keep their own orientations, so the
turn of five vertebrae arrives in the one that is left.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.motion.limbs import turns
from cloner.records.arrays import Array
from cloner.records.motions import Motion

Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Bones:
    """Which joints a file's skeleton has.

    Attributes
    ----------
    title : str
        What to call the whole.
    names : tuple of str, K bones, parents before children
    parents : (K,) int64, -1 above the root
    joints : (K,) int64
        The H-Anim joint of every bone.
    carrier : (94,) int64
        The bone that carries the skin of every H-Anim joint.
    """

    title: str
    names: tuple[str, ...]
    parents: Ints
    joints: Ints
    carrier: Ints

    def carried(self, skin_joints: NDArray[np.integer], skin_weights: NDArray[np.floating]) -> tuple[Ints, Array]:
        """Return bones and weights (N, k) of vertices given by H-Anim joints; each bone once a vertex, largest first.

        Weights sum to one in float32; places without weight name bone 0.
        """
        bones = self.carrier[np.asarray(skin_joints, dtype=np.int64)]
        share = np.maximum(skin_weights.astype(np.float64), 0.0)
        for column in range(1, bones.shape[1]):
            for earlier in range(column):
                same = bones[:, column] == bones[:, earlier]
                share[same, earlier] += share[same, column]
                share[same, column] = 0.0
        share = (share / share.sum(axis=1, keepdims=True)).astype(np.float32)
        share /= share.sum(axis=1, keepdims=True)  # once more, in the precision that readers see
        return np.where(share > 0.0, bones, 0), share.astype(np.float64)

    def name_of(self, joint: str) -> str:
        """Return the name of the bone that carries an H-Anim joint's skin."""
        return self.names[int(self.carrier[load_generic().joint(joint)])]

    def rotations(self, motion: Motion) -> Array:
        """Return (F, K, 3) rotation vectors of the bones against their parents, radians."""
        if len(self.names) == motion.rotations.shape[1]:
            return motion.rotations
        world = turns.world_from_local(motion.rotations, load_generic().joint_parents)
        return turns.local_from_world(world[:, self.joints], self.parents)


def hanim_bones() -> Bones:
    """Return all joints under their own names."""
    generic = load_generic()
    every = np.arange(len(generic.joint_names))
    return Bones("H-Anim", tuple(generic.joint_names), generic.joint_parents.astype(np.int64), every, every)


def kept_bones(title: str, names: Mapping[str, str]) -> Bones:
    """Return the skeleton of some joints.

    Parameters
    ----------
    title : str
    names : mapping of str to str
        New name of every H-Anim joint that is kept; the root must be among them.
    """
    generic = load_generic()
    kept = [row for row, joint in enumerate(generic.joint_names) if joint in names]
    place = {row: number for number, row in enumerate(kept)}
    carrier = np.zeros(len(generic.joint_names), dtype=np.int64)
    for row, parent in enumerate(generic.joint_parents):
        carrier[row] = place[row] if row in place else carrier[parent]
    above = [-1 if generic.joint_parents[row] < 0 else int(carrier[generic.joint_parents[row]]) for row in kept]
    new = tuple(names[generic.joint_names[row]] for row in kept)
    return Bones(title, new, np.array(above), np.array(kept), carrier)
