"""Hands at rest: palm normals and curl axes of the knuckles."""

from __future__ import annotations

from typing import Any, Final, Protocol

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array

#: Fingers that curl alike; the thumb has its own way.
FINGERS: Final = ("index", "middle", "ring", "pinky")


class Jointed(Protocol):
    """Anything with H-Anim joints: ``joints_m`` (J, 3) in the rest pose, and each name's index."""

    @property
    def joints_m(self) -> NDArray[np.floating[Any]]:
        """Rest places, metres."""

    def joint(self, name: str) -> int:
        """Return the number of a joint."""


def palm_normal(body: Jointed, side: str) -> Array:
    """Return the normal (3,) of a side's palm, "l" or "r", at rest."""
    wrist, index, little = (body.joints_m[body.joint(f"{side}_{name}")] for name in ("wrist", "index1", "pinky1"))
    normal = np.cross(index - wrist, little - wrist) * (-1.0 if side == "l" else 1.0)
    return np.asarray(normal / np.linalg.norm(normal))


def knuckles(body: Jointed, side: str, finger: str) -> tuple[list[int], Array]:
    """Return a finger's three joints from the hand outwards, and the unit axis (3,) at rest about which they curl."""
    joints = [body.joint(f"{side}_{finger}{number}") for number in (1, 2, 3)]
    axis = np.cross(body.joints_m[joints[2]] - body.joints_m[joints[0]], palm_normal(body, side))
    axis /= np.linalg.norm(axis)
    return joints, np.asarray(axis)
