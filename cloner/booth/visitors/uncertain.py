"""Points worth an operator's check before a visitor is cloned, and what they affect."""

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


class Effect(StrEnum):
    """What a point affects in the clone."""

    HEIGHT = "height"
    FACE = "face"
    POSE = "pose"
    BREADTH = "breadth"


def uncertain_points(points: Mapping[ViewId, ViewPoints]) -> dict[ViewId, tuple[str, ...]]:
    """Return the uncertain points that nobody placed, by photo; photos without any are left out."""
    found = {
        view: tuple(
            name
            for name, sure, placed in zip(one.names, one.confidence, one.corrected, strict=True)
            if sure < DOUBTFUL_BELOW and not placed and not name.startswith(ANCHOR)
        )
        for view, one in points.items()
    }
    return {view: names for view, names in found.items() if names}


def effect_of_point(view: ViewId, name: str) -> Effect:
    """Return what a point of a photo affects."""
    if name.startswith(("sole", "head_top", "heel", "toe")):
        return Effect.HEIGHT
    if view.is_face or name.startswith(("eye", "nose", "mouth", "lip", "chin", "ear", "brow", "pupil", "ala")):
        return Effect.FACE
    return Effect.POSE if name.startswith(("l_", "r_")) else Effect.BREADTH
