"""A person's skeleton and soles for motions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman, load_generic
from cloner.motion.limbs import turns
from cloner.motion.limbs.clearance import arm_clearance_rad, leg_clearance_rad
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

SIDES: Final = ("l", "r")
#: H-Anim's joints from the hips up.
SPINE: Final = (*(f"vl{k}" for k in range(5, 0, -1)), *(f"vt{k}" for k in range(12, 0, -1)))
NECK: Final = (*(f"vc{k}" for k in range(7, 0, -1)), "skullbase")
#: Joints of a foot that turn as the ankle does; only the toes bend.
#: Half the length of the part of a sole that counts as heel, ball or toes, metres; taste.
PATCH_M: Final = 0.02
FOOT: Final = ("ankle", "subtalar", "midtarsal")


@dataclass(frozen=True, slots=True, eq=False)
class Body:
    """One person's skeleton and soles.

    Attributes
    ----------
    joints_m : (94, 3) float64, rest pose, model frame
    parents : (94,) int
    names : tuple of str
    soles : mapping-like tuple of ((N, 3) float64, (N, 4) int, (N, 4) float64), left and right
        Rest points of each sole with the joints that carry them and their shares.
    rolls : tuple of (3, N) float64, left and right
        Rows of weights that make the middle of the heel, of the ball and of the toes from a sole's points: what a
        foot rolls over.
    arm_clearance_rad : float
        Angle from straight down at which hanging arms are clear of the trunk, radians.
    leg_clearance_rad : float
        Least angle from straight down, positive outwards, at which straight legs do not touch, radians.
    """

    joints_m: Array
    parents: NDArray[np.integer]
    names: tuple[str, ...]
    soles: tuple[tuple[Array, NDArray[np.integer], Array], ...]
    rolls: tuple[Array, ...]
    arm_clearance_rad: float
    leg_clearance_rad: float

    def joint(self, name: str) -> int:
        """Return the number of a joint."""
        return self.names.index(name)

    def arm_aside(self, side: str) -> float:
        """Return the angle about the model's Z axis that holds a hanging arm clear of the trunk, radians."""
        return self.arm_clearance_rad if side == "l" else -self.arm_clearance_rad

    def world(self, motion: Motion) -> Array:
        """Return (F, 94, 3, 3) orientations of the joints in the model frame."""
        return turns.world_from_local(motion.rotations, self.parents)

    def places(self, motion: Motion) -> Array:
        """Return (F, 94, 3) places of the joints, model frame, metres."""
        return turns.joint_positions(self.world(motion), self.joints_m, self.parents, motion.root_m)

    def sole_points(self, world: Array, root_m: Array) -> tuple[Array, Array]:
        """Return the (F, N, 3) places of the left and the right sole's points, metres."""
        where = turns.joint_positions(world, self.joints_m, self.parents, root_m)
        found = []
        for rest, joints, shares in self.soles:
            offset = rest[:, None] - self.joints_m[joints]
            moved = where[:, joints] + np.einsum("fnkab,nkb->fnka", world[:, joints], offset)
            found.append(np.einsum("nk,fnka->fna", shares, moved))
        return found[0], found[1]


def body_of(clone: Clone) -> Body:
    """Return the skeleton and soles of a clone."""
    generic = load_generic()
    soles, rolls = [], []
    for side in ("left", "right"):
        rows = np.flatnonzero(generic.region("sole") & generic.region(f"foot_{side}"))
        soles.append((clone.vertices_m[rows], *_skinned_by(generic, rows)))
        rolls.append(_sole_weights(clone.vertices_m[rows], clone.joints_m[generic.joint(f"{side[0]}_metatarsal")]))
    parents, names = generic.joint_parents.astype(np.int64), tuple(generic.joint_names)
    out = arm_clearance_rad(clone.vertices_m, clone.joints_m)
    legs = leg_clearance_rad(clone.vertices_m, clone.joints_m)
    return Body(clone.joints_m, parents, names, tuple(soles), tuple(rolls), out, legs)


def _sole_weights(sole_m: Array, ball_m: Array) -> Array:
    """Return (3, N) weights of heel, ball and toes; patches of `PATCH_M` along the foot."""
    low = sole_m[:, 1] < sole_m[:, 1].min() + PATCH_M
    ends = [sole_m[low, 2].min(), ball_m[2], sole_m[low, 2].max()]
    near = np.array([low & (np.abs(sole_m[:, 2] - end) < PATCH_M) for end in ends], dtype=np.float64)
    return np.asarray(near / np.maximum(near.sum(axis=1, keepdims=True), 1.0))


def _skinned_by(generic: GenericHuman, rows: NDArray[np.integer]) -> tuple[NDArray[np.integer], Array]:
    weights = generic.skin_weights[rows].astype(np.float64)
    return generic.skin_joints[rows].astype(np.int64), weights / weights.sum(axis=1, keepdims=True)


def below(body: Body, joint: int) -> list[int]:
    """Return a joint and all that hang on it."""
    inside = {joint}
    for child, parent in enumerate(body.parents):
        if int(parent) in inside:
            inside.add(child)
    return sorted(inside)
