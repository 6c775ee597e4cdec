"""Clothing ease: how far cloth stands off the skin, as modes that are fitted to outlines.

An outline shows cloth. Without these modes a fit explains wide trousers by legs that
step apart in the side photo (37 mm at the knees of a man in a suit who stood with both
knees level) and by a heavier body; with them the front photo, which sees each leg
alone, tells how wide the trousers are, and so how deep.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.outlines.settling import smoothed_directions
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.arrays import Array
from cloner.records.bodies import Phenotype

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.clothes")


@dataclass(frozen=True, slots=True)
class ClothingEase:
    """Ease of the cloth over some segments.

    Attributes
    ----------
    segments : tuple of str
    mean_m, sigma_m : float
        Usual distance and one standard deviation, metres.
    hangs : bool
        Whether the distance grows from nothing at a segment's top to all of it at its end.
    """

    segments: tuple[str, ...]
    mean_m: float
    sigma_m: float
    hangs: bool = False


#: Shirt or jacket, its sleeves, trousers, and how trouser legs widen towards the hem.
EASES: Final = (
    ClothingEase(("torso", "pelvis"), *_CALIBRATED.pair("trunk_m", "m")),
    ClothingEase(
        ("left_upper_arm", "right_upper_arm", "left_forearm", "right_forearm"), *_CALIBRATED.pair("sleeves_m", "m")
    ),
    ClothingEase(("left_thigh", "right_thigh", "left_calf", "right_calf"), *_CALIBRATED.pair("trousers_m", "m")),
    ClothingEase(("left_calf", "right_calf"), *_CALIBRATED.pair("hems_m", "m"), hangs=True),
)


#: How often directions are averaged with their neighbours', as when skin settles.
WAY_TURNS: Final = 10
SEAM_M: Final = _CALIBRATED.number("seam_m", "m")


@functools.cache
def _ease_directions() -> Array:
    """Return the displacements (E, V, 3) of vertices per metre of each ease."""
    generic = load_generic()
    skin = generic.skin
    normals = vertex_normals(generic.vertices_m.astype(np.float64), body_triangles())
    # cloth spans creases; along their own normals both flanks of one would run through each other
    ways = smoothed_directions(normals, body_triangles(), turns=WAY_TURNS)
    ways[:, 0] *= np.clip(np.abs(generic.vertices_m[:, 0]) / SEAM_M, 0.0, 1.0)
    along = np.clip(generic.slice_s.astype(np.float64), 0.0, 1.0)
    rows = []
    for ease in EASES:
        rows.append((generic.share(*ease.segments) * skin * (along if ease.hangs else 1.0))[:, None] * ways)
    return np.array(rows)


def clothing_modes() -> tuple[Array, Array]:
    """Return mean displacement (V, 3) of clothed skin and modes of its ease (E, V, 3), metres at any stature."""
    directions = _ease_directions()
    mean = np.einsum("e,eva->va", np.array([ease.mean_m for ease in EASES]), directions)
    return mean, directions * np.array([ease.sigma_m for ease in EASES])[:, None, None]


def clothed_body(phenotype: Phenotype) -> tuple[Array, Array]:
    """Return vertices (V, 3) and joints (94, 3) of the phenotype in the clothes that the photos show."""
    vertices, joints = load_generic().shape(phenotype.coefficients, phenotype.stature_m)
    if len(phenotype.ease):
        mean, modes = clothing_modes()
        vertices = vertices + mean + np.einsum("e,eva->va", phenotype.ease, modes)
    return vertices, joints
