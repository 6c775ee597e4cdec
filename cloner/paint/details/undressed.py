"""What a person wears where only photos of the face exist: their collar's cloth, all around and down."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.paint.lookups.materials import Materials, hands_beyond_cuffs, shown_bare
from cloner.paint.lookups.sources import Source
from cloner.paint.lookups.zones import always_bare
from cloner.records.arrays import Array

SQUARE: Final = 0.5  # cosine from which a sight of cloth is believed
LEAST_CLOTH: Final = 30  # vertices; fewer are a scarf's end or noise
COLLAR_QUANTILE: Final = 0.9  # of the heights at which cloth is seen beside the neck
NECK_SHARE: Final = 1.5  # of the neck's half width: collars stand around it
SOFT_M: Final = 0.006  # a collar's edge fades over a vertex or two
KEPT_M, PLAIN_M = 0.02, 0.10  # surfaces go on as seen for 2 cm, beyond 10 cm they are plain
#: Levels that count as one colour (taste).
BIN_LEVELS: Final = 16.0


def only_faces(sources: list[Source]) -> bool:
    """Return whether no photo shows the body."""
    return all(source.view.is_face for source in sources)


def dress_unseen(generic: GenericHuman, sources: list[Source], kinds: Materials, vertices_m: Array) -> Materials:
    """Return kinds in which whoever wears something at the collar is dressed to wrists and soles.

    A photo of the face ends at the chest, and from the neck's skin the unseen back would be bare.
    The collar stands behind as high as it does beside the neck.

    Parameters
    ----------
    kinds : Materials
    vertices_m : (V, 3)
    """
    cloth = _shown_cloth(sources, kinds)
    if int(cloth.sum()) < LEAST_CLOTH:
        return kinds
    ends = (np.stack([source.score for source in sources]) > 0.0) & (shown_bare(generic, sources) < 0.5)
    ends = (ends.any(axis=0) | cloth) & _beside_neck(generic, vertices_m) & ~generic.region("scalp")
    collar = float(np.quantile(vertices_m[ends if ends.any() else cloth, 1], COLLAR_QUANTILE))
    below = np.clip(0.5 + (collar - vertices_m[:, 1]) / SOFT_M, 0.0, 1.0)
    worn = np.where(_shown(sources) | always_bare(generic), kinds.worn, below)
    worn[np.concatenate(hands_beyond_cuffs(generic))] = 0.0
    return replace(kinds, bare=1.0 - worn, worn=worn)


def plain_beyond(
    sources: list[Source], base: NDArray[np.float32], kinds: Materials, height_m: Array, graph: SurfaceGraph
) -> NDArray[np.float32]:
    """Return (3, V, 3) fills in which skin and cloth far from what photos show have the one colour most of it has.

    Parameters
    ----------
    base : (3, V, 3) levels of skin, hair and cloth
    kinds : Materials
    height_m : (V,) of the vertices
    """
    found = base.copy()
    skin = _shown(sources) & (kinds.bare > 0.5) & (kinds.scalp < 0.5)
    cloth = _shown_cloth(sources, kinds)
    low = cloth & (height_m <= np.median(height_m[cloth])) if cloth.any() else cloth  # a collar's trim is no shirt
    for kind, shown, alike in ((0, skin, skin), (2, cloth, low)):
        if int(shown.sum()) >= LEAST_CLOTH:
            share = np.clip((graph.distance_from(shown, PLAIN_M) - KEPT_M) / (PLAIN_M - KEPT_M), 0.0, 1.0)[:, None]
            found[kind] += share * (_commonest(base[kind][alike]) - base[kind])
    return found


def near_sight(sources: list[Source], graph: SurfaceGraph) -> Array:
    """Return (V,) 1 at what photos show and up to 10 cm around it, 0 beyond: a collar says nothing of the legs."""
    return np.asarray(graph.distance_from(_shown(sources), PLAIN_M) < PLAIN_M, np.float64)


def _shown(sources: list[Source]) -> NDArray[np.bool_]:
    return np.asarray(np.any([(s.score > 0.0) & (s.sight.cosine > SQUARE) for s in sources], axis=0), bool)


def _shown_cloth(sources: list[Source], kinds: Materials) -> NDArray[np.bool_]:
    return np.asarray(_shown(sources) & (kinds.worn > 0.5), bool)


def _beside_neck(generic: GenericHuman, vertices_m: Array) -> NDArray[np.bool_]:
    """Return (V,) what lies hardly farther from the middle than the neck is wide."""
    reach = NECK_SHARE * float(np.abs(vertices_m[generic.region("neck"), 0]).max())
    return np.asarray(np.abs(vertices_m[:, 0]) < reach, bool)


def _commonest(rgb: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (3,) the mean of the fullest cell of (N, 3) colours: a mean of all would be nobody's."""
    _, place, count = np.unique(np.floor(rgb / BIN_LEVELS), axis=0, return_inverse=True, return_counts=True)
    return np.asarray(rgb[place.ravel() == int(count.argmax())].mean(axis=0), np.float32)
