"""The photos' labels as far as the person's own colours bear them out."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cloner.frames import ViewId
from cloner.records.photos import PhotoSet
from cloner.records.points import Proposals
from cloner.vision.plates import HAIR_LABEL, SKIN_LABEL
from cloner.vision.vetting import HairColours, before_wall, hair_colours, vet_hair

PERSON_LEVEL = 127  # a net's probability above one half


def vet_labels(photos: PhotoSet, proposals: Proposals) -> Proposals:
    """Return proposals without hair labels that the colours deny.

    Nowhere does the background shine through hair in patches. From behind, where no face tells where
    hair may be and collars and napes are taken for it, hair has no colour that it has in no other photo.
    """
    found = dict(proposals.views)
    for view, proposal in proposals.views.items():
        named = proposal.labels == HAIR_LABEL
        if view not in photos.photos or not named.any():
            continue
        rgb, colours = photos.photos[view].rgb, colours_elsewhere(photos, proposals, view)
        kept = before_wall(rgb, named, proposal.mask > PERSON_LEVEL, colours)
        if view is ViewId.BODY_BACK:
            kept = vet_hair(rgb, kept, colours)
        found[view] = replace(proposal, labels=np.where(named & ~kept, 0, proposal.labels).astype(np.uint8))
    return Proposals(found)


def colours_elsewhere(photos: PhotoSet, proposals: Proposals, view: ViewId) -> HairColours | None:
    """Return the colours of the hair in all photos but one; the back photo's labels are believed by no other."""
    others = [
        other
        for other in proposals.views
        if other is not view and other is not ViewId.BODY_BACK and other in photos.photos
    ]
    hair, skin = (
        [photos.photos[other].rgb[proposals.views[other].labels == label] for other in others]
        for label in (HAIR_LABEL, SKIN_LABEL)
    )
    return hair_colours(hair, skin)
