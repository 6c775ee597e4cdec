"""What a pixel of a photo shows: the words every label picture is written in."""

from __future__ import annotations

from typing import Final

#: A label is a place in this tuple.
LABELS: Final = (
    "background",
    "skin",
    "face_skin",
    "hair",
    "upper_clothes",
    "lower_clothes",
    "shoes",
    "eyes",
    "mouth",
    "accessories",
    "facial_hair",
)
