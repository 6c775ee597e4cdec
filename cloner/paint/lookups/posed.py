"""The person's mesh in a photo's pose."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.cameras.visibility import Visibility, compute_visibility, depth_picture
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.heads import Shell


def parents_of(generic: GenericHuman) -> NDArray[np.int32]:
    """Return (94,) each joint's parent, -1 above the root."""
    return np.asarray(generic.joint_parents, np.int32)


def posed_vertices(generic: GenericHuman, joined: Joined, view: PosedView) -> Array:
    """Return the vertices (V, 3) of the person in one photo's pose, metres."""
    transforms = joint_transforms(joined.joints_m, parents_of(generic), view.rotations)
    joints, weights = np.asarray(generic.skin_joints, np.int32), np.asarray(generic.skin_weights, np.float64)
    return linear_blend_skinning(joined.vertices_m, transforms, joints, weights)


def posed_shell(generic: GenericHuman, joined: Joined, view: PosedView, shell: Shell) -> Array:
    """Return the vertices (N, 3) of a shell in one photo's pose, metres."""
    transforms = joint_transforms(joined.joints_m, parents_of(generic), view.rotations)
    return linear_blend_skinning(shell.vertices_m, transforms, shell.skin_joints, shell.skin_weights)


@dataclass(frozen=True, slots=True, eq=False)
class PosedPerson:
    """A person in front of one photo's camera.

    Attributes
    ----------
    posed_m : (V, 3) float64
    visibility : Visibility
    hair_m : (h, w) float32
        Depth of the nearest shell, inf where there is none.
    """

    posed_m: Array
    visibility: Visibility
    hair_m: NDArray[np.float32]

    @property
    def shown(self) -> NDArray[np.bool_]:
        """Return the pixels (h, w) that body or shells cover, at ``DEPTH_SCALE``."""
        return np.asarray(np.isfinite(self.visibility.nearest_m) | np.isfinite(self.hair_m), bool)


def pose_person(generic: GenericHuman, joined: Joined, shells: tuple[Shell, ...], view: PosedView) -> PosedPerson:
    """Return the person with body and shells in front of one photo's camera."""
    posed = posed_vertices(generic, joined, view)
    visibility = compute_visibility(posed, body_triangles(), view.camera)
    hair_m = np.full_like(visibility.nearest_m, np.inf)
    for shell in shells:
        shape = posed_shell(generic, joined, view, shell)
        hair_m = np.minimum(hair_m, depth_picture(shape, shell.triangles, view.camera))
    return PosedPerson(posed, visibility, hair_m)
