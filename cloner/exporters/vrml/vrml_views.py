"""Viewpoints of a VRML or X3D world: one per named side of the person, the front first."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.exporters.vrml.vrml_segments import row_text
from cloner.geometry.cameras.viewpoints import AZIMUTH_DEG
from cloner.records.clones import Clone

FIELD_OF_VIEW: Final = 0.6  # radians; taste


@dataclass(frozen=True, slots=True, eq=False)
class PlacedView:
    """A viewpoint: its side, its place (3,) and what it looks at (3,), metres, and its turn about +Y, radians."""

    side: str
    place_m: NDArray[np.float64]
    middle_m: NDArray[np.float64]
    angle_rad: float


def placed_views(clone: Clone) -> Iterator[PlacedView]:
    """Yield one viewpoint a named side, the front first."""
    low, high = clone.vertices_m.min(axis=0), clone.vertices_m.max(axis=0)
    middle = (low + high) / 2.0
    distance = 0.6 * float((high - low).max()) / np.tan(FIELD_OF_VIEW / 2.0)
    for side in ("front", "three_quarter", "left", "right", "back"):
        angle = float(np.radians(AZIMUTH_DEG[side]))
        place = middle + distance * np.array([np.sin(angle), 0.0, np.cos(angle)])
        yield PlacedView(side.replace("_", " "), place, middle, angle)


def viewpoints(clone: Clone) -> Iterator[str]:
    """Yield the viewpoints as VRML97."""
    for view in placed_views(clone):
        yield (
            f'Viewpoint {{ description "{view.side}" position {row_text(view.place_m)} '
            f"orientation 0 1 0 {view.angle_rad:.5f} fieldOfView {FIELD_OF_VIEW} }}\n"
        )
