"""The finished person."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.arrays import freeze
from cloner.records.bodies import PosedView
from cloner.records.heads import Shell
from cloner.records.terms import Terms

#: The shine of a person's atlas: their regions say it.
NO_SHINE = np.zeros((0, 0, 3), np.uint8)


def _freeze_person(person: Joined | Clone) -> None:
    """Check and freeze the arrays and mappings that a joined and a finished person share."""
    freeze(
        person,
        vertices_m=(np.float64, (None, 3)),
        joints_m=(np.float64, (94, 3)),
        morph_index=(np.int32, (None,)),
        morph_delta_m=(np.float32, (None, 3)),
        morph_start=(np.int32, (len(person.morph_names) + 1,)),
    )
    object.__setattr__(person, "views", MappingProxyType(dict(person.views)))
    object.__setattr__(person, "features_m", MappingProxyType(dict(person.features_m)))


@dataclass(frozen=True, slots=True, eq=False)
class TextureAtlas:
    """The person's skin and clothes in the generic human's UV atlas.

    Attributes
    ----------
    rgb : (S, S, 3) uint8, sRGB
    coverage : (S, S) uint8
        255 where a photo saw the texel well, 0 where the colour was filled in.
    shine : (M, M, 3) uint8
        How the surface takes light as glTF has it, on the same charts: green is roughness, blue how much is metal.
        Empty where the regions say it: people.
    """

    rgb: NDArray[np.uint8]
    coverage: NDArray[np.uint8]
    shine: NDArray[np.uint8] = field(default_factory=lambda: NO_SHINE)

    def __post_init__(self) -> None:
        freeze(
            self, rgb=(np.uint8, (None, None, 3)), coverage=(np.uint8, (None, None)), shine=(np.uint8, (None, None, 3))
        )


@dataclass(frozen=True, slots=True, eq=False)
class Joined:
    """Head and body as one person in rest pose, before texture and hair.

    Attributes
    ----------
    vertices_m : (V, 3) float64
        Model frame: metres, Y up, facing +Z, floor (shoe soles) at y = 0.
    joints_m : (94, 3) float64, same frame
    views : mapping of ViewId to PosedView
        Every photo's camera and pose. Face photos see only the head: their
        rotations are zero and their camera stands relative to the rest head.
    morph_names, morph_index, morph_delta_m, morph_start
        Sparse morph targets scaled to this face, laid out as in :class:`Clone`.
    features_m : mapping of str to (3,) float64
    stature_m, sole_m : float
    """

    vertices_m: NDArray[np.float64]
    joints_m: NDArray[np.float64]
    views: Mapping[ViewId, PosedView]
    morph_names: tuple[str, ...]
    morph_index: NDArray[np.int32]
    morph_delta_m: NDArray[np.float32]
    morph_start: NDArray[np.int32]
    features_m: Mapping[str, NDArray[np.float64]]
    stature_m: float
    sole_m: float

    def __post_init__(self) -> None:
        _freeze_person(self)


@dataclass(frozen=True, slots=True, eq=False, weakref_slot=True)  # what is made of it is remembered with it
class Clone:
    """One animatable textured person in rest pose, soles on y = 0.

    Topology, weights, UVs and morph targets' indices are the generic human's
    (``cloner.generic``); only what differs from it is kept here.

    Attributes
    ----------
    vertices_m : (V, 3) float64
        Model frame: metres, Y up, facing +Z, floor (shoe soles) at y = 0.
    joints_m : (94, 3) float64, same frame
    morph_names : tuple of str
    morph_index : (M,) int32, morph_delta_m : (M, 3) float32, morph_start : (len(names)+1,) int32
        Sparse morph targets: rows ``morph_start[k]:morph_start[k+1]`` belong to target k.
    atlas : TextureAtlas
    shells : tuple of Shell
        Hair and other loose volumes, same frame as ``vertices_m``.
    features_m : mapping of str to (3,) float64
        Named feature points of the finished surface.
    views : mapping of ViewId to PosedView
        How to see the clone as each photo saw the person.
    stature_m : float
        Barefoot stature; the skull's top is at ``stature_m + sole_m``.
    sole_m : float
    triangle_regions : (T,) uint8
        Place in ``cloner.records.regions.REGIONS`` of every triangle of the generic human; empty where nobody said.
    stamp : str
        Version, models and options it was made with; every exporter writes it. Letters, digits and " .,=:-" only.
    measures_mm : mapping of str to float
        Measures of the body under its clothes by their names in ISO 8559-1; empty where nobody measured.
    consent : bool
        Whether the person's consent was recorded with the photos.
    terms : Terms
        Whom the files name, and what others may do with them; empty without consent.
    sex : str, age_years : float
        "f" or "m", and years, where somebody told them: the walk is that of such a person. "" and 0 otherwise.
    """

    vertices_m: NDArray[np.float64]
    joints_m: NDArray[np.float64]
    morph_names: tuple[str, ...]
    morph_index: NDArray[np.int32]
    morph_delta_m: NDArray[np.float32]
    morph_start: NDArray[np.int32]
    atlas: TextureAtlas
    shells: tuple[Shell, ...]
    features_m: Mapping[str, NDArray[np.float64]]
    views: Mapping[ViewId, PosedView]
    stature_m: float
    sole_m: float
    triangle_regions: NDArray[np.uint8] = field(default_factory=lambda: np.zeros(0, np.uint8))
    stamp: str = ""
    measures_mm: Mapping[str, float] = field(default_factory=dict)
    consent: bool = False
    terms: Terms = field(default_factory=Terms)
    sex: str = ""
    age_years: float = 0.0

    def __post_init__(self) -> None:
        _freeze_person(self)
        freeze(self, triangle_regions=(np.uint8, (None,)))
        object.__setattr__(self, "measures_mm", MappingProxyType(dict(self.measures_mm)))
