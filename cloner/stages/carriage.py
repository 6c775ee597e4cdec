"""How the head is carried in each body photo, found anew with the person's own head.

The phenotype's head is nobody's; once the fitted head sits on the body, neck and
skull base turn a little until the head lies where each photo shows it (method §5,
"one rest-pose body and one pose per photo").
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.skinning import joint_transforms, skin
from cloner.records.bodies import BodyMesh, PosedView
from cloner.records.points import ViewPoints
from cloner.stages.outlined import Outlined, see

Array = NDArray[np.float64]

#: Joints that carry the head, in two groups that may counter each other.
NECK, SKULL = ("vc7", "vc5", "vc3"), ("skullbase",)
#: Features of the head that body photos show.
HEAD_POINTS = ("nose_tip", "ear_outer_L", "ear_outer_R", "pupil_L", "pupil_R")


@dataclass(frozen=True, slots=True)
class Params:
    """Trust in the evidence.

    Attributes
    ----------
    point_mm, outline_mm : float
        Spread of the net's points on the head and of the head's outline.
    degrees : float
        Usual turn away from the phenotype's carriage, per angle.
    turns : int
        Gauss-Newton steps.
    """

    point_mm: float = 12.0
    outline_mm: float = 3.0
    degrees: float = 6.0
    turns: int = 5


def _spread(generic: GenericHuman) -> Array:
    """Return the (282, 6) matrix from neck and skull angles to stacked rotation vectors."""
    matrix = np.zeros((len(generic.joint_names) * 3, 6))
    for group, joints in enumerate((NECK, SKULL)):
        for name in joints:
            for axis in range(3):
                matrix[generic.joint(name) * 3 + axis, group * 3 + axis] = 1.0 / len(joints)
    return matrix


def _residual(
    generic: GenericHuman, mesh: BodyMesh, photo: Outlined, points: ViewPoints, params: Params
) -> Callable[[Array], Array]:
    """Return the residual of the six angles: outline, points and prior, in spreads."""
    seen = see(mesh, photo)
    head = (generic.head_blend > 0.9) & (generic.vertex_part == generic.part_names.index("body"))
    rim = np.flatnonzero(seen.body.on_rim & head)
    veiled = photo.field.is_veiled(seen.body.pixels[rim])
    rows = [k for k, name in enumerate(points.names) if name in HEAD_POINTS]
    marks = np.array([generic.feature(points.names[k]) for k in rows], dtype=int)
    chosen = np.concatenate([rim, marks])
    trust = points.confidence[rows, None] * seen.mm_per_px / params.point_mm
    spread, camera = _spread(generic), photo.posed.camera
    joints, weights = generic.skin_joints[chosen], generic.skin_weights[chosen].astype(np.float64)
    soft = seen.mm_per_px / params.outline_mm

    def residual(angles: Array) -> Array:
        rotations = photo.posed.rotations + (spread @ angles).reshape(-1, 3)
        transforms = joint_transforms(mesh.joints_m, generic.joint_parents, rotations)
        pixels = camera.project(skin(mesh.vertices_m[chosen], transforms, joints, weights))
        gap = photo.field.signed_distance(pixels[: len(rim)]) * soft
        gap = 4.0 * np.tanh(np.where(veiled, np.maximum(gap, 0.0), gap) / 4.0)
        gap /= np.sqrt(max(len(rim) / 30.0, 1.0))
        away = (pixels[len(rim) :] - points.points_px[rows]) * trust
        return np.concatenate([gap, away.ravel(), angles / np.deg2rad(params.degrees)])

    return residual


def carry_head(mesh: BodyMesh, photo: Outlined, points: ViewPoints) -> PosedView:
    """Return the photo's pose with neck and skull base turned to the photo.

    Parameters
    ----------
    mesh : BodyMesh
        The joined person in rest pose, in the frame of ``photo``'s camera.
    photo : Outlined
        Pose, camera and outline of a body photo.
    points : ViewPoints
        Named points of that photo.
    """
    params, generic = Params(), load_generic()
    posed = photo.posed
    for _ in range(params.turns):
        residual = _residual(generic, mesh, Outlined(posed, photo.field), points, params)
        value = residual(np.zeros(6))
        jacobian = np.stack([(residual(step) - value) / 1e-3 for step in 1e-3 * np.eye(6)], axis=1)
        angles = np.clip(np.linalg.solve(jacobian.T @ jacobian, -jacobian.T @ value), -0.15, 0.15)
        rotations = posed.rotations + (_spread(generic) @ angles).reshape(-1, 3)
        posed = PosedView(posed.view, posed.camera, rotations)
    return posed


def carried(
    mesh: BodyMesh, photos: dict[ViewId, Outlined], points: dict[ViewId, ViewPoints]
) -> dict[ViewId, PosedView]:
    """Return the poses of all body photos with the head carried as each photo shows it."""
    return {view: carry_head(mesh, photo, points[view]) for view, photo in photos.items()}
