"""Carved eyes: a groove around the iris, a drilled pupil, no lashes."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.paint.details.parts import USUAL_IRIS_M, fit_sphere
from cloner.records.arrays import Array
from cloner.records.clones import Clone

Values = NDArray[np.float32]

#: The pupil is so wide against the iris (its edge), and so deep against the ball; taste, after Roman portraits.
PUPIL, DRILLED = 0.5, 0.16
#: The groove round the iris: half width against the iris, depth against the ball.
GROOVE, CARVED = 0.12, 0.02
#: What is left of the light in the pupil and in the groove.
PUPIL_LIGHT, GROOVE_LIGHT = 0.34, 0.62
#: A spark is left standing in the pupil, up and aside: place and radius against the iris.
SPARK, SPARK_RADIUS = (-0.16, 0.28), 0.13
#: Under the upper lid a ball lies in shade, from this height of the ball on; how much of the light is left.
SHADED_FROM, SHADE = 0.15, 0.72
#: Lashes are made so small and put into the ball: stone has none.
SHRUNK: Final = 0.02
SIDES: Final = ("left", "right")


def carved_eyes(generic: GenericHuman, clone: Clone) -> Clone:
    """Return the clone with drilled pupils, without lashes; eyes still turn and lids still close."""
    vertices = clone.vertices_m.copy()
    scale = np.ones(len(vertices))
    for side in SIDES:
        rows = generic.part(f"eye_{side}")
        centre, radius = fit_sphere(vertices[rows])
        scale[rows] = 1.0 - _depth(_from_iris(vertices[rows] - centre, radius))
        lashes = generic.part(f"lashes_{side}")
        scale[lashes] = SHRUNK
        for part in (rows, lashes):
            vertices[part] = centre + scale[part, None] * (vertices[part] - centre)
    # what turns with the ball moves less where it lies deeper
    delta = clone.morph_delta_m * scale[clone.morph_index, None].astype(np.float32)
    return replace(clone, vertices_m=vertices, morph_delta_m=delta)


def eye_light(generic: GenericHuman, vertices_m: Array, side: str, places_m: Array) -> Values:
    """Return (N,) the share of light on places of an eyeball, metres: dark in pupil and groove, shade below the lid.

    Parameters
    ----------
    generic : GenericHuman
    vertices_m : (V, 3)
        Of the person, with round balls.
    side : str
    places_m : (N, 3)
    """
    centre, radius = fit_sphere(vertices_m[generic.part(f"eye_{side}")])
    spokes = places_m - centre
    away = _from_iris(spokes, radius)
    soft = np.clip((away - PUPIL) / 0.08 + 0.5, 0.0, 1.0)
    light = PUPIL_LIGHT + soft * (1.0 - PUPIL_LIGHT)
    iris = USUAL_IRIS_M
    spark = np.hypot(spokes[:, 0] / iris - SPARK[0], spokes[:, 1] / iris - SPARK[1])
    light = np.where(away < 1.5, np.maximum(light, np.clip((SPARK_RADIUS - spark) / 0.05 + 0.5, 0.0, 0.9)), light)
    light *= 1.0 - (1.0 - GROOVE_LIGHT) * np.clip(1.5 - np.abs(away - 1.0) / GROOVE, 0.0, 1.0)
    up = np.clip((spokes[:, 1] / radius - SHADED_FROM) / 0.3, 0.0, 1.0)
    return np.asarray(light * (1.0 - (1.0 - SHADE) * up), np.float32)


def _from_iris(spokes: Array, radius: float) -> Array:
    """Return the distance (N,) of points from the pupil's centre, in iris radii; large behind the eyeball."""
    length = np.maximum(np.linalg.norm(spokes, axis=1), 1e-9)
    angle = np.arccos(np.clip(spokes[:, 2] / length, -1.0, 1.0))
    return np.asarray(angle / np.arcsin(min(USUAL_IRIS_M / radius, 0.9)))


def _depth(away: Array) -> Array:
    """Return the depth (N,) of the carving, shares of the eyeball's radius."""
    pupil = DRILLED * np.clip((PUPIL - away) / (0.3 * PUPIL), 0.0, 1.0)
    return np.asarray(pupil + CARVED * np.clip(1.0 - np.abs(away - 1.0) / GROOVE, 0.0, 1.0))
