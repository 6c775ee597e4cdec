"""Simulated cloth motion of a clone's walk, as a closed loop."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import freeze


@dataclass(frozen=True, slots=True, eq=False)
class Flow:
    """How the cloth shell of a clone moves in a walk.

    Attributes
    ----------
    frames_m : (F, N, 3) float32
        The shell's vertices in every frame of one cycle, model frame, metres; the frame after the last is the first.
    root_m : (F, 3) float32, rotations : (F, J, 3) float32
        The walk that it was made in: the root's place and the joints' turns, axis times radians.
    hidden : (V,) bool
        Vertices of the skin that cloth covers in every frame.
    """

    frames_m: NDArray[np.float32]
    root_m: NDArray[np.float32]
    rotations: NDArray[np.float32]
    hidden: NDArray[np.bool_]

    def __post_init__(self) -> None:
        count = len(self.frames_m)
        freeze(
            self,
            frames_m=(np.float32, (None, None, 3)),
            root_m=(np.float32, (count, 3)),
            rotations=(np.float32, (count, None, 3)),
            hidden=(np.bool_, (None,)),
        )
