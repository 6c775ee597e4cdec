"""Another rest pose for a clone: the T-pose that avatar programs ask for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.geometry.skinning import blend_transforms, joint_transforms, skin
from cloner.motion import turns
from cloner.motion.body import FOOT, SIDES, Body, below, body_of
from cloner.motion.gait import aim_limb, palm_normal
from cloner.motion.twist import shared_twist
from cloner.records.clones import Clone
from cloner.records.heads import Shell

Array = NDArray[np.float64]


def in_t_pose(clone: Clone) -> Clone:
    """Return the clone whose rest pose is the T-pose: arms level to the sides, palms down, legs straight down.

    Skin, shells, joints and morph targets are bound anew in that pose; the photos' poses are left out, they belong to
    the old rest pose. Feet stay on the floor.
    """
    body = body_of(clone)
    rotations = t_pose(body)
    transforms = joint_transforms(clone.joints_m, body.parents, rotations)
    generic = load_generic()
    joints, weights = generic.skin_joints.astype(np.int32), generic.skin_weights.astype(np.float64)
    vertices = skin(clone.vertices_m, transforms, joints, weights)
    drop = np.array([0.0, -vertices[:, 1].min() + clone.vertices_m[:, 1].min(), 0.0])
    turned = blend_transforms(transforms, joints, weights)[:, :, :3]
    moved = np.einsum("mab,mb->ma", turned[clone.morph_index], clone.morph_delta_m)
    return replace(
        clone,
        vertices_m=vertices + drop,
        joints_m=np.einsum("jab,jb->ja", transforms[:, :3, :3], clone.joints_m) + transforms[:, :3, 3] + drop,
        morph_delta_m=moved.astype(np.float32),
        shells=tuple(_reposed(shell, transforms, drop) for shell in clone.shells),
        features_m={},
        views={},
    )


def _reposed(shell: Shell, transforms: Array, drop: Array) -> Shell:
    return replace(shell, vertices_m=skin(shell.vertices_m, transforms, shell.skin_joints, shell.skin_weights) + drop)


def t_pose(body: Body) -> Array:
    """Return (94, 3) rotation vectors of the T-pose, radians."""
    world = np.tile(np.eye(3), (1, len(body.names), 1, 1))
    down_to_side = {"l": turns.about(2, np.array([np.pi / 2])), "r": turns.about(2, np.array([-np.pi / 2]))}
    still = np.eye(3)[None]
    for side in SIDES:
        aim_limb(body, world, side, "shoulder", down_to_side[side])
        aim_limb(body, world, side, "elbow", down_to_side[side])
        elbow, wrist = body.joint(f"{side}_elbow"), body.joint(f"{side}_wrist")
        palm = world[0, elbow] @ palm_normal(body, side)
        level = np.array([0.0, 1.0, 1.0])  # only about the arm's own axis
        twist = turns.between(palm * level, np.array([0.0, -1.0, 0.0]))
        world[:, below(body, wrist)] = twist @ world[0, elbow]
        for name in ("hip", "knee"):
            aim_limb(body, world, side, name, still)
        for name in (*FOOT, "metatarsal"):
            world[:, body.joint(f"{side}_{name}")] = still
    return np.asarray(shared_twist(body, turns.local_from_world(world, body.parents))[0])
