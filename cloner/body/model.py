"""The linear model of dressed bodies that photos are fitted with, and the projection of its points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.body.clothes import EASES, clothing_modes
from cloner.body.footwear import BAREFOOT, FOOTWEAR, SHOES, Footwear, with_footwear
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman
from cloner.geometry.articulation.poses import pose_matrix
from cloner.geometry.articulation.posing import PointModel
from cloner.geometry.cameras.stands import STAND_NAMES, project_from_stand
from cloner.records.arrays import Array
from cloner.records.views import Camera

Rows = NDArray[np.integer]

#: Modes of what the family wears, before those of its shape: footwear's, then the clothes'.
WORN = FOOTWEAR + len(EASES)


@dataclass(frozen=True, slots=True, eq=False)
class BodyFamily:
    """Bodies of one stature, in shoes or barefoot: mean, modes and skeleton.

    Attributes
    ----------
    generic : GenericHuman
    stature_m : float
    wear : Footwear
    mean_m : (V, 3)
    modes_m : (V, 3, C)
        The first `WORN` modes are footwear's and clothes', the others the shape's.
    joints_m : (94, 3), joint_modes_m : (94, 3, C)
    pose : (282, D)
    """

    generic: GenericHuman
    stature_m: float
    wear: Footwear
    mean_m: Array
    modes_m: Array
    joints_m: Array
    joint_modes_m: Array
    pose: Array

    def points(self, vertices: Rows, joints: Rows | None = None, *, modes: int | None = None) -> PointModel:
        """Return the linear model of some vertices, then of some joints.

        Parameters
        ----------
        modes : int, optional
            Number of modes that count; all by default.
        """
        used = slice(self.modes_m.shape[2] if modes is None else modes)
        own = np.zeros(0, dtype=int) if joints is None else np.asarray(joints, dtype=int)
        influences = self.generic.skin_joints.shape[1]
        alone = np.zeros((len(own), influences))
        alone[:, :1] = 1.0
        return PointModel(
            np.vstack([self.mean_m[vertices], self.joints_m[own]]),
            np.concatenate([self.modes_m[vertices, :, used], self.joint_modes_m[own, :, used]]),
            self.joints_m,
            self.joint_modes_m[:, :, used],
            np.asarray(self.generic.joint_parents, dtype=np.int64),
            np.vstack([self.generic.skin_joints[vertices], np.repeat(own[:, None], influences, axis=1)]),
            np.vstack([self.generic.skin_weights[vertices].astype(np.float64), alone]),
            self.pose,
        )


def body_family(generic: GenericHuman, stature_m: float, *, barefoot: bool, shapes: int) -> BodyFamily:
    """Return the body family of a stature."""
    wear = BAREFOOT if barefoot else SHOES
    scale = stature_m / GENERIC_STATURE_M
    feet, soles = with_footwear(generic, stature_m, wear)
    cloth, eases = clothing_modes()
    mean, worn = feet + cloth, np.concatenate([soles, eases])
    modes = np.empty((len(mean), 3, WORN + shapes))
    modes[..., :WORN] = np.moveaxis(worn, 0, 2)
    modes[..., WORN:] = scale * np.moveaxis(generic.shape_basis[:shapes], 0, 2)
    joint_modes = np.zeros((len(generic.joints_m), 3, WORN + shapes))
    joint_modes[..., WORN:] = scale * np.moveaxis(generic.joint_basis[:shapes], 0, 2)
    joints = scale * generic.joints_m.astype(np.float64)
    return BodyFamily(generic, stature_m, wear, mean, modes, joints, joint_modes, pose_matrix(generic.joint_names))


@dataclass(frozen=True, slots=True, eq=False)
class ProjectedPoints:
    """Projected points with their derivatives by shape (C), camera (6) and pose (D), in this order.

    Attributes
    ----------
    points_m : (N, 3), by_points : (N, 3, C + 6 + D)
    pixels : (N, 2), by_pixels : (N, 2, C + 6 + D)
    """

    points_m: Array
    by_points: Array
    pixels: Array
    by_pixels: Array


def project_points(model: PointModel, shape: Array, stand: Array, pose: Array, like: Camera) -> ProjectedPoints:
    """Return a model's points projected by a camera, with exact derivatives."""
    moved = model.moved(shape, pose)
    still = np.zeros((len(moved.points_m), 3, len(STAND_NAMES)))
    by_points = np.concatenate([moved.by_shape, still, moved.by_pose], axis=2)
    pixels, by_place, by_stand = project_from_stand(stand, like, moved.points_m)
    by_pixels = by_place @ by_points
    by_pixels[:, :, len(shape) : len(shape) + len(STAND_NAMES)] = by_stand
    return ProjectedPoints(moved.points_m, by_points, pixels, by_pixels)
