"""The body during cloning: vertex positions alone, small enough to be sent after every stage."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.records.arrays import freeze
from cloner.records.clones import Clone, TextureAtlas


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """The body after a stage.

    Attributes
    ----------
    step : str
        Name of the stage.
    vertices_m : (V, 3) float32
        The generic human's vertices in rest pose, model frame.
    """

    step: str
    vertices_m: NDArray[np.float32]

    def __post_init__(self) -> None:
        freeze(self, vertices_m=(np.float32, (None, 3)))


def shape_after(step: str, values: Mapping[str, Any]) -> Shape | None:
    """Return the body after a stage; None after stages that do not change it."""
    if step == "phenotype":
        found = values["phenotype"]
        vertices = load_generic().shape(found.coefficients, found.stature_m)[0]
    elif step == "rough":
        vertices = values["rough_bodies"].consensus.vertices_m
    elif step == "fine":
        vertices = values["body"].mesh.vertices_m
    elif step == "join":
        vertices = values["joined"].vertices_m
    elif step == "obeyed":
        vertices = values["obeyed"].vertices_m
    else:
        return None
    return Shape(step, np.asarray(vertices, dtype=np.float32))


def plain_clone(vertices_m: NDArray[np.floating[Any]]) -> Clone:
    """Return a body (V, 3) as a clone without face, hair and texture, for display."""
    none = np.zeros(0, dtype=np.int32)
    grey = TextureAtlas(np.full((4, 4, 3), 128, np.uint8), np.zeros((4, 4), np.uint8))
    vertices = np.asarray(vertices_m, dtype=np.float64)
    return Clone(
        vertices_m=vertices,
        joints_m=np.zeros((94, 3)),
        morph_names=(),
        morph_index=none,
        morph_delta_m=np.zeros((0, 3), dtype=np.float32),
        morph_start=np.zeros(1, dtype=np.int32),
        atlas=grey,
        shells=(),
        features_m={},
        views={},
        stature_m=float(np.ptp(vertices[:, 1])),
        sole_m=0.0,
    )
