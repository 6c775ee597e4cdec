"""Eyeballs of anatomical size: a sphere with a cornea, and coordinates of the lids on it.

Lids turn about the axis through the ball's centre from side to side; a point of a lid is told by how far aside it lies,
its elevation about that axis, and its distance from the centre.

References
----------
Bekerman, Gottlieb and Vaiman 2014, "Variations in eyeball diameters of the healthy adults": 24.2 mm across, 23.7 mm
high, 22.0-24.8 mm long, hardly different between people.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from cloner.geometry.meshes.vectors import unit
from cloner.records.arrays import Array

#: Radius of the eyeball, metres, and how far the cornea's middle stands out of it, share of the radius.
BALL_M, CORNEA = 0.012, 0.03
#: Radius of the human iris, metres; varies by under 5 % among adults (Gharaee et al. 2014: 11.8 mm diameter).
IRIS_M = 0.0059
#: Angle of the iris' rim from the gaze, radians.
IRIS_ANGLE = float(np.arcsin(IRIS_M / BALL_M))


@dataclass(frozen=True, slots=True, eq=False)
class Eyeball:
    """An eyeball of anatomical size that looks along +Z.

    Attributes
    ----------
    centre : (3,) metres, what it turns about
    """

    centre: Array

    def unrolled(self, points: Array) -> tuple[Array, Array, Array]:
        """Return the sideways position (...,) of points, their elevation, radians, and their distance
        from the centre.
        """
        spokes = points - self.centre
        return spokes[..., 0], np.arctan2(spokes[..., 1], spokes[..., 2]), np.linalg.norm(spokes, axis=-1)

    def rolled(self, aside: Array, elevation: Array, distance: Array) -> Array:
        """Return the points (..., 3) of `unrolled` coordinates; positions beyond the radius are clamped."""
        reach = np.sqrt(np.maximum(distance**2 - aside**2, 1e-10))
        return np.asarray(
            self.centre + np.stack([aside, reach * np.sin(elevation), reach * np.cos(elevation)], axis=-1)
        )

    def outside(self, points: Array, gaze: Array | None = None) -> Array:
        """Return the distance (...,) of points from the surface, metres, negative inside; ``gaze`` (3,) unit or +Z."""
        spokes = points - self.centre
        distance = np.linalg.norm(spokes, axis=-1)
        ahead = spokes @ (np.array([0.0, 0.0, 1.0]) if gaze is None else gaze)
        angle = np.arccos(np.clip(ahead / np.maximum(distance, 1e-12), -1.0, 1.0))
        return np.asarray(distance - BALL_M * (1.0 + cornea(angle)))


def cornea(angle: Array) -> Array:
    """Return the height of the surface over the sphere, share of the radius, at angles (...,) from the gaze."""
    return np.asarray(CORNEA * np.cos(np.clip(angle / IRIS_ANGLE, 0.0, 1.0) * np.pi / 2) ** 2)


def eyeball_points(spokes: Array, rim_angle: float) -> Array:
    """Return the vertices (N, 3) of an eyeball around the origin, with a ring at the iris's rim.

    Parameters
    ----------
    spokes : (N, 3)
        Vertices of any ball around its centre, gazing along +Z.
    rim_angle : float
        Angle at which that ball has the iris' rim, radians.
    """
    gaze = spokes / np.linalg.norm(spokes, axis=1, keepdims=True)
    angle = np.arccos(np.clip(gaze[:, 2], -1.0, 1.0))
    wanted = np.interp(angle, [0.0, rim_angle, np.pi], [0.0, IRIS_ANGLE, np.pi])
    across = unit(gaze[:, :2], 1e-12)
    around = np.column_stack([np.sin(wanted)[:, None] * across, np.cos(wanted)])
    return np.asarray(BALL_M * (1.0 + cornea(wanted))[:, None] * around)
