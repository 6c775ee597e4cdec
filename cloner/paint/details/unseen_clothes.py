"""What a person wears where only photos of the face exist: the cloth they show, all around and down to the waist.

Below are dark trousers and shoes; who shows no cloth at all gets a plain shirt, since nobody is naked unasked.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.generic.load import GenericHuman
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.paint.lookups.materials import Materials, goes_on, hands_beyond_cuffs, shown_bare
from cloner.paint.lookups.sources import Source
from cloner.paint.lookups.zones import always_bare
from cloner.records.arrays import Array
from cloner.records.labels import GARMENTS
from cloner.vision.retouching.evening import log_levels

SQUARE: Final = 0.5  # cosine from which a sight of cloth is believed
LEAST_CLOTH: Final = 30  # vertices; fewer are a scarf's end or noise
COLLAR_QUANTILE: Final = 0.9  # of the heights at which cloth is seen beside the neck
NECK_SHARE: Final = 1.5  # of the neck's half width: collars stand around it
SOFT_M: Final = 0.006  # a collar's edge fades over a vertex or two
KEPT_M, PLAIN_M = 0.02, 0.10  # surfaces go on as seen for 2 cm, beyond 10 cm they are plain
FALL: Final = 0.3  # taste: a shirt's front goes on downwards rather than sideways
THROAT_M: Final = 0.04  # taste: skin goes on so far aside above skin: the throat, not the nape
BELOW_SKIN_M: Final = 0.02  # a neckline lies so far below the lowest skin that is seen
#: Levels of what no photo tells (taste): a shirt; trousers and shoes, which are never lighter than what is worn above.
SHIRT, TROUSERS, SHOES = np.array([[118, 122, 128], [52, 56, 66], [34, 32, 32]], np.float32)
#: Of what light does to one thing (taste): nearer to the skin's colour cloth looks like skin; white beside pale has .9.
AS_SKIN: Final = 0.5
#: Pixels of cloth in a photo from which their colour is a garment's, though it lies on no surface.
LEAST_PIXELS: Final = 400
#: Levels that count as one colour (taste).
BIN_LEVELS: Final = 16.0


def only_faces(sources: list[Source]) -> bool:
    """Return whether no photo shows the body."""
    return all(source.view.is_face for source in sources)


def dress_unseen(
    generic: GenericHuman, sources: list[Source], kinds: Materials, vertices_m: Array, graph: SurfaceGraph
) -> Materials:
    """Return kinds in which the person is dressed to wrists and soles.

    A photo of the face ends at the chest, and from the neck's skin the unseen back would be bare.
    The collar stands behind as high as it does beside the neck. Without cloth in the photo it lies round the
    neck's base, and where shoulders are seen bare the shirt begins below what is seen and has no sleeves.

    Parameters
    ----------
    kinds : Materials
    vertices_m : (V, 3)
    """
    cloth = _shown_cloth(sources, kinds)
    covered = np.ones(len(vertices_m), bool)
    if int(cloth.sum()) >= LEAST_CLOTH:
        ends = (np.stack([source.score for source in sources]) > 0.0) & (shown_bare(generic, sources) < 0.5)
        ends = (ends.any(axis=0) | cloth) & _beside_neck(generic, vertices_m) & ~generic.region("scalp")
        collar = float(np.quantile(vertices_m[ends if ends.any() else cloth, 1], COLLAR_QUANTILE))
        shoulders = _shown(sources) & kinds.skin & ~_beside_neck(generic, vertices_m) & ~generic.segment("head")
        if int(shoulders.sum()) < LEAST_CLOTH:  # a neckline that is low in front is not behind
            collar = max(collar, _neck_base_m(generic, vertices_m))
    else:
        collar, covered = _neckline(generic, sources, kinds, vertices_m)
    below = covered * np.clip(0.5 + (collar - vertices_m[:, 1]) / SOFT_M, 0.0, 1.0)
    below[_above_skin(generic, sources, kinds, vertices_m, graph)] = 0.0
    worn = np.where(_shown(sources) | always_bare(generic), kinds.worn, below)
    worn[np.concatenate(hands_beyond_cuffs(generic))] = 0.0
    return replace(kinds, bare=1.0 - worn, worn=worn)


def clothe_beyond(
    generic: GenericHuman,
    sources: list[Source],
    base: NDArray[np.float32],
    kinds: Materials,
    vertices_m: Array,
    graph: SurfaceGraph,
) -> NDArray[np.float32]:
    """Return (3, V, 3) fills in which skin and cloth far from what photos show have the one colour most of it has.

    The trunk's front goes on downwards as the photo's lower edge shows it; trousers and shoes are dark.

    Parameters
    ----------
    base : (3, V, 3) levels of skin, hair and cloth
    kinds : Materials
    vertices_m : (V, 3)
    """
    found = base.copy()
    seen = _shown(sources)
    skin = seen & (kinds.bare > 0.5) & (kinds.scalp < 0.5)
    if int(skin.sum()) >= LEAST_CLOTH:
        found[0] += _far(graph.distance_from(skin, PLAIN_M)) * (_commonest(base[0][skin]) - base[0])
    cloth = _shown_cloth(sources, kinds) & ~_as_skin(base[2], base[0][skin])
    if int(cloth.sum()) >= LEAST_CLOTH:
        low = cloth & (vertices_m[:, 1] <= np.median(vertices_m[cloth, 1]))  # a collar's trim is no shirt
        plain = _commonest(base[2][low])
        fall, aside_m = _fall(generic, base[2], vertices_m, cloth)
        as_seen = _far(graph.distance_from(cloth, PLAIN_M))
        found[2] += as_seen * (fall + _far(aside_m) * (plain - fall) - base[2])
    else:
        plain = _garment_colour(sources, base[0][skin])
        found[2] = np.where(seen[:, None] & (kinds.worn > 0.5)[:, None], base[2], plain)
    waist_m = vertices_m[generic.segment("pelvis"), 1].max()
    legs = _any_segment(generic, ("pelvis", "thigh", "calf")) & (vertices_m[:, 1] < waist_m)
    for part, dark in ((legs, TROUSERS), (_any_segment(generic, ("foot",)), SHOES)):
        found[2][part & ~seen] = np.minimum(plain, dark)
    return found


def near_sight(sources: list[Source], graph: SurfaceGraph) -> Array:
    """Return (V,) 1 at what photos show and up to 10 cm around it, 0 beyond: a collar says nothing of the legs."""
    return np.asarray(graph.distance_from(_shown(sources), PLAIN_M) < PLAIN_M, np.float64)


def _shown(sources: list[Source]) -> NDArray[np.bool_]:
    return np.asarray(np.any([(s.score > 0.0) & (s.sight.cosine > SQUARE) for s in sources], axis=0), bool)


def _shown_cloth(sources: list[Source], kinds: Materials) -> NDArray[np.bool_]:
    return np.asarray(_shown(sources) & (kinds.worn > 0.5), bool)


def _neck_base_m(generic: GenericHuman, vertices_m: Array) -> float:
    return float(vertices_m[generic.region("neck"), 1].min())


def _neckline(
    generic: GenericHuman, sources: list[Source], kinds: Materials, vertices_m: Array
) -> tuple[float, NDArray[np.bool_]]:
    """Return the height of a shirt's upper edge that covers nothing seen bare, metres, and what (V,) it may cover."""
    neck_m = _neck_base_m(generic, vertices_m)
    bare = vertices_m[_shown(sources) & (kinds.bare > 0.5) & ~generic.segment("head"), 1]
    lowest_m = float(bare.min()) - BELOW_SKIN_M if bare.size else neck_m
    if lowest_m >= neck_m:
        return neck_m, np.ones(len(vertices_m), bool)
    return lowest_m, ~_any_segment(generic, ("arm", "hand"))


def _above_skin(
    generic: GenericHuman, sources: list[Source], kinds: Materials, vertices_m: Array, graph: SurfaceGraph
) -> NDArray[np.bool_]:
    """Return (V,) what lies close to skin that is seen, or above it at the neck: a throat in the chin's shade."""
    bare = _shown(sources) & (kinds.bare > 0.5)
    found = graph.distance_from(bare, KEPT_M) < KEPT_M
    low = np.flatnonzero(bare & ~generic.segment("head"))
    rows = np.flatnonzero(
        ~found & _beside_neck(generic, vertices_m) & (vertices_m[:, 1] > vertices_m[low, 1].min(initial=np.inf))
    )
    if rows.size:
        below = cKDTree(vertices_m[low][:, [0, 2]]).query_ball_point(vertices_m[rows][:, [0, 2]], THROAT_M)
        found[rows] = [
            vertices_m[low[near], 1].min(initial=np.inf) < height
            for near, height in zip(below, vertices_m[rows, 1], strict=True)
        ]
    return found


def _garment_colour(sources: list[Source], skin_rgb: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (3,) the commonest colour of the photos' garments, a plain shirt's where it is the skin's or none is seen.

    Parameters
    ----------
    skin_rgb : (N, 3) levels
    """
    worn = [s.plate.rgb[np.isin(s.plate.labels, GARMENTS)] for s in sources if not s.mirrored]
    pixels = np.concatenate(worn).astype(np.float32)
    found = _commonest(pixels) if len(pixels) >= LEAST_PIXELS else SHIRT
    return np.asarray(SHIRT if _as_skin(found, skin_rgb) else found, np.float32)


def _as_skin(rgb: NDArray[np.float32], skin_rgb: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return which colours (..., 3) are those of skin (N, 3), levels: a shirt of them would look like none."""
    if not len(skin_rgb):
        return np.zeros(rgb.shape[:-1], bool)
    return goes_on(rgb, np.median(log_levels(skin_rgb), axis=0), AS_SKIN)


def _fall(
    generic: GenericHuman, cloth_rgb: NDArray[np.float32], vertices_m: Array, seen: NDArray[np.bool_]
) -> tuple[NDArray[np.float32], Array]:
    """Return (V, 3) the colour of the cloth seen above each vertex, and (V,) how far aside that is, metres.

    Only the trunk's goes on downwards; for all else what is above is far.
    """
    place = vertices_m * (1.0, FALL, 1.0)
    rows = np.flatnonzero(seen)
    near = rows[cKDTree(place[rows]).query(place)[1]]
    aside = np.linalg.norm((vertices_m - vertices_m[near])[:, [0, 2]], axis=1)
    return cloth_rgb[near], np.where(_any_segment(generic, ("torso", "pelvis")), aside, PLAIN_M)


def _far(away_m: Array) -> Array:
    """Return (V, 1) 0 as far as surfaces go on as seen, 1 where they are plain."""
    return np.asarray(np.clip((away_m - KEPT_M) / (PLAIN_M - KEPT_M), 0.0, 1.0)[:, None])


def _any_segment(generic: GenericHuman, endings: tuple[str, ...]) -> NDArray[np.bool_]:
    """Return (V,) which vertices are of segments whose names end so."""
    of = np.array([name.endswith(endings) for name in generic.segment_names])
    return np.asarray(of[generic.vertex_segment], bool)


def _beside_neck(generic: GenericHuman, vertices_m: Array) -> NDArray[np.bool_]:
    """Return (V,) what lies hardly farther from the middle than the neck is wide."""
    reach = NECK_SHARE * float(np.abs(vertices_m[generic.region("neck"), 0]).max())
    return np.asarray(np.abs(vertices_m[:, 0]) < reach, bool)


def _commonest(rgb: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (3,) the mean of the fullest cell of (N, 3) colours: a mean of all would be nobody's."""
    _, place, count = np.unique(np.floor(rgb / BIN_LEVELS), axis=0, return_inverse=True, return_counts=True)
    return np.asarray(rgb[place.ravel() == int(count.argmax())].mean(axis=0), np.float32)
