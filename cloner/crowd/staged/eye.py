"""A camera of the crowd."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.records.arrays import Array

#: Nearest and farthest that is drawn, metres (taste).
NEAR_M: Final = 0.1
FAR_M: Final = 1200.0


@dataclass(frozen=True, slots=True, eq=False)
class CrowdCamera:
    """A camera of the crowd.

    Attributes
    ----------
    place_m : (3,), target_m : (3,)
    size_px : (width, height)
    focal_px : float
    """

    place_m: Array
    target_m: Array
    size_px: tuple[int, int]
    focal_px: float

    def axes(self) -> Array:
        """Return (3, 3) the unit vectors to the right, up and back."""
        back = np.asarray(self.place_m, float) - self.target_m
        back /= np.linalg.norm(back)
        right = np.cross([0.0, 1.0, 0.0], back)
        right /= np.linalg.norm(right)
        return np.vstack([right, np.cross(back, right), back])

    def clip_from_world(self, near_m: float = NEAR_M, far_m: float = FAR_M) -> Array:
        """Return the (4, 4) matrix to clip space, Y up."""
        rows = self.axes()
        view = np.eye(4)
        view[:3, :3], view[:3, 3] = rows, -rows @ self.place_m
        width, height = self.size_px
        lens = np.array(
            [
                [2 * self.focal_px / width, 0, 0, 0],
                [0, 2 * self.focal_px / height, 0, 0],
                [0, 0, -(far_m + near_m) / (far_m - near_m), -2 * far_m * near_m / (far_m - near_m)],
                [0, 0, -1, 0],
            ]
        )
        return np.asarray(lens @ view)
