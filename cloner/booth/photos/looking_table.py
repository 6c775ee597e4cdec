"""Problems that can be detected as soon as a photo is taken."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum

from cloner.frames import ViewId


class Trouble(StrEnum):
    """What is wrong with a photo."""

    NOBODY = "nobody"
    SEVERAL = "several"
    LYING = "lying"
    NO_VIEW = "no_view"
    OTHER_VIEW = "other_view"
    CUT = "cut"
    SMALL = "small"
    BLURRED = "blurred"
    DARK = "dark"
    BRIGHT = "bright"


@dataclass(frozen=True, slots=True)
class Look:
    """What a photo shows, wherever it is put.

    Attributes
    ----------
    digest : str
        Of the photo's file.
    view : ViewId or None
        What it shows, as far as it can be told.
    troubles : tuple of Trouble
        What is wrong with it in every place.
    passes : frozenset of ViewId
        Every view whose photo it can be; `view` is the likeliest.
    """

    digest: str
    view: ViewId | None
    troubles: tuple[Trouble, ...]
    passes: frozenset[ViewId] = field(default=frozenset())

    def troubles_as(self, view: ViewId | None) -> tuple[Trouble, ...]:
        """Return the photo's problems as one view; None for a photo without a place."""
        if view is None or self.view is None or view in (self.passes | {self.view}):
            return self.troubles
        return (Trouble.OTHER_VIEW, *self.troubles)
