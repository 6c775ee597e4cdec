"""Bare skin of a clone: the person's own surface and colour in the photos."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components

from cloner.errors import ClonerError
from cloner.generic.charts import person_graph, vertex_uv
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.charts.atlas import colours_at
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.geometry.meshes.triangles import areas
from cloner.paint.lookups.zones import always_bare
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.regions import REGIONS

Flags = NDArray[np.bool_]

#: Skin nearer to cloth than this shows its shadow or its hem, metres.
HEM_M: Final = 0.020
#: From this share on a vertex is the head's, which stays as it is whatever is worn on it; from the other on, hair that
#: lies on it is the person's own nape.
HEAD, NAPE = 0.95, 0.5
#: Bare skin that hangs together with neither head nor hands is believed on limbs, from this size on, square metres.
PATCH_M2: Final = 0.008
#: Skin's red and blue beside its green differ by less from the person's usual, and its green itself, logarithms.
TINGE, LIGHT = 0.30, 0.90
#: Vertices that tell of a tone.
ENOUGH: Final = 150
#: What is judged skin by colour needs so many levels of green.
DARKEST: Final = 8.0


def bare_skin(clone: Clone) -> Flags:
    """Return (V,) which vertices are the person's own skin (head included), away from hems.

    Raises
    ------
    ClonerError
        If nobody said what the clone's surface is made of.
    """
    if not len(clone.triangle_regions):
        raise ClonerError("the clone does not tell its clothes from its skin", "Clone the photos again", "clone.npz")
    generic = load_generic()
    graph = person_graph(generic, clone.vertices_m)
    head, worn = generic.head_blend >= HEAD, worn_skin(generic, clone)
    head &= ~worn
    bare = generic.skin & ~worn & (head | (graph.distance_from(worn, 2.0 * HEM_M) > HEM_M))
    bare &= head | _skin_coloured(generic, clone, bare)
    return np.asarray(head & generic.skin | _whole(generic, clone, graph, bare))


def worn_skin(generic: GenericHuman, clone: Clone) -> Flags:
    """Return (V,) which vertices lie under cloth, shoes, or hair that hangs over the body."""
    triangles, _ = generic.triangles()
    worn = np.zeros(len(generic.vertices_m), dtype=bool)
    own = always_bare(generic) | generic.region("scalp")  # caps and hoods stay
    for names, where in ((("upper_clothes", "lower_clothes", "shoes"), ~own), (("hair",), generic.head_blend < NAPE)):
        dressed = np.isin(clone.triangle_regions, [REGIONS.index(name) for name in names])
        worn[np.intersect1d(triangles[dressed], np.flatnonzero(where))] = True
    return worn


def vertex_rgb(generic: GenericHuman, rgb: NDArray[np.uint8]) -> Array:
    """Return (V, 3) the atlas' colour round every vertex, levels."""
    rgb = cv2.GaussianBlur(rgb, (0, 0), len(rgb) / 1024.0)
    return np.asarray(colours_at(rgb, vertex_uv(generic)), np.float64)


def usual_skin(generic: GenericHuman, colours: Array, bare: Flags) -> Array:
    """Return (3,) the person's usual tone, levels: that of limbs and trunk where seen, else of neck, hands, face."""
    hand = _hands(generic)
    places = (~hand & (generic.head_blend < NAPE), generic.region("neck"), hand, generic.region("face"))
    seen = [bare & place for place in places]
    rows = next((each for each in seen if int(each.sum()) >= ENOUGH), bare)
    return np.asarray(np.median(colours[rows], axis=0))


def _hands(generic: GenericHuman) -> Flags:
    return generic.segment("left_hand", "right_hand")


def _skin_coloured(generic: GenericHuman, clone: Clone, bare: Flags) -> Flags:
    """Return which vertices (V,) have the colour of face, neck and hands; labels can take tan cloth for skin."""
    colours = np.maximum(vertex_rgb(generic, clone.atlas.rgb), 1.0)
    known = bare & (generic.region("face") | generic.region("neck") | _hands(generic))
    if not known.any():
        return bare
    tinge = np.log(colours[:, [0, 2]] / colours[:, 1:2])
    light = np.log(colours[:, 1])
    alike = np.abs(tinge - np.median(tinge[known], axis=0)).max(axis=1) < TINGE
    alike &= np.abs(light - np.median(light[known])) < LIGHT
    return np.asarray(alike | (colours[:, 1] < DARKEST))


def _whole(generic: GenericHuman, clone: Clone, graph: SurfaceGraph, bare: Flags) -> Flags:
    """Return bare skin without islands: what hangs together with head or hands, and large patches of limbs."""
    rows = np.flatnonzero(bare)
    count, piece = connected_components(graph.part(rows).lengths, directed=False)
    triangles, _ = generic.triangles()
    own = np.bincount(triangles.ravel(), np.repeat(areas(clone.vertices_m, triangles) / 3.0, 3), len(bare))
    size = np.bincount(piece, own[rows], count)
    names = np.array(generic.segment_names)[generic.vertex_segment[rows]]
    kept = np.zeros(count, dtype=bool)
    kept[piece[(generic.head_blend[rows] >= HEAD) | np.char.endswith(names, "_hand")]] = True
    trunk = np.bincount(piece, np.isin(names, ("torso", "pelvis")) * own[rows], count)
    kept |= (size > PATCH_M2) & (trunk < 0.3 * size)
    found = np.zeros(len(bare), dtype=bool)
    found[rows] = kept[piece]
    return found
