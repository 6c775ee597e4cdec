"""What can be told of a photo as soon as it is taken."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from cloner.frames import ViewId


class Trouble(StrEnum):
    """What is wrong with a photo."""

    NOBODY = "nobody"
    SEVERAL = "several"
    NO_VIEW = "no_view"
    OTHER_VIEW = "other_view"
    CUT = "cut"
    SMALL = "small"
    BLURRED = "blurred"
    DARK = "dark"
    BRIGHT = "bright"


@dataclass(frozen=True, slots=True)
class Look:
    """What a photo shows.

    Attributes
    ----------
    digest : str
        Of the photo's file.
    view : ViewId or None
        What it shows, as far as it can be told.
    troubles : tuple of Trouble
    """

    digest: str
    view: ViewId | None
    troubles: tuple[Trouble, ...]
