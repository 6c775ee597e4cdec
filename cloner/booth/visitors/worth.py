"""Points worth an operator's check before a visitor is cloned, and what they change."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from typing import Final

from cloner.frames import ViewId
from cloner.records.points import ANCHOR, ViewPoints

#: Confidence below which a point is doubtful: it is drawn red then (taste).
DOUBTFUL_BELOW: Final = 0.25
#: So many are told; who looks at those sees the rest.
MOST: Final = 3


class Change(StrEnum):
    """What a point changes of the clone."""

    HEIGHT = "height"
    FACE = "face"
    POSE = "pose"
    BREADTH = "breadth"


def doubtful(points: Mapping[ViewId, ViewPoints]) -> dict[ViewId, tuple[str, ...]]:
    """Return the points that nobody placed and that are not sure, by photo; photos without any are left out."""
    found = {
        view: tuple(
            name
            for name, sure, placed in zip(one.names, one.confidence, one.corrected, strict=True)
            if sure < DOUBTFUL_BELOW and not placed and not name.startswith(ANCHOR)
        )
        for view, one in points.items()
    }
    return {view: names for view, names in found.items() if names}


def change_of(view: ViewId, name: str) -> Change:
    """Return what a point of a photo influences."""
    if name.startswith(("sole", "head_top", "heel", "toe")):
        return Change.HEIGHT
    if view.is_face or name.startswith(("eye", "nose", "mouth", "lip", "chin", "ear", "brow", "pupil", "ala")):
        return Change.FACE
    return Change.POSE if name.startswith(("l_", "r_")) else Change.BREADTH
