"""Bodies, skeletons, and the pose in each photo."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.arrays import freeze
from cloner.records.views import Camera


@dataclass(frozen=True, slots=True, eq=False)
class PosedView:
    """One photo's camera and the pose the person has in it.

    Attributes
    ----------
    view : ViewId
    camera : Camera
        Heading, lean of the whole person and place are inside
        ``camera_from_model``; the root joint itself is never rotated.
    rotations : (94, 3) float64
        Rotation vectors (radians, model axes) of the H-Anim joints, rest = 0.
    """

    view: ViewId
    camera: Camera
    rotations: NDArray[np.float64]

    def __post_init__(self) -> None:
        freeze(self, rotations=(np.float64, (94, 3)))


@dataclass(frozen=True, slots=True, eq=False)
class Phenotype:
    """The generic human nearest to the person, and every photo's pose.

    Attributes
    ----------
    coefficients : (C,) float64
        Shape coefficients of the generic human, unit variance.
    stature_m : float
        Barefoot stature.
    sole_m : float
        Height of the shoe soles below the naked soles, metres.
    views : mapping of ViewId to PosedView
        All body photos; the faces get theirs in the head stage.
    attributes : mapping of str to float
        Named phenotype (sex, age_years, weight, ...), by regression.
    ease : (E,) float64
        How far clothes stand off the skin, in the spreads of ``phenotype_clothes``; empty where nobody asked.
    """

    coefficients: NDArray[np.float64]
    stature_m: float
    sole_m: float
    views: Mapping[ViewId, PosedView]
    attributes: Mapping[str, float]
    ease: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        freeze(self, coefficients=(np.float64, (None,)), ease=(np.float64, (None,)))
        object.__setattr__(self, "views", MappingProxyType(dict(self.views)))
        object.__setattr__(self, "attributes", MappingProxyType(dict(self.attributes)))


@dataclass(frozen=True, slots=True, eq=False)
class Skeleton:
    """The 94 H-Anim joint centres in rest pose, (94, 3) metres, model frame."""

    joints_m: NDArray[np.float64]

    def __post_init__(self) -> None:
        freeze(self, joints_m=(np.float64, (94, 3)))


@dataclass(frozen=True, slots=True, eq=False)
class BodyMesh:
    """All vertices of the generic human in rest pose, moved to the person.

    Attributes
    ----------
    vertices_m : (V, 3) float64, model frame, metres
    joints_m : (94, 3) float64, model frame, metres
    """

    vertices_m: NDArray[np.float64]
    joints_m: NDArray[np.float64]

    def __post_init__(self) -> None:
        freeze(self, vertices_m=(np.float64, (None, 3)), joints_m=(np.float64, (94, 3)))


@dataclass(frozen=True, slots=True, eq=False)
class SkeletonSet:
    """The paper's two skeletons and the consensus used for export (rest pose)."""

    front_side: Skeleton
    back_side: Skeleton
    consensus: Skeleton


@dataclass(frozen=True, slots=True, eq=False)
class BodySet:
    """The paper's two bodies and their mean (rest pose)."""

    front_side: BodyMesh
    back_side: BodyMesh
    consensus: BodyMesh


@dataclass(frozen=True, slots=True, eq=False)
class FineBody:
    """The body after its outlines, in rest pose.

    Attributes
    ----------
    mesh : BodyMesh
    views : mapping of ViewId to PosedView
        Every body photo's pose, found again with the mesh; empty without body photos.
    """

    mesh: BodyMesh
    views: Mapping[ViewId, PosedView] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "views", MappingProxyType(dict(self.views)))
