"""From where a VRML world is looked at: one viewpoint a named side of the person, the front first."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from cloner.exporters.vrml.vrml_segments import row_text
from cloner.geometry.cameras.viewpoints import AZIMUTH_DEG
from cloner.records.clones import Clone

FIELD_OF_VIEW: Final = 0.6  # radians; taste


def viewpoints(clone: Clone) -> Iterator[str]:
    """Yield one Viewpoint a named side, the front first."""
    low, high = clone.vertices_m.min(axis=0), clone.vertices_m.max(axis=0)
    middle = (low + high) / 2.0
    distance = 0.6 * float((high - low).max()) / np.tan(FIELD_OF_VIEW / 2.0)
    for side in ("front", "three_quarter", "left", "right", "back"):
        angle = np.radians(AZIMUTH_DEG[side])
        place = middle + distance * np.array([np.sin(angle), 0.0, np.cos(angle)])
        yield (
            f'Viewpoint {{ description "{side.replace("_", " ")}" position {row_text(place)} '
            f"orientation 0 1 0 {angle:.5f} fieldOfView {FIELD_OF_VIEW} }}\n"
        )
