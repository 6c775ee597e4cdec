"""A correction as a constraint on a finished person."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId


@dataclass(frozen=True, slots=True, eq=False)
class PointConstraint:
    """A corrected point, of the outline or of the pose: ``target_px`` (2,) in the photo ``view``."""

    view: ViewId
    name: str
    target_px: NDArray[np.float64]
