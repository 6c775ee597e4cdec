"""The photos' labels as far as the person's own colours bear them out."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.abreast import abreast
from cloner.frames import ViewId
from cloner.records.photos import PhotoSet
from cloner.records.points import Proposal, Proposals
from cloner.vision.plates import HAIR_LABEL, SKIN_LABEL
from cloner.vision.vetting import before_wall, hair_colours, vet_hair, without_neck

STRIDE = 4  # colours of hair need no more
UPPER_LIP = 13  # in the face net's mesh
PERSON_LEVEL = 127  # a net's probability above one half


def vet_labels(photos: PhotoSet, proposals: Proposals) -> Proposals:
    """Return proposals without hair labels that the colours deny.

    Nowhere does the background shine through hair in patches. From behind, where no face tells where
    hair may be and collars and napes are taken for it, hair has no colour that it has in no other photo.
    """
    known = {view: proposal for view, proposal in proposals.views.items() if view in photos.photos}
    hair, skin = (
        {view: labelled_pixels(photos.photos[view].rgb, proposal.labels, label) for view, proposal in known.items()}
        for label in (HAIR_LABEL, SKIN_LABEL)
    )

    def vetted(view: ViewId) -> Proposal:
        proposal = known[view]
        # The back photo's own labels are believed by no other.
        others = [other for other in known if other is not view and other is not ViewId.BODY_BACK]
        colours = hair_colours([hair[other] for other in others], [skin[other] for other in others])
        labelled = named = proposal.labels == HAIR_LABEL
        if view is ViewId.FACE_FRONT and proposal.face_presence > 0.0:
            named = begun_above(named, proposal.face_px)
        kept = before_wall(photos.photos[view].rgb, named, proposal.mask > PERSON_LEVEL, colours)
        if view in (ViewId.BODY_SIDE, ViewId.FACE_SIDE):
            kept = without_neck(photos.photos[view].rgb, kept, proposal.labels == SKIN_LABEL)
        if view is ViewId.BODY_BACK:
            kept = vet_hair(photos.photos[view].rgb, kept, colours)
        return replace(proposal, labels=np.where(labelled & ~kept, 0, proposal.labels).astype(np.uint8))

    shown = [view for view in known if len(hair[view])]
    return Proposals({**proposals.views, **dict(zip(shown, abreast(vetted, shown), strict=True))})


def begun_above(hair: NDArray[np.bool_], face_px: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return the (H, W) pieces of hair that begin above the mouth: what begins lower is a dark collar or scarf."""
    _, pieces, stats, _ = cv2.connectedComponentsWithStats(hair.astype(np.uint8), connectivity=8)
    above = stats[:, cv2.CC_STAT_TOP] < face_px[UPPER_LIP, 1]
    above[0] = False
    return np.asarray(above[pieces], bool)


def labelled_pixels(rgb: NDArray[np.uint8], labels: NDArray[np.uint8], label: int) -> NDArray[np.uint8]:
    """Return (N, 3) colours of every fourth row and column under a label."""
    return np.asarray(rgb[::STRIDE, ::STRIDE][labels[::STRIDE, ::STRIDE] == label], np.uint8)
