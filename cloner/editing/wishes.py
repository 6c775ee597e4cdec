"""What a correction asks of a finished person."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId


@dataclass(frozen=True, slots=True, eq=False)
class Wish:
    """One corrected point, of the outline or of what the pose carries: ``target_px`` (2,) is of the photo ``view``."""

    view: ViewId
    name: str
    target_px: NDArray[np.float64]
