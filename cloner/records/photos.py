"""The photographs and the person they show, as read from a folder."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from cloner.frames import BODY_VIEWS, ViewId
from cloner.records.arrays import freeze


@dataclass(frozen=True, slots=True, eq=False, weakref_slot=True)
class Photo:
    """One upright photograph.

    Attributes
    ----------
    view : ViewId
    rgb : (H, W, 3) uint8, sRGB, upright
    focal_35mm : float or None
        35-mm-equivalent focal length from EXIF, mm; None when the file has none.
    digest : str
        sha256 of the file's bytes.
    name : str
        File name without folder, for messages.
    """

    view: ViewId
    rgb: NDArray[np.uint8]
    focal_35mm: float | None
    digest: str
    name: str

    def __post_init__(self) -> None:
        freeze(self, rgb=(np.uint8, (None, None, 3)))

    @property
    def width_px(self) -> int:
        """Width of the upright photo."""
        return int(self.rgb.shape[1])

    @property
    def height_px(self) -> int:
        """Height of the upright photo."""
        return int(self.rgb.shape[0])


@dataclass(frozen=True, slots=True, eq=False)
class PhotoSet:
    """All photographs of one person, by view; missing views are absent."""

    photos: Mapping[ViewId, Photo]

    def __post_init__(self) -> None:
        object.__setattr__(self, "photos", MappingProxyType(dict(self.photos)))

    @property
    def body_views(self) -> tuple[ViewId, ...]:
        """Body views that are present, in canonical order."""
        return tuple(view for view in BODY_VIEWS if view in self.photos)


@dataclass(frozen=True, slots=True)
class Person:
    """What is known of the person besides the photos.

    Attributes
    ----------
    identifier : str
        Name of the result's folder, safe for file systems.
    name : str
    stature_m : float
        Barefoot stature, metres.
    stature_is_known : bool
        False when ``stature_m`` is the stated default.
    notes : str
    tape_mm : tuple of (str, float)
        What an operator measured on the person: keys of the measures' table and mm.
    sex : str, age_years : float
        "f", "m" or "", and years or 0: as whom the clone walks.
    """

    identifier: str
    name: str
    stature_m: float
    stature_is_known: bool = True
    notes: str = field(default="")
    tape_mm: tuple[tuple[str, float], ...] = ()
    sex: str = ""
    age_years: float = 0.0
