"""Photos prepared for painting: the person without background and other people's colours."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.seen_points import combined_pose
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposal, Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.vision.retouching.bare_skin import label_colour
from cloner.vision.retouching.matting import MattedPhoto, prepare_matted_photo
from cloner.vision.retouching.skin_colour import SkinColour

_FACED = (ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.FACE_FRONT, ViewId.FACE_SIDE)


@dataclass(frozen=True, slots=True)
class Limits:
    """Conditions under which a photo may paint a surface.

    Attributes
    ----------
    steepest_cosine : float
        Surfaces turned farther away take no colour (0.14 = 82 degrees).
    shift_share : float
        Largest outline shift, share of the figure's height.
    face_presence : float
        Trust in the face net from which its eye contours are believed.
    """

    steepest_cosine: float = 0.14
    shift_share: float = 0.02
    face_presence: float = 0.5


def person_mask(view: ViewId, proposal: Proposal, silhouettes: SilhouetteSet) -> NDArray[np.bool_]:
    """Return the person (H, W): the extracted outline, or the net's mask where there is none."""
    silhouette = silhouettes.views.get(view)
    if silhouette is not None and silhouette.mask.shape == proposal.mask.shape:
        return silhouette.mask
    return proposal.person()


def person_skin(photos: PhotoSet, proposals: Proposals, silhouettes: SilhouetteSet) -> dict[ViewId, SkinColour]:
    """Return the colour of the skin in every photo; photos without a face take that of the first with one."""
    found: dict[ViewId, SkinColour] = {}
    for view in _FACED:
        if view in photos.photos and view in proposals.views:
            mask = person_mask(view, proposals.views[view], silhouettes)
            colour = label_colour(photos.photos[view].rgb, mask, proposals.views[view].labels)
            if colour is not None:
                found[view] = colour
    if not found:
        return {}
    first = next(iter(found.values()))
    return {view: found.get(view, first) for view in photos.photos}


def matted_photo(
    view: ViewId,
    rgb: NDArray[np.uint8],
    proposal: Proposal,
    mask: NDArray[np.bool_],
    limits: Limits,
    skin: SkinColour | None,
) -> MattedPhoto:
    """Return the photo without background; see :func:`prepare_matted_photo`."""
    frontal = proposal.face_presence >= limits.face_presence and view.is_front
    return prepare_matted_photo(
        rgb,
        mask,
        proposal.labels,
        proposal.face_px if frontal else None,
        combined_pose(proposal) if view is ViewId.BODY_SIDE else None,
        skin,
    )
