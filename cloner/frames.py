"""Names of the views and the only unit and frame conversions of the project."""

from __future__ import annotations

from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

#: By definition.
MILLIMETRES_PER_METRE = 1000.0
#: Long side of a 35 mm film frame in mm; EXIF 35-mm-equivalents refer to it.
FILM_LONG_SIDE_MM = 36.0


class ViewId(StrEnum):
    """The five photographs."""

    BODY_FRONT = "body_front"
    BODY_SIDE = "body_side"
    BODY_BACK = "body_back"
    FACE_FRONT = "face_front"
    FACE_SIDE = "face_side"

    @property
    def is_body(self) -> bool:
        """Whether the photo shows the whole body."""
        return self.value.startswith("body")

    @property
    def is_face(self) -> bool:
        """Whether the photo shows the face close up."""
        return self.value.startswith("face")

    @property
    def is_front(self) -> bool:
        """Whether the photo is taken from the front."""
        return self.value.endswith("front")

    @property
    def is_side(self) -> bool:
        """Whether the photo is taken from the side."""
        return self.value.endswith("side")


BODY_VIEWS = (ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK)
FACE_VIEWS = (ViewId.FACE_FRONT, ViewId.FACE_SIDE)


def mm_from_m(length_m: float) -> float:
    """Return a length in millimetres."""
    return float(length_m) * MILLIMETRES_PER_METRE


def m_from_mm(length_mm: float) -> float:
    """Return a length in metres."""
    return float(length_mm) / MILLIMETRES_PER_METRE


def m_from_cm(length_cm: float) -> float:
    """Return a length in metres."""
    return float(length_cm) / 100.0


def cm_from_m(length_m: float) -> float:
    """Return centimetres."""
    return length_m * 100.0


def focal_px_from_35mm(focal_35mm: float, width_px: int, height_px: int) -> float:
    """Return the focal length in pixels for a 35 mm equivalent.

    Parameters
    ----------
    focal_35mm : float
        35-mm-equivalent focal length in mm (EXIF ``FocalLengthIn35mmFilm``).
    width_px, height_px : int
        Size of the upright photo; the long side stands for 36 mm.
    """
    return focal_35mm / FILM_LONG_SIDE_MM * max(width_px, height_px)
