"""The skin that may make the outline at a named point, on the generic human alone."""

from __future__ import annotations

import functools
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.easing import smoothstep
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.articulation.skin_bends import EdgePoint, SkinMetric, skin_metric
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/editing.toml``.
_CALIBRATED: Final = calibrated("editing.places")

Bools = NDArray[np.bool_]

FARTHEST_M = _CALIBRATED.number("farthest_m", "m")
HEAD_SHARE = _CALIBRATED.number("head_share", "share")
LEAST_FREE = _CALIBRATED.number("least_free", "factor")
_OPPOSITE = (("_outer", "_inner"), ("_front", "_back"), ("_left", "_right"))
_NAMED_OPPOSITE = {
    "chest_front": "back",
    "back": "chest_front",
    "belly_front": "waist_back",
    "waist_back": "belly_front",
}


@functools.cache
def generic_metric() -> SkinMetric:
    """Return the metric of the generic human's skin, made once a process."""
    return skin_metric(load_generic().vertices_m.astype(np.float64), body_triangles())


@functools.cache
def free_skin() -> Array:
    """Return the freedom (V,) of each vertex to follow a point on the body's outline; the head follows face photos
    only.
    """
    generic = load_generic()
    free = generic.skin.astype(np.float64)
    if len(generic.head_blend):
        free *= smoothstep(HEAD_SHARE - generic.head_blend, 0.0, HEAD_SHARE)
    return np.asarray(free)


def distance_from(place: EdgePoint) -> Array:
    """Return geodesic distances (V,) on the generic skin from a place, metres, at most ``FARTHEST_M``."""
    start = np.zeros(len(load_generic().vertices_m), dtype=bool)
    start[[place.first, place.second]] = True
    return generic_metric().graph.distance_from(start, FARTHEST_M)


@functools.cache
def distance_from_feature(name: str) -> Array:
    """Return geodesic distances (V,) on the generic skin from a feature's vertex, metres, at most ``FARTHEST_M``."""
    vertex = load_generic().feature(name)
    return distance_from(EdgePoint(vertex, vertex, 0.0))


def opposite_feature(name: str) -> str:
    """Return the feature on the other side of the same limb or of the trunk, "" if there is none."""
    if name in _NAMED_OPPOSITE:
        return _NAMED_OPPOSITE[name]
    for pair in _OPPOSITE:
        for here, there in (pair, pair[::-1]):
            if here in name:
                other = name.replace(here, there)
                return other if other in load_generic().feature_names else ""
    return ""


def mirror_feature(name: str) -> str:
    """Return the same feature on the person's other side, "" if there is none."""
    for here, there in (("_left", "_right"), ("_right", "_left")):
        if name.endswith(here):
            return name.removesuffix(here) + there
    return ""


def half_girth_m(name: str) -> float:
    """Return the geodesic distance on the generic skin from a feature to the one opposite, metres; infinite without
    one.
    """
    other = opposite_feature(name)
    return float(distance_from_feature(other)[load_generic().feature(name)]) if other else float("inf")


@functools.lru_cache(maxsize=256)
def outline_skin(name: str, reach_m: float, both_sides: bool) -> Bools:
    """Return the skin (V,) that may make the outline at a named point.

    Parameters
    ----------
    name : str
        Feature of the generic human.
    reach_m : float
        Along the skin from the feature's own vertex; nothing nearer to the feature opposite belongs to it.
    both_sides : bool
        Whether the twin on the person's other side counts too: in the side photo either leg makes the outline.
    """
    own = distance_from_feature(name)
    allowed = (free_skin() > LEAST_FREE) & (own < reach_m)
    if opposite_feature(name):
        allowed = allowed & (own < distance_from_feature(opposite_feature(name)))
    other = mirror_feature(name) if both_sides else ""
    if other and other != opposite_feature(name):
        allowed = allowed | outline_skin(other, reach_m, False)
    return np.asarray(allowed)
