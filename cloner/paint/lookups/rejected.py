"""Rejection of unreliable lookups: at grazing angles an error of one pixel is centimetres on the surface."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.generic.photo_shares import mirrored_share, photo_shares
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.paint.lookups.materials import (
    SQUARE,
    Materials,
    continues,
    shown_bare_share,
    shown_surfaces,
    shows_garment,
)
from cloner.paint.lookups.sources import CLAIM_POWER, Source
from cloner.paint.lookups.zones import always_bare
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample
from cloner.vision.retouching.normalising import log_levels

#: Share of bareness by which two photos call a texel skin and cloth (taste).
STRANGE_KIND: Final = 0.5
#: A photo that shows a part of which the surface is less than this shows something that stands before or behind it.
STRANGER: Final = 0.25
PATTERNED: Final = 0.35  # cosine from which stripes are believed on cloth; who strays so far shows skin, hair or wall
#: Log level by which evened photos of one face show different things; measured on the sample visitors: nine in ten
#: vertices of the face differ by less than .25, hair before the temple by .4 and more.
FACE_GAP: Final = 0.3
#: Cosine from which hair beside a face is not taken for the face, and from which another photo may say so.
SLANTED, TELLING = 0.65, 0.4
HAIR_RINGS: Final = 1  # around dark sights: the shade beside hair is no skin's colour
#: Of a brow in the photo that faces it, 0..1: from here on it is the brow, from there on what lies close by.
BROW, BESIDE_BROW = 0.75, 0.25
BROW_CLAIM: Final = 2.0  # of its usual claim has the photo that faces the brows, around them


def reject_grazing(generic: GenericHuman, sources: list[Source], colours: Array, kinds: Materials) -> list[Source]:
    """Return the sources without grazing lookups that differ from their surroundings.

    The top of a shoulder takes the colour of the neck behind it, a jaw that of a collar. Such a view is believed where
    it agrees with what photos show squarely nearby; if it is not too slant, cloth may have stripes of its own.

    Parameters
    ----------
    colours : (K, V, 3) levels, not yet evened
    kinds : Materials
        With its surroundings.
    """
    if kinds.around is None:
        return sources
    shown = shown_bare_share(generic, sources)
    found = []
    for k, source in enumerate(sources):
        alike = continues(colours[k], kinds.around) | ((source.visibility.cosine > PATTERNED) & ~kinds.skin)
        alike &= np.abs(shown[k] - kinds.bare) < STRANGE_KIND
        found.append(replace(source, score=source.score * ((source.visibility.cosine > SQUARE) | alike)))
    return found


def reject_wrong_parts(generic: GenericHuman, sources: list[Source], kinds: Materials) -> list[Source]:
    """Return the sources without lookups on another part of the person than the surface belongs to.

    The fitted arm misses the photo's arm by a centimetre, and the trunk behind would paint a streak on the sleeve.
    Where no photo shows the right part the surface is filled from around it. Face and ears keep what photos show
    there but garments, glasses too: nothing else would be left of them.

    Parameters
    ----------
    kinds : Materials
    """
    shown = shown_surfaces(sources)
    rows = np.arange(shown.shape[1])
    own = np.stack([np.where(each < 0, 1.0, kinds.surfaces[rows, np.maximum(each, 0)]) for each in shown])
    garment = np.stack([shows_garment(source, source.lookup_px) for source in sources])
    strange = (own < STRANGER) & (~always_bare(generic) | garment)
    return [replace(s, score=np.where(strange[k], 0.0, s.score)) for k, s in enumerate(sources)]


def reject_slanted(generic: GenericHuman, sources: list[Source], evened: Array, graph: SurfaceGraph) -> list[Source]:
    """Return the sources without oblique lookups on the face that differ from a photo with a better view.

    Hair beside the temple, a brow's tail a few millimetres off: whose place it is by angle is right, however burnt
    out it is there.

    Parameters
    ----------
    evened : (K, V, 3) levels after evening
    """
    level = np.asarray(log_levels(evened), np.float64)
    photos = frozenset(source.view for source in sources)
    claim = np.stack([_angle_claim(generic, source, photos) for source in sources])
    brow = np.stack([sample(source.matted.brows, source.lookup_px)[:, 0] / 255.0 for source in sources])
    face = generic.region("face")
    own = (brow > BROW) | generic.region("eyelids") | generic.region("lips")
    hidden = face & ~own & _dark_before_skin(sources, claim, level.mean(axis=2), graph)
    claim = np.where(hidden, 0.0, np.where(brow > BESIDE_BROW, BROW_CLAIM * claim, claim))
    best = claim.argmax(axis=0)
    gap = np.abs(level - level[best, np.arange(len(best))]).mean(axis=2)
    other = ((gap > FACE_GAP) | (brow.max(axis=0) > BESIDE_BROW)) & face & (claim > 0.0)
    other = _dilated(other, graph, 1) & (
        np.arange(len(sources))[:, None] != best
    )  # half its ring is of the other thing
    denied = hidden | other
    return [replace(source, score=np.where(denied[k], 0.0, source.score)) for k, source in enumerate(sources)]


def _angle_claim(generic: GenericHuman, source: Source, photos: frozenset[ViewId]) -> Array:
    """Return a photo's claim (V,) by its viewing angle alone; 0 where it does not show the surface."""
    share = photo_shares(generic, source.view, photos=photos) * (mirrored_share() if source.mirrored else 1.0)
    return np.where(source.score > 0.0, share * np.clip(source.visibility.cosine, 0.0, 1.0) ** CLAIM_POWER, 0.0)


def _dark_before_skin(sources: list[Source], claim: Array, level: Array, graph: SurfaceGraph) -> NDArray[np.bool_]:
    """Return where (K, V) a photo obliquely shows something dark, with a margin, and another one skin.

    Parameters
    ----------
    claim : (K, V) by angle
    level : (K, V) logarithms of brightness after evening
    """
    cosine = np.stack([source.visibility.cosine for source in sources])
    telling = (claim > 0.0) & (cosine > TELLING)
    skin = np.where(telling, level, -np.inf).max(axis=0)
    dark = (level < skin - FACE_GAP) & (cosine < SLANTED) & (claim > 0.0)
    others = telling.sum(axis=0) - telling
    return np.asarray(_dilated(dark, graph, HAIR_RINGS) & (cosine < SLANTED) & (others > 0), bool)


def _dilated(flags: NDArray[np.bool_], graph: SurfaceGraph, rings: int) -> NDArray[np.bool_]:
    """Return flags (K, V) dilated to neighbours along the surface."""
    link = (graph.lengths > 0).astype(np.float64)
    grown: Array = flags.T.astype(np.float64)
    for _ in range(rings):
        grown = grown + link @ grown
    return np.asarray(grown.T > 0.0, bool)
