"""The fitted head, and shells."""

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
class HeadFit:
    """Shape of the head, in rest pose, and the cameras of the face photos.

    Attributes
    ----------
    vertices_m : (H, 3) float64
        ``generic.head_vertices`` in the rest frame of the *generic* head of the
        same phenotype and stature; the join places them on the body.
    cameras : mapping of ViewId to Camera
        Face photos (and body_front's face) relative to that rest head.
    iris_rgb : (3,) float64 in 0..255
    iris_radius_m : float
    side_shown : str
        "left", "right" or "" when there is no side photo.
    jaws_rad : mapping of ViewId to float
        How far each face photo shows the jaw open; the head itself rests with it shut.
    """

    vertices_m: NDArray[np.float64]
    cameras: Mapping[ViewId, Camera]
    iris_rgb: NDArray[np.float64]
    iris_radius_m: float
    side_shown: str
    jaws_rad: Mapping[ViewId, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        freeze(
            self,
            vertices_m=(np.float64, (None, 3)),
            iris_rgb=(np.float64, (3,)),
        )
        for name in ("cameras", "jaws_rad"):
            object.__setattr__(self, name, MappingProxyType(dict(getattr(self, name))))


#: What a shell can be.
SHELL_KINDS = ("hair", "cloth", "glasses", "beard", "frizz", "scarf")
#: What a shell rides on that no morph target moves.
NO_RIDES = np.zeros(0, np.int32)


@dataclass(frozen=True, slots=True, eq=False)
class Shell:
    """A surface of its own beside the body: hair, its frizz, a beard, a scarf, a skirt, a coat's lower part, glasses.

    Attributes
    ----------
    vertices_m : (N, 3) float64, rest pose, model frame of the joined person
    triangles : (T, 3) int32
    uv : (N, 2) float64 in 0..1, v downwards
    skin_joints : (N, 4) int32
    skin_weights : (N, 4) float64, rows sum to one
    rgba : (S, S, 4) uint8 texture
    kind : str
        One of ``SHELL_KINDS``.
    rides : (N,) int32, or empty
        Vertex of the skin with which each moves in morph targets; empty where none moves the shell.
    """

    vertices_m: NDArray[np.float64]
    triangles: NDArray[np.int32]
    uv: NDArray[np.float64]
    skin_joints: NDArray[np.int32]
    skin_weights: NDArray[np.float64]
    rgba: NDArray[np.uint8]
    kind: str = "hair"
    rides: NDArray[np.int32] = field(default_factory=lambda: NO_RIDES)

    def __post_init__(self) -> None:
        freeze(
            self,
            vertices_m=(np.float64, (None, 3)),
            triangles=(np.int32, (None, 3)),
            uv=(np.float64, (None, 2)),
            skin_joints=(np.int32, (None, 4)),
            skin_weights=(np.float64, (None, 4)),
            rgba=(np.uint8, (None, None, 4)),
            rides=(np.int32, (len(self.vertices_m) if len(self.rides) else 0,)),
        )
