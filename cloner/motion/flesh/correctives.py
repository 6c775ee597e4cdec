"""Corrective shapes: morph targets that keep the volume around bent joints, and their drivers.

Linear skinning, the only one that files know, loses up to half of a shoulder's, hip's or knee's flesh over their
range. In a table of angles the limb is bent by dual quaternions as well, mixed in as far as its volume wants; what is
left is put on along the normals. The difference, turned back to rest, is a target. Between the table's directions
weights follow the bone's direction in its parent's frame.

References
----------
Lewis, Cordner and Fong 2000, Pose space deformation (targets by pose, interpolated by radial functions). Kavan et al.
2008 (dual quaternions).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.caching import cached_per_object
from cloner.generic.load import load_generic
from cloner.generic.surfaces import surface_normals
from cloner.motion.flesh.bending import JointBend, bent_rotations
from cloner.motion.flesh.kept_flesh import corrective_offsets
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import SIDES, Body, body_of
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

Ints = NDArray[np.int64]

#: How the names of corrective targets begin.
CORRECTIVE: Final = "corrective_"
#: The table: ways a joint bends, the angles with a target of their own, and those in which it is told to have none.
TABLE: Final = {
    "shoulder": ((JointBend("shoulder", "raised", (0, 20, 50, 80, 105, 130, 150)), ()),
                 (JointBend("shoulder", "forward", (15, 35, 60, 90, 120, 150)), ())),
    "elbow": ((JointBend("elbow", "bent", (0, 60, 100, 140)), ()),),
    "hip": ((JointBend("hip", "forward", (-20, 45, 80, 110)), (0,)), (JointBend("hip", "spread", (40,)), ())),
    "knee": ((JointBend("knee", "bent", (50, 95, 135)), (0,)),),
}  # fmt: skip
_NEXT: Final = {"shoulder": "elbow", "elbow": "wrist", "hip": "knee", "knee": "ankle"}
#: Below a skirt no hip or knee is corrected: cloth is carried by its own weights and would be pierced.
UNDER_CLOTH: Final = ("hip", "knee")
#: Rest lies nearer than this to a direction of the table: that one has no target, radians.
SAME_RAD: Final = np.radians(4.0)


@dataclass(frozen=True, slots=True, eq=False)
class Driver:
    """The driver of one joint's targets.

    Attributes
    ----------
    joint : str
    bone : (3,) float64
        Unit direction of its bone at rest, model axes.
    targets : tuple of str, K
        "" where nothing is to be corrected.
    directions : (K, 3) float64
        The bone's directions in the parent's frame for which each target was made.
    weigh : (K, K) float64
        Weights of the targets are the angles (K,) to all directions, radians, times this.
    """

    joint: str
    bone: Array
    targets: tuple[str, ...]
    directions: Array
    weigh: Array

    def weights(self, rotations: Array) -> dict[str, Array]:
        """Return weights (F,) in 0..1 for rotation vectors (F, 3) of the joint against its parent."""
        angles = _angles(turns.matrices(rotations) @ self.bone, self.directions)
        found = np.clip(angles @ self.weigh, 0.0, 1.0)
        return {name: found[:, k] for k, name in enumerate(self.targets) if name}

    def told(self, joint: str) -> dict[str, Any]:
        """Return the driver, under the name that its joint has in a file, for programs that drive targets."""
        return {
            "joint": joint,
            "bone": self.bone.round(5).tolist(),
            "targets": list(self.targets),
            "directions": self.directions.round(5).tolist(),
            "weigh": self.weigh.round(5).tolist(),
        }


@cached_per_object
def with_correctives(clone: Clone) -> tuple[Clone, tuple[Driver, ...]]:
    """Return the clone, in its own rest pose, with corrective targets after its others, and their drivers."""
    body, normals = body_of(clone), surface_normals(clone.vertices_m)
    covered = any(shell.kind == "cloth" for shell in clone.shells)
    drivers, rows, deltas = [], [], []
    for joint, ways in TABLE.items():
        if covered and joint in UNDER_CLOTH:
            continue
        for side in SIDES:
            driver, found = _driver(clone, body, normals, side, joint, ways)
            drivers.append(driver)
            rows += [row for row, _ in found]
            deltas += [delta for _, delta in found]
    names = [name for driver in drivers for name in driver.targets if name]
    start = clone.morph_start[-1] + np.cumsum([len(row) for row in rows])
    return replace(
        clone,
        morph_names=(*clone.morph_names, *names),
        morph_index=np.concatenate([clone.morph_index, *rows]).astype(np.int32),
        morph_delta_m=np.concatenate([clone.morph_delta_m, *deltas]).astype(np.float32),
        morph_start=np.append(clone.morph_start, start).astype(np.int32),
    ), tuple(drivers)


def drive_correctives(motion: Motion, drivers: Sequence[Driver]) -> Motion:
    """Return the motion with the weights of corrective targets for its own bends."""
    joints, weights = load_generic().joint_names, dict(motion.weights)
    for driver in drivers:
        weights |= driver.weights(motion.rotations[:, joints.index(driver.joint)])
    return replace(motion, weights=weights)


def _driver(
    clone: Clone, body: Body, normals: Array, side: str, joint: str, ways: Sequence[tuple[JointBend, tuple[float, ...]]]
) -> tuple[Driver, list[tuple[Ints, Array]]]:
    """Return the driver of a joint, and vertices and offsets, metres, of its targets."""
    own, end = body.joint(f"{side}_{joint}"), body.joint(f"{side}_{_NEXT[joint]}")
    bone = clone.joints_m[end] - clone.joints_m[own]
    bone /= np.linalg.norm(bone)
    names, directions, found = [""], [bone], []
    for bend, still in ways:
        angles = (*bend.degrees, *still)
        for degrees, rotations in zip(angles, bent_rotations(body, side, bend, angles), strict=True):
            direction = turns.matrices(rotations[own]) @ bone
            if _angles(direction[None], np.array(directions)).min() < SAME_RAD:
                continue
            shaped = degrees in bend.degrees
            names.append(f"{CORRECTIVE}{side}_{joint}_{bend.way}_{degrees:.0f}" if shaped else "")
            directions.append(direction)
            if shaped:
                found.append(corrective_offsets(clone, body.parents, normals, side, joint, rotations))
    every = np.array(directions)
    weigh: Array = np.asarray(np.linalg.inv(_angles(every, every)), dtype=np.float64)
    return Driver(f"{side}_{joint}", bone, tuple(names), every, weigh), found


def _angles(first: Array, second: Array) -> Array:
    """Return (N, K) angles between unit vectors (N, 3) and (K, 3), radians."""
    return np.asarray(np.arccos(np.clip(first @ second.T, -1.0, 1.0)))
