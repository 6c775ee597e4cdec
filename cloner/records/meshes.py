"""Meshes for photographs."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array, freeze

Index = NDArray[np.int32]


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """A surface to lay a photo on.

    Attributes
    ----------
    vertices_m : (V, 3) float64, Y up, any place and size
    triangles : (T, 3) int32, outside counter-clockwise
    uv : (U, 2) float64 in 0..1, v downwards
    uv_triangles : (T, 3) int32
    mirror : (V,) int32
        Each vertex's twin on the other side; empty where nobody knows.
    kind : (V,) int32
        Parts whose colours go on in themselves, such as a scalp; empty for one.
    """

    vertices_m: Array
    triangles: Index
    uv: Array
    uv_triangles: Index
    mirror: Index = field(default_factory=lambda: np.zeros(0, np.int32))
    kind: Index = field(default_factory=lambda: np.zeros(0, np.int32))

    def __post_init__(self) -> None:
        freeze(
            self,
            vertices_m=(np.float64, (None, 3)),
            triangles=(np.int32, (None, 3)),
            uv=(np.float64, (None, 2)),
            uv_triangles=(np.int32, (len(self.triangles), 3)),
            mirror=(np.int32, (None,)),
            kind=(np.int32, (None,)),
        )
