"""A motion: one rotation per joint and frame, and weights of face targets."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import freeze, frozen_array


@dataclass(frozen=True, slots=True, eq=False)
class Motion:
    """A motion of the 94 H-Anim joints of one person.

    Attributes
    ----------
    name : str
    times_s : (F,) float64, from 0, rising; frames lie evenly
    root_m : (F, 3) float64
        Where HumanoidRoot is, less where it is at rest; model frame.
    rotations : (F, 94, 3) float64
        Rotation vectors of the joints against their parents in model axes, radians.
    weights : mapping of str to (F,) float64 in 0..1
        Weights of morph targets over time.
    cyclic : bool
        The last frame is the first one again.
    speed_m_s : float
        Speed at which the ground runs backwards below somebody who walks on the spot.
    """

    name: str
    times_s: NDArray[np.float64]
    root_m: NDArray[np.float64]
    rotations: NDArray[np.float64]
    weights: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    cyclic: bool = False
    speed_m_s: float = 0.0

    def __post_init__(self) -> None:
        count = len(self.times_s)
        freeze(
            self,
            times_s=(np.float64, (None,)),
            root_m=(np.float64, (count, 3)),
            rotations=(np.float64, (count, None, 3)),
        )
        frozen = {name: frozen_array(value, name, np.float64, (count,)) for name, value in self.weights.items()}
        object.__setattr__(self, "weights", MappingProxyType(frozen))
