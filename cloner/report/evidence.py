"""Contradictions between photos and the finished clone, and photos to leave out.

The steps before look at points and outlines near by: a head laid on a profile at half its size has small residuals.
Only the whole silhouette tells.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

from cloner.frames import ViewId
from cloner.report.agreement import PhotoAgreement

#: Photos that a clone can do without, and those of which one must stay.
SPARE: Final = (ViewId.FACE_SIDE, ViewId.BODY_SIDE, ViewId.BODY_BACK)
#: A clone that covers less of a body, or of a head above its chin, than this, or whose area has so much another size,
#: does not stand in that photo (35 generated people and the samples: bodies 0.91 to 0.99, heads 0.80 to 0.98 with sizes
#: 0.93 to 1.05, an afro and a torn hood 0.75; heads laid on a hood 0.39, on hair 0.52, on lips for a nose 0.69).
LEAST: Final = 0.75
LARGEST_SIZE: Final = 1.25
#: A clone made without a photo is kept unless it covers another photo so much worse.
WORSE: Final = 0.03

UNLIKE: Final = (
    "the clone would cover only %1 percent of the person in this photo, so it was left out; "
    "check that it shows the same person in the same clothes, straight from the side or from behind"
)


def contradicting_photos(seen: Mapping[ViewId, PhotoAgreement]) -> dict[ViewId, str]:
    """Return the photos that the clone contradicts and that it can do without, each with a message.

    Parameters
    ----------
    seen : mapping
        How well the finished clone covers the person, of every photo that tells.
    """
    if not any(view.is_front and not _is_unlike(found) for view, found in seen.items()):
        return {}  # nothing firm to hold the others against
    return {
        view: UNLIKE.replace("%1", f"{100.0 * seen[view].iou:.0f}")
        for view in SPARE
        if view in seen and _is_unlike(seen[view])
    }


def is_better(before: Mapping[ViewId, PhotoAgreement], after: Mapping[ViewId, PhotoAgreement]) -> bool:
    """Return whether a clone made without some photos covers the others at least as well."""
    return all(view in after and after[view].iou > found.iou - WORSE for view, found in before.items() if view.is_front)


def _is_unlike(found: PhotoAgreement) -> bool:
    return found.iou < LEAST or abs(math.log(max(found.size, 1e-3))) > math.log(LARGEST_SIZE)
