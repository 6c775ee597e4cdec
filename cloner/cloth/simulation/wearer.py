"""The body under a garment: positions of its skin in every frame of a motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

Ints = NDArray[np.int64]

#: Frames a second of every cycle.
FRAMES_PER_S: Final = 30
#: What a skirt meets; arms swing beside it. Sleeves and capes meet arms and hands too.
MET: Final = ("torso", "pelvis", "left_thigh", "right_thigh", "left_calf", "right_calf", "left_foot", "right_foot")
ARMS: Final = ("left_upper_arm", "right_upper_arm", "left_forearm", "right_forearm", "left_hand", "right_hand")


@dataclass(frozen=True, slots=True, eq=False)
class Wearer:
    """A clone's skin that cloth can collide with.

    Attributes
    ----------
    clone : Clone
    rows : (B,) int64
        Vertices of the generic human.
    triangles : (T, 3) int64, into the rows
    """

    clone: Clone
    rows: Ints
    triangles: Ints

    def posed(self, root_m: Array, rotations: Array) -> Array:
        """Return (B, 3) the skin of a frame, model frame, metres."""
        generic = load_generic()
        transforms = joint_transforms(self.clone.joints_m, generic.joint_parents.astype(np.int32), rotations)
        joints, weights = generic.skin_joints[self.rows].astype(np.int32), generic.skin_weights[self.rows]
        return (
            linear_blend_skinning(self.clone.vertices_m[self.rows], transforms, joints, weights.astype(np.float64))
            + root_m
        )


def make_wearer(clone: Clone, *, whole: bool = False) -> Wearer:
    """Return a clone's collision surface; ``whole`` with arms and neck."""
    generic = load_generic()
    names = (*MET, *ARMS) if whole else MET
    met = generic.segment(*names)
    if whole:
        met |= generic.region("neck") & (generic.head_blend < 0.9)
    met &= generic.skin
    triangles, _ = generic.triangles()
    triangles = triangles[met[triangles].all(axis=1)]
    rows = np.unique(triangles)
    return Wearer(clone, rows.astype(np.int64), np.searchsorted(rows, triangles).astype(np.int64))


def cycle_frames(motion: Motion) -> tuple[Array, Array]:
    """Return root (F, 3) and rotations (F, 94, 3) of one cycle at `FRAMES_PER_S`, without the repeated first frame."""
    span = float(motion.times_s[-1])
    count = max(2, round(span * FRAMES_PER_S))
    at = np.arange(count) / count * span
    flat = np.concatenate([motion.root_m, motion.rotations.reshape(len(motion.times_s), -1)], axis=1)
    after = np.searchsorted(motion.times_s, at, side="right").clip(1, len(motion.times_s) - 1)
    early, late = motion.times_s[after - 1], motion.times_s[after]
    share = ((at - early) / (late - early))[:, None]
    mixed = (1.0 - share) * flat[after - 1] + share * flat[after]
    return mixed[:, :3], mixed[:, 3:].reshape(count, -1, 3)


@dataclass(frozen=True, slots=True, eq=False)
class Skin:
    """The skin at two times.

    Attributes
    ----------
    early_m, late_m : (B, 3) float64
    normals : (B, 3) float64
        Outward, at the later moment.
    """

    early_m: Array
    late_m: Array
    normals: Array


def skin_interval(body: Wearer, early_m: Array, late_m: Array) -> Skin:
    """Return the skin between two frames."""
    return Skin(early_m, late_m, vertex_normals(late_m, body.triangles.astype(np.int32)))
