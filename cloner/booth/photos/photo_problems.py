"""Problems of a photo that can be detected as soon as it is taken."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum

from cloner.frames import ViewId


class PhotoProblem(StrEnum):
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
class PhotoCheck:
    """What a photo shows, whichever view it is assigned to.

    Attributes
    ----------
    digest : str
        Of the photo's file.
    view : ViewId or None
        What it shows, as far as it can be told.
    troubles : tuple of PhotoProblem
        What is wrong with it in every place.
    passes : frozenset of ViewId
        Every view whose photo it can be; `view` is the likeliest.
    """

    digest: str
    view: ViewId | None
    troubles: tuple[PhotoProblem, ...]
    passes: frozenset[ViewId] = field(default=frozenset())

    def troubles_as(self, view: ViewId | None) -> tuple[PhotoProblem, ...]:
        """Return the photo's problems as one view's; None for a photo without a view."""
        if view is None or self.view is None or view in (self.passes | {self.view}):
            return self.troubles
        return (PhotoProblem.OTHER_VIEW, *self.troubles)
