"""Requests and results of the studio's windows: small values that cross process boundaries."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cloner.bodies.children import USUAL_AGE
from cloner.records.arrays import Array
from cloner.records.clones import Clone

Floats = NDArray[np.float32]
Pixels = NDArray[np.uint8]
Rgb = tuple[float, float, float]


def received(clone: Clone) -> Clone:
    """Return a clone that came through a pipe, read-only as before, so that a painter keeps its textures."""
    shells = tuple(replace(shell) for shell in clone.shells)
    return replace(clone, atlas=replace(clone.atlas), shells=shells)


@dataclass(frozen=True, slots=True)
class Outfit:
    """Who wears which garments.

    Attributes
    ----------
    clone : Path
        A result's folder or its clone.npz.
    bare : bool
        Whether the photographed clothes are taken off below; only after the operator was asked.
    garment : str
        One of `cloner.cloth.dressing.GARMENTS`, or a file of one's own.
    length_cm : float or None
        None as it is usually cut.
    fabric : str
    motion : str
        "walk", or a captured walk's file.
    under : Outfit or None
        What is worn below already, by the same clone in the same motion.
    """

    clone: Path
    bare: bool = False
    garment: str = "skirt"
    length_cm: float | None = None
    fabric: str = "cotton"
    motion: str = "walk"
    under: Outfit | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Draped:
    """Cloth on a clone, in one frame or in all frames of a loop.

    Attributes
    ----------
    places_m : (F, N, 3) float32
    faces : (T, 3) int32
    parts : tuple of (int, three shares of sRGB, 0..1)
        How many of the faces belong to each garment, the innermost first, and its colour.
    root_m : (F, 3)
    rotations : (F, 94, 3)
        How the clone stands in each frame.
    """

    places_m: Floats
    faces: NDArray[np.int32]
    parts: tuple[tuple[int, Rgb], ...]
    root_m: Array
    rotations: Array


@dataclass(frozen=True, slots=True, eq=False)
class Arranged:
    """A garment cut and arranged around a clone.

    Attributes
    ----------
    below : Clone
        Who wears it, in the middle of the floor.
    pieces_m : tuple of (M, 2)
        Outlines of the pieces as they are cut.
    draped : Draped
    """

    below: Clone
    pieces_m: tuple[Array, ...]
    draped: Draped


@dataclass(frozen=True, slots=True)
class BodyWish:
    """A body specified by measures.

    Attributes
    ----------
    sex : str
        "f" or "m"; of a clone "" lets its own shape decide.
    stature_cm : float
    cm : mapping of str to float
        What is told, by key of the measures' table.
    source : Path or None
        The clone that is told new measures; None makes a body of nobody's.
    age_years : float
    """

    sex: str
    stature_cm: float
    cm: Mapping[str, float] = field(default_factory=dict)
    source: Path | None = None
    age_years: float = USUAL_AGE


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """Changed measures of a clone.

    Attributes
    ----------
    vertices_m, joints_m : (V, 3) and (94, 3)
    shells_m : tuple of (N, 3)
        Places of its hair and whatever else is loose.
    mm : mapping of str to float
        All measures of the body.
    """

    vertices_m: Array
    joints_m: Array
    shells_m: tuple[Array, ...]
    mm: Mapping[str, float]


@dataclass(frozen=True, slots=True, eq=False)
class Markers:
    """Pixels of a photo that show points of a clone's skin.

    Attributes
    ----------
    at : tuple of int or str
        Vertices, or names of feature points.
    px : (K, 2)
        Photo pixels.
    """

    at: tuple[int | str, ...]
    px: Array


@dataclass(frozen=True, slots=True, eq=False)
class MarkedPhoto:
    """A photo to be fitted to a clone, with initial markers.

    Attributes
    ----------
    rgb : (H, W, 3) uint8
    focal_px : float
    clone : Clone
        What it is laid on.
    markers : Markers
    found : bool
        Whether a face was found in the photo: else the markers lie in its middle.
    """

    rgb: Pixels
    focal_px: float
    clone: Clone
    markers: Markers
    found: bool


@dataclass(frozen=True, slots=True)
class StatueWish:
    """What a statue is made of and how it is saved.

    Attributes
    ----------
    material : str
        "" keeps the colours.
    out : Path
        Receives a folder.
    identifier : str
    formats : tuple of str
    texels : int
        Side of the texture of what is nobody's clone.
    """

    material: str
    out: Path
    identifier: str
    formats: tuple[str, ...]
    texels: int
