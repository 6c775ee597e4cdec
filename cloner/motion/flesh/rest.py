"""Other rest poses: the T-pose of avatar programs, H-Anim's hanging arms."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from cloner.caching import cached_per_object
from cloner.generic.load import load_generic
from cloner.generic.surfaces import surface_normals
from cloner.geometry.articulation.fingers import palm_normal
from cloner.geometry.articulation.skinning import (
    blend_transforms,
    joint_transforms,
    linear_blend_skinning,
    posed_joints,
)
from cloner.motion.flesh.bending import CLAVICLE_RAD, FLESHED
from cloner.motion.flesh.kept_flesh import corrective_offsets
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import FOOT, SIDES, Body, below, body_of
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.gait import aim_limb, follow
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.heads import Shell

#: Joints that turn less than this keep their flesh by themselves, radians; taste.
LEAST_RAD = np.radians(3.0)


@cached_per_object
def in_t_pose(clone: Clone) -> Clone:
    """Return the clone in a T-pose: arms level to the sides, palms down, legs straight down."""
    return in_pose(clone, t_pose(body_of(clone)))


@cached_per_object
def in_hanging_pose(clone: Clone) -> Clone:
    """Return the clone in H-Anim's own rest pose: arms hanging at the sides, palms inwards."""
    return in_pose(clone, hanging_pose(body_of(clone)))


def in_pose(clone: Clone, rotations: Array) -> Clone:
    """Return the clone with another rest pose.

    Limbs keep their flesh (`cloner.motion.flesh.kept_flesh`). Skin, shells, joints, morph targets and feature points
    are bound anew in that pose; the photos' poses are left out, they belong to the old rest pose. Feet stay on the
    floor.

    Parameters
    ----------
    clone : Clone
    rotations : (94, 3)
        Rotation vectors of the joints against the old rest pose, radians.
    """
    generic = load_generic()
    clone = _with_flesh_corrected(clone, rotations)
    transforms = joint_transforms(clone.joints_m, generic.joint_parents, rotations)
    joints, weights = generic.skin_joints.astype(np.int32), generic.skin_weights.astype(np.float64)
    vertices = linear_blend_skinning(clone.vertices_m, transforms, joints, weights)
    drop = np.array([0.0, -vertices[:, 1].min() + clone.vertices_m[:, 1].min(), 0.0])
    blended = blend_transforms(transforms, joints, weights)
    moved = np.einsum("mab,mb->ma", blended[clone.morph_index, :, :3], clone.morph_delta_m)
    return replace(
        clone,
        vertices_m=vertices + drop,
        joints_m=posed_joints(transforms, clone.joints_m) + drop,
        morph_delta_m=moved.astype(np.float32),
        shells=tuple(_reposed(shell, transforms, drop) for shell in clone.shells),
        features_m=_moved_features(clone, blended, drop),
        views={},
    )


def _with_flesh_corrected(clone: Clone, rotations: Array) -> Clone:
    """Return the clone with the correctives of a pose applied at rest."""
    generic = load_generic()
    vertices, normals = clone.vertices_m.copy(), surface_normals(clone.vertices_m)
    for side, joint in ((side, joint) for side in SIDES for joint in FLESHED):
        if np.linalg.norm(rotations[generic.joint(f"{side}_{joint}")]) > LEAST_RAD:
            rows, offsets = corrective_offsets(clone, generic.joint_parents, normals, side, joint, rotations)
            vertices[rows] += offsets
    return replace(clone, vertices_m=vertices)


def _moved_features(clone: Clone, blended: Array, drop: Array) -> dict[str, Array]:
    """Return the feature points moved with their nearest skin vertex."""
    if not clone.features_m:
        return {}
    points = np.array(list(clone.features_m.values()))
    _, nearest = cKDTree(clone.vertices_m).query(points)
    moved = np.einsum("nab,nb->na", blended[nearest, :, :3], points) + blended[nearest, :, 3] + drop
    return dict(zip(clone.features_m, moved, strict=True))


def _reposed(shell: Shell, transforms: Array, drop: Array) -> Shell:
    return replace(
        shell,
        vertices_m=linear_blend_skinning(shell.vertices_m, transforms, shell.skin_joints, shell.skin_weights) + drop,
    )


def hanging_pose(body: Body) -> Array:
    """Return (94, 3) rotation vectors of arms hanging at the sides and straight legs, radians."""
    world = np.tile(np.eye(3), (1, len(body.names), 1, 1))
    for side in SIDES:
        out = turns.rotations_about(2, np.array([body.arm_aside(side)]))
        aim_limb(body, world, side, "shoulder", out)
        aim_limb(body, world, side, "elbow", out)
        follow(body, world, side)
        _straighten_leg(body, world, side)
    return np.asarray(shared_twist(body, turns.local_from_world(world, body.parents))[0])


def _straighten_leg(body: Body, world: Array, side: str) -> None:
    """Straighten a leg down, or as far out as wide trousers need, with the foot flat."""
    out = max(body.leg_clearance_rad, 0.0) * (1.0 if side == "l" else -1.0)
    for name in ("hip", "knee"):
        aim_limb(body, world, side, name, turns.rotations_about(2, np.array([out])))
    for name in (*FOOT, "metatarsal"):
        world[:, body.joint(f"{side}_{name}")] = np.eye(3)


def t_pose(body: Body) -> Array:
    """Return (94, 3) rotation vectors of the T-pose, radians."""
    world = np.tile(np.eye(3), (1, len(body.names), 1, 1))
    down_to_side = {
        "l": turns.rotations_about(2, np.array([np.pi / 2])),
        "r": turns.rotations_about(2, np.array([-np.pi / 2])),
    }
    for side in SIDES:
        raised = turns.rotations_about(2, np.array([CLAVICLE_RAD if side == "l" else -CLAVICLE_RAD]))
        for name in ("sternoclavicular", "acromioclavicular"):
            world[:, body.joint(f"{side}_{name}")] = raised
        aim_limb(body, world, side, "shoulder", down_to_side[side])
        aim_limb(body, world, side, "elbow", down_to_side[side])
        elbow, wrist = body.joint(f"{side}_elbow"), body.joint(f"{side}_wrist")
        palm = world[0, elbow] @ palm_normal(body, side)
        level = np.array([0.0, 1.0, 1.0])  # only about the arm's own axis
        twist = turns.rotations_between(palm * level, np.array([0.0, -1.0, 0.0]))
        world[:, below(body, wrist)] = twist @ world[0, elbow]
        _straighten_leg(body, world, side)
    return np.asarray(shared_twist(body, turns.local_from_world(world, body.parents))[0])
