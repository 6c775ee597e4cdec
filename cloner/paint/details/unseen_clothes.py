"""Clothes where only photos of the face exist: the visible cloth, extended all around and down.

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
from cloner.paint.lookups.materials import Materials, continues, hands_beyond_cuffs, shown_bare_share
from cloner.paint.lookups.sources import Source
from cloner.paint.lookups.zones import always_bare
from cloner.records.arrays import Array
from cloner.records.labels import GARMENTS
from cloner.vision.retouching.normalising import log_levels

SQUARE: Final = 0.5  # cosine from which a view of cloth is believed
LEAST_CLOTH: Final = 30  # vertices; fewer are a scarf's end or noise
#: Arms have no sleeves where more skin than cloth is seen, and more than so many vertices, from the shoulders' tops
#: down by so much, beside the neck (two real portraits in straps: 8 and 14 against 0 and 5; in a shirt 0 against 22).
LEAST_SKIN, SHOULDER_M = 7, 0.07
COLLAR_QUANTILE: Final = 0.9  # of the heights at which cloth is seen beside the neck
NECK_SHARE: Final = 1.5  # of the neck's half width: collars stand around it
#: Over which heights a garment's edge rises from none to all: two edges of the skin's triangles, or its middle, where
#: the surface changes its kind, would follow their zigzag.
EDGE_M: Final = 0.03
KEPT_M, PLAIN_M = 0.02, 0.10  # surfaces go on as seen for 2 cm, beyond 10 cm they are plain
FALL: Final = 0.3  # taste: a shirt's front goes on downwards rather than sideways
LASTING_M: Final = 0.05  # taste: what of a shirt's front is so high goes on downwards
THROAT_M: Final = 0.04  # taste: skin goes on so far aside above skin: the throat, not the nape
BELOW_SKIN_M: Final = 0.02  # a neckline lies so far below the lowest skin that is seen
#: Levels of what no photo tells (taste): a shirt; trousers and shoes, which are never lighter than what is worn above.
SHIRT, TROUSERS, SHOES = np.array([[118, 122, 128], [52, 56, 66], [34, 32, 32]], np.float32)
#: Of what light does to one thing (taste): nearer is one colour, cloth looks like skin; white beside pale skin has .9.
ONE_COLOUR: Final = 0.5
#: Pixels of cloth in a photo from which their colour is a garment's, though it lies on no surface.
LEAST_PIXELS: Final = 400
#: Levels that count as one colour (taste).
BIN_LEVELS: Final = 16.0


def shows_faces_only(sources: list[Source]) -> bool:
    """Return whether no photo shows the body."""
    return all(source.view.is_face for source in sources)


def dress_unseen(
    generic: GenericHuman, sources: list[Source], kinds: Materials, vertices_m: Array, graph: SurfaceGraph
) -> Materials:
    """Return kinds with the person dressed to wrists and soles.

    A photo of the face ends at the chest, and from the neck's skin the unseen back would be bare.
    The collar stands behind as high as it does beside the neck. Without cloth in the photo it lies round the
    neck's base, and where shoulders are seen bare the shirt begins below what is seen. Bare shoulders have no
    sleeves below them.

    Parameters
    ----------
    kinds : Materials
    vertices_m : (V, 3)
    """
    cloth = _shown_cloth(sources, kinds)
    covered = np.ones(len(vertices_m), bool)
    if int(cloth.sum()) >= LEAST_CLOTH:
        aside = ~_near_median_plane(generic, vertices_m)
        ends = (np.stack([source.score for source in sources]) > 0.0) & (shown_bare_share(generic, sources) < 0.5)
        ends = (ends.any(axis=0) | cloth) & ~aside & ~generic.region("scalp")
        collar_m = np.quantile(vertices_m[ends if ends.any() else cloth, 1], COLLAR_QUANTILE)
        shoulders = _shown(sources) & kinds.skin & aside & ~generic.segment("head")
        if int(shoulders.sum()) < LEAST_CLOTH:  # a neckline that is low in front is not behind
            collar_m = np.maximum(collar_m, _neck_base_m(generic, vertices_m))
        arms = _any_segment(generic, ("arm", "hand"))
        high = aside & (vertices_m[:, 1] > vertices_m[arms, 1].max() - SHOULDER_M)
        if int((shoulders & high).sum()) > max(LEAST_SKIN, int((cloth & high).sum())):
            covered = ~arms
    else:
        collar_m, covered = _neckline(generic, sources, kinds, vertices_m)
    below = np.minimum(
        _garment_ramp(collar_m - vertices_m[:, 1]), _distance_from_seen_skin(generic, sources, kinds, vertices_m, graph)
    )
    worn = np.where(_shown(sources) | always_bare(generic), kinds.worn, covered * below)
    worn[np.concatenate(hands_beyond_cuffs(generic))] = 0.0
    return replace(kinds, bare=1.0 - worn, worn=worn)


def extend_clothes(
    generic: GenericHuman,
    sources: list[Source],
    base: NDArray[np.float32],
    kinds: Materials,
    vertices_m: Array,
    graph: SurfaceGraph,
) -> NDArray[np.float32]:
    """Return fills (3, V, 3) with skin and cloth far from what photos show in their dominant colours.

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
        found[0] += _fade_to_plain(graph.distance_from(skin, PLAIN_M)) * (_dominant_colour(base[0][skin]) - base[0])
    cloth = _shown_cloth(sources, kinds) & ~_is_skin_coloured(base[2], base[0][skin])
    if int(cloth.sum()) >= LEAST_CLOTH:
        low = cloth & (vertices_m[:, 1] <= np.median(vertices_m[cloth, 1]))  # a collar's trim is no shirt
        plain = _dominant_colour(base[2][low])
        fall, aside_m = _cloth_above(generic, base[2], vertices_m, cloth)
        as_seen = _fade_to_plain(graph.distance_from(cloth, PLAIN_M))
        found[2] += as_seen * (fall + _fade_to_plain(aside_m) * (plain - fall) - base[2])
    else:
        plain = _garment_colour(sources, base[0][skin])
        found[2] = np.where(seen[:, None] & (kinds.worn > 0.5)[:, None], base[2], plain)
    arms = _any_segment(generic, ("arm", "hand"))
    for ends, dark in (("pelvis", TROUSERS), ("foot", SHOES)):
        top_m = vertices_m[_any_segment(generic, (ends,)), 1].max() - 0.5 * EDGE_M
        share = np.where(seen | arms, 0.0, _garment_ramp(top_m - vertices_m[:, 1]))[:, None]
        found[2] += share * (np.minimum(plain, dark) - found[2])
    return found


def nearness_to_seen(sources: list[Source], graph: SurfaceGraph) -> Array:
    """Return 1 (V,) at what photos show and up to 10 cm around it, 0 beyond."""
    return np.asarray(graph.distance_from(_shown(sources), PLAIN_M) < PLAIN_M, np.float64)


def _shown(sources: list[Source]) -> NDArray[np.bool_]:
    return np.asarray(np.any([(s.score > 0.0) & (s.visibility.cosine > SQUARE) for s in sources], axis=0), bool)


def _shown_cloth(sources: list[Source], kinds: Materials) -> NDArray[np.bool_]:
    return np.asarray(_shown(sources) & (kinds.worn > 0.5), bool)


def _garment_ramp(inside_m: Array) -> Array:
    """Return 0 outside a garment to 1 inside, by the distance inside its edge, metres."""
    return np.asarray(np.clip(0.5 + inside_m / EDGE_M, 0.0, 1.0))


def _neck_base_m(generic: GenericHuman, vertices_m: Array) -> Array:
    """Return the height (V,) of a plain neckline, metres: a plane through throat pit and nape."""
    neck = vertices_m[generic.region("neck")]
    before = neck[:, 2] > neck[:, 2].mean()
    pit, nape = (half[half[:, 1].argmin()] for half in (neck[before], neck[~before]))
    back = np.clip((pit[2] - vertices_m[:, 2]) / (pit[2] - nape[2]), 0.0, 1.0)
    return np.asarray(pit[1] + (nape[1] - pit[1]) * back)


def _neckline(
    generic: GenericHuman, sources: list[Source], kinds: Materials, vertices_m: Array
) -> tuple[Array, NDArray[np.bool_]]:
    """Return the height (V,) of a shirt's upper edge, metres, above which seen skin stays bare, and
    what it may cover.
    """
    base_m = _neck_base_m(generic, vertices_m)
    bare = vertices_m[_shown(sources) & (kinds.bare > 0.5) & ~generic.segment("head"), 1]
    lowest_m = bare.min(initial=np.inf) - BELOW_SKIN_M
    if lowest_m >= base_m.min():
        return base_m, np.ones(len(vertices_m), bool)
    return np.full(len(vertices_m), lowest_m), ~_any_segment(generic, ("arm", "hand"))


def _distance_from_seen_skin(
    generic: GenericHuman, sources: list[Source], kinds: Materials, vertices_m: Array, graph: SurfaceGraph
) -> Array:
    """Return 0 (V,) close to seen skin, and above it at the neck, to 1 beyond."""
    bare = _shown(sources) & (kinds.bare > 0.5)
    found = _garment_ramp(graph.distance_from(bare, KEPT_M + EDGE_M) - KEPT_M)
    low = np.flatnonzero(bare & ~generic.segment("head"))
    rows = np.flatnonzero(
        (found > 0.0)
        & _near_median_plane(generic, vertices_m)
        & (vertices_m[:, 1] > vertices_m[low, 1].min(initial=np.inf))
    )
    if rows.size:
        below = cKDTree(vertices_m[low][:, [0, 2]]).query_ball_point(vertices_m[rows][:, [0, 2]], THROAT_M)
        throat = [
            vertices_m[low[near], 1].min(initial=np.inf) < height
            for near, height in zip(below, vertices_m[rows, 1], strict=True)
        ]
        found[rows[throat]] = 0.0
    return found


def _garment_colour(sources: list[Source], skin_rgb: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the dominant colour (3,) of the photos' garments; a plain shirt's where it is like skin or none is seen.

    Parameters
    ----------
    skin_rgb : (N, 3) levels
    """
    worn = [s.matted.rgb[np.isin(s.matted.labels, GARMENTS)] for s in sources if not s.mirrored]
    pixels = np.concatenate(worn).astype(np.float32)
    found = _dominant_colour(pixels) if len(pixels) >= LEAST_PIXELS else SHIRT
    return np.asarray(SHIRT if _is_skin_coloured(found, skin_rgb) else found, np.float32)


def _is_skin_coloured(rgb: NDArray[np.float32], skin_rgb: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return which colours (..., 3) are like skin (N, 3), levels: a shirt of them would look bare."""
    if not len(skin_rgb):
        return np.zeros(rgb.shape[:-1], bool)
    return continues(rgb, np.median(log_levels(skin_rgb), axis=0), ONE_COLOUR)


def _cloth_above(
    generic: GenericHuman, cloth_rgb: NDArray[np.float32], vertices_m: Array, seen: NDArray[np.bool_]
) -> tuple[NDArray[np.float32], Array]:
    """Return the colour (V, 3) of the cloth seen above each vertex, and its distance sideways (V,), metres.

    Only the trunk's goes on downwards, and of it only what is seen to go on: no badge. For all else what is above
    is far.
    """
    place = vertices_m * (1.0, FALL, 1.0)
    rows = np.flatnonzero(seen)
    near = rows[cKDTree(place[rows]).query(place)[1]]
    above = rows[cKDTree(vertices_m[rows]).query(vertices_m[near] + (0.0, LASTING_M, 0.0))[1]]
    lasting = continues(cloth_rgb[near], log_levels(cloth_rgb[above]), ONE_COLOUR)
    aside = np.linalg.norm((vertices_m - vertices_m[near])[:, [0, 2]], axis=1)
    return cloth_rgb[near], np.where(_any_segment(generic, ("torso", "pelvis")) & lasting, aside, PLAIN_M)


def _fade_to_plain(away_m: Array) -> Array:
    """Return 0 (V, 1) as far as surfaces continue as seen, to 1 where they are plain."""
    return np.asarray(np.clip((away_m - KEPT_M) / (PLAIN_M - KEPT_M), 0.0, 1.0)[:, None])


def _any_segment(generic: GenericHuman, endings: tuple[str, ...]) -> NDArray[np.bool_]:
    """Return (V,) which vertices are of segments whose names end so."""
    of = np.array([name.endswith(endings) for name in generic.segment_names])
    return np.asarray(of[generic.vertex_segment], bool)


def _near_median_plane(generic: GenericHuman, vertices_m: Array) -> NDArray[np.bool_]:
    """Return which vertices (V,) lie hardly farther from the median plane than the neck's half width."""
    reach = NECK_SHARE * float(np.abs(vertices_m[generic.region("neck"), 0]).max())
    return np.asarray(np.abs(vertices_m[:, 0]) < reach, bool)


def _dominant_colour(rgb: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the mean (3,) of the fullest histogram cell of colours (N, 3)."""
    _, place, count = np.unique(np.floor(rgb / BIN_LEVELS), axis=0, return_inverse=True, return_counts=True)
    return np.asarray(rgb[place.ravel() == int(count.argmax())].mean(axis=0), np.float32)
