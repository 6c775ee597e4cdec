"""Materials of the surface by vote of the photos: bare skin, hair, or something worn."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.paint.lookups.sources import Source
from cloner.paint.lookups.zones import always_bare, hair_allowed
from cloner.records.arrays import Array
from cloner.records.labels import GARMENTS, SURFACE_OF, SURFACES, labels_at
from cloner.vision.retouching.aligning import sample
from cloner.vision.retouching.normalising import beyond_light, log_levels

SQUARE = 0.5  # cosine from which a view is believed by itself
KIND_STIFFNESS = 0.4  # an island of one or two edges is outvoted by what surrounds it
#: Bareness at which a texel begins to be skin and is all skin (taste).
KIND_STEP = (0.25, 0.75)
SPREAD_STIFFNESS = 0.02  # what is seen squarely holds, other vertices follow their neighbours
MAJORITY = 0.3  # weight of what most of a body part is, against one frontal view
SURE = 4.0  # a claim of a half decides alone; a grazing one says little beside the neighbours
CUFF_SHARE = 0.35  # of the hand: how far cuffs reach from the wrist
BARE_HAND = 0.7  # of what is seen of a hand: more skin than that and it wears no glove
HAIR_ROUNDS = 2  # rings over which the scalp's own kind fades


@dataclass(frozen=True, slots=True, eq=False)
class Materials:
    """Shares of materials at each vertex.

    Attributes
    ----------
    bare : (V,) float64 in 0..1, the person's own: skin or hair
    scalp : (V,) float64 in 0..1, where the person's own is hair
    worn : (V,) float64, 1 - bare
    surfaces : (V, 6) float64
        Shares of ``SURFACES``; rows sum to one.
    around : (V, 3) float64 or None
        Log levels of the same kind nearby, as photos show it squarely; None where nobody looked.
    """

    bare: Array
    scalp: Array
    worn: Array
    surfaces: Array
    around: Array | None = None

    @property
    def skin(self) -> NDArray[np.bool_]:
        """Return which vertices (V,) are skin and neither hair nor worn."""
        return np.asarray(self.bare * (1.0 - self.scalp) > 0.5)


def _with_majority(generic: GenericHuman, vote: Array, weight: Array) -> tuple[Array, Array]:
    """Return votes (V, S) and weights in which unseen vertices lean to the majority of their body part."""
    segment = generic.vertex_segment
    total = np.bincount(segment, weight)
    sums = np.stack([np.bincount(segment, weight * column) for column in vote.T], axis=1)
    mean: Array = sums / np.maximum(total, 1e-9)[:, None]
    clear = (MAJORITY * np.clip(2.0 * mean.max(axis=1) - 1.0, 0.0, 1.0) ** 2 * (total > 0.0))[segment]
    both = weight + clear
    return (weight[:, None] * vote + clear[:, None] * mean[segment]) / np.maximum(both, 1e-12)[:, None], both


def hands_beyond_cuffs(generic: GenericHuman) -> list[NDArray[np.intp]]:
    """Return the vertices of both hands that no cuff covers."""
    found = []
    for side in ("left", "right"):
        rows = np.flatnonzero(generic.segment(f"{side}_hand"))
        reach = np.linalg.norm(generic.vertices_m[rows] - generic.joints_m[generic.joint(f"{side[0]}_wrist")], axis=1)
        found.append(rows[reach > CUFF_SHARE * reach.max()])
    return found


def with_surroundings(sources: list[Source], colours: Array, kinds: Materials, graph: SurfaceGraph) -> Materials:
    """Return the materials with what photos show frontally around each vertex.

    Parameters
    ----------
    colours : (K, V, 3) levels, not yet evened
    """
    logs = np.asarray(log_levels(colours), np.float64)
    square = np.stack([np.where(s.visibility.cosine > SQUARE, s.score, 0.0) for s in sources])
    if not square.any():
        return kinds
    bare = square * kinds.skin
    bare *= np.stack([is_skin_colour(shown, weight > 0.0) for shown, weight in zip(logs, bare, strict=True)])
    around = []
    for weight in (square * ~kinds.skin, bare):
        total = weight.sum(axis=0)
        mean = (weight[..., None] * logs).sum(axis=0) / np.maximum(total, 1e-9)[:, None]
        around.append(graph.fill(mean, np.clip(2.0 * total, 0.0, 1.0), SPREAD_STIFFNESS))
    return replace(kinds, around=np.where(kinds.skin[:, None], around[1], around[0]))


def is_skin_colour(logs: Array, sure: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which log levels (N, 3) differ from the skin's by no more than lighting explains.

    Parameters
    ----------
    sure : (N,)
        What is skin by its label; the median of these is the skin's colour.
    """
    if not sure.any():
        return np.ones(len(logs), bool)
    return np.asarray(beyond_light(logs - np.median(logs[sure], axis=0)) < 1.0)


def continues(rgb: NDArray[np.floating], around: NDArray[np.floating], most: float = 1.0) -> NDArray[np.bool_]:
    """Return which colours (..., 3), levels, differ from log levels around them by no more than lighting explains.

    ``most`` is the limit as a share of that.
    """
    return np.asarray(beyond_light(log_levels(rgb) - around) < most)


def shows_garment(source: Source, lookup_px: NDArray[np.floating]) -> NDArray[np.bool_]:
    """Return which lookups (N,) land on a garment: a collar beside the jaw is not the face's.

    In a photo that is said to show no skin at all a face was taken for cloth.
    """
    worn = np.isin(labels_at(source.matted.labels, lookup_px), GARMENTS)
    return worn & bool(source.matted.bare.any())


def shown_bare_share(generic: GenericHuman, sources: list[Source]) -> Array:
    """Return in 0..1 (K, V) how much of the person's own skin or hair each photo shows at each vertex."""
    shown = np.stack([sample(s.matted.skin, s.lookup_px)[:, 0] / 255.0 for s in sources]).astype(np.float64)
    garment = np.stack([shows_garment(source, source.lookup_px) for source in sources])
    return np.where(always_bare(generic) & ~garment, 1.0, shown)


def shown_surfaces(sources: list[Source]) -> NDArray[np.int8]:
    """Return the index in ``SURFACES`` (K, V) of what each photo shows at each vertex, -1 where that is nobody."""
    return np.stack([SURFACE_OF[labels_at(source.matted.labels, source.lookup_px)] for source in sources])


def find_materials(generic: GenericHuman, sources: list[Source], graph: SurfaceGraph) -> Materials:
    """Return the materials of each vertex, by the labels of all photos.

    The photo that shows a place best decides: photos disagree about where
    a collar ends, because heads turn and cloth moves, and their mean would be a smear.
    """
    shown = shown_surfaces(sources)
    # a label at a slant is as sure as one seen squarely, unlike its place: who sees a surface squarely counts more
    claim = np.where(shown >= 0, np.stack([s.score for s in sources]) ** 2, 0.0)
    total = claim.sum(axis=0)
    vote = np.stack([(claim * (shown == k)).sum(axis=0) for k in range(len(SURFACES))], axis=1)
    vote /= np.maximum(total, 1e-12)[:, None]
    weight = np.clip(SURE * total, 0.0, 1.0)
    own = np.eye(len(SURFACES))[SURFACES.index("skin")]
    vote[always_bare(generic)], weight[always_bare(generic)] = own, 1.0
    vote, weight = _with_majority(generic, vote, weight)
    for hand in hands_beyond_cuffs(generic):
        seen = float(weight[hand].sum())
        if seen > 0.0 and float(weight[hand] @ vote[hand, 0]) > BARE_HAND * seen:
            vote[hand], weight[hand] = own, 1.0  # what shows between thumb and fingers is the coat behind them
    surfaces = np.clip(graph.fill(vote, weight, KIND_STIFFNESS), 0.0, 1.0)
    surfaces /= np.maximum(surfaces.sum(axis=1, keepdims=True), 1e-9)
    bare = surfaces[:, SURFACES.index("skin")] + surfaces[:, SURFACES.index("hair")]
    # Islands are misplaced sights: borders stay, what is smaller than some edges goes.
    bare = np.clip((bare - KIND_STEP[0]) / (KIND_STEP[1] - KIND_STEP[0]), 0.0, 1.0)
    hair = surfaces[:, SURFACES.index("hair")]
    hairy = hair / np.maximum(hair + surfaces[:, SURFACES.index("skin")], 1e-9)  # a bald scalp is skin like the face
    scalp = graph.smooth(hair_allowed(generic) * hairy, HAIR_ROUNDS)
    return Materials(bare, scalp, 1.0 - bare, surfaces)
