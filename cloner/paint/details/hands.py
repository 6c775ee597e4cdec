"""Hands and soles finished: unseen skin keeps their own tone; nails and creases are drawn."""

from __future__ import annotations

import functools
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.generic.surfaces import surface_normals
from cloner.geometry.charts.atlas import AtlasMap
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.paint.details.hand_detail import hand_gains
from cloner.paint.lookups.materials import Materials
from cloner.records.arrays import Array

Image = NDArray[np.uint8]

#: A photo with this claim on skin is believed entirely, with half of it not at all.
SURE: Final = 0.5
#: Skin that no photo shows well strays from the hands' tone by no more than this, as logarithms of brightness and of
#: colour; shadows of fingers and borders of photos do.
STRAYS: Final = (0.05, 0.03)
#: From the wrist to so far beyond, metres, the tone goes over into the forearm's.
WRIST_M: Final = 0.045
#: A hand of which more is bare wears no glove, nor does the other: gloves come in pairs.
BARE_FROM: Final = 0.6
#: Skin or shoe that faces down from here on begins to be sole, and is all sole: the normal's height; taste.
UNDER: Final = (-0.5, -0.8)
#: Added to levels before logarithms are taken: black has one, and noise in the dark counts little.
DARK: Final = 4.0


def finish_hands(rgb: Image, claim: Array, kinds: Materials) -> Image:
    """Return the atlas (S, S, 3) with the hands' bare skin smoothed where photos show little, with nails and creases.

    Gloves stay as they are; so does what a photo shows well, but for nails and creases.

    Parameters
    ----------
    claim : (V,)
        How well the photos show each vertex, mirrored ones left aside.
    kinds : Materials
        Tells skin from gloves and cuffs.
    """
    shown = np.clip(2.0 * claim / SURE - 1.0, 0.0, 1.0)
    atlas, gains, _, beyond, left = hand_texels(len(rgb))
    bare, seen = (np.clip(atlas.interpolate(part).astype(np.float64), 0.0, 1.0) for part in (kinds.bare, shown))
    seen *= np.clip(4.0 * bare - 1.5, 0.0, 1.0)  # what shows cloth shows no skin
    if max((bare[hand & (beyond == 1.0)] > 0.5).mean() for hand in (left, ~left)) > BARE_FROM:
        bare = np.maximum(bare, beyond)  # nobody wears a patch on a bare hand; the wrist may hold a cuff
    else:
        bare = np.clip(4.0 * bare - 3.0, 0.0, 1.0)
    if not (bare > 0.5).any():
        return rgb
    out = rgb.copy()
    flat = out.reshape(-1, 3)
    levels = np.log(flat[atlas.texel].astype(np.float64) + DARK)
    calm = _damped_tone(levels, np.maximum(seen, 1.0 - bare * beyond), _reliable_texels(seen, bare > 0.5))
    finished = np.exp(calm + bare[:, None] * gains) - DARK
    flat[atlas.texel] = np.clip(np.rint(finished), 0, 255).astype(np.uint8)
    return out


def finish_soles(rgb: Image, vertices_m: Array) -> Image:
    """Return the atlas (S, S, 3) with soles in their dominant colour, without toes and carpets.

    Parameters
    ----------
    vertices_m : (V, 3)
        The standing person: the undersides of toes lie all around a shoe's tip, where they are no soles.
    """
    atlas = foot_texels(len(rgb))
    down = atlas.interpolate(surface_normals(vertices_m)[:, 1]).astype(np.float64)
    under = np.clip((down - UNDER[0]) / (UNDER[1] - UNDER[0]), 0.0, 1.0)
    out = rgb.copy()
    flat = out.reshape(-1, 3)
    levels = np.log(flat[atlas.texel].astype(np.float64) + DARK)
    calm = _damped_tone(levels, 1.0 - under, under == 1.0)
    flat[atlas.texel] = np.clip(np.rint(np.exp(calm) - DARK), 0, 255).astype(np.uint8)
    return out


def _reliable_texels(seen: Array, skin: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which texels (N,) determine the skin's tone: those that photos show, all if these are few."""
    shown = skin & (seen > 0.5)
    return shown if shown.sum() > 0.1 * skin.sum() else skin


def _damped_tone(levels: Array, kept: Array, telling: NDArray[np.bool_]) -> Array:
    """Return log levels (N, 3) near the tone of the ``telling`` (N,), unchanged where ``kept`` (N,)."""
    tone = np.median(levels[telling], axis=0)
    away = levels - tone
    bright = away.mean(axis=1, keepdims=True)
    light, hue = STRAYS
    calm = tone + light * np.tanh(bright / light) + hue * np.tanh((away - bright) / hue)
    return np.asarray(calm + kept[:, None] * (levels - calm))


@functools.lru_cache(maxsize=2)
def hand_texels(size: int) -> tuple[AtlasMap, Array, Array, Array, NDArray[np.bool_]]:
    """Return the hands' texels of an atlas, their log gains (N, 3), and (N,) nail, beyond the wrist, and left.

    Nail and beyond are parts in 0..1.
    """
    generic = load_generic()
    triangles, _ = generic.triangles()
    hands = generic.region("hand_left") | generic.region("hand_right")
    atlas = generic_atlas(generic, size, wanted=np.asarray(hands[triangles].all(axis=1), np.bool_))
    vertices = generic.vertices_m.astype(np.float64)
    normals = vertex_normals(vertices, triangles.astype(np.int32))
    points, turned = atlas.interpolate(vertices).astype(np.float64), atlas.interpolate(normals).astype(np.float64)
    to_left = np.where(points[:, :1] < 0.0, [[-1.0, 1.0, 1.0]], 1.0)
    turned = unit(turned)
    wrist, knuckle = (generic.joints_m[generic.joint(f"l_{name}")].astype(np.float64) for name in ("wrist", "middle1"))
    way = (points * to_left - wrist) @ (knuckle - wrist) / np.linalg.norm(knuckle - wrist)
    gains, nails = hand_gains(points * to_left, turned * to_left)
    return atlas, gains, nails, np.clip(way / WRIST_M, 0.0, 1.0), points[:, 0] >= 0.0


@functools.lru_cache(maxsize=2)
def foot_texels(size: int) -> AtlasMap:
    """Return the feet's texels of an atlas."""
    generic = load_generic()
    feet = generic.region("foot_left") | generic.region("foot_right")
    return generic_atlas(generic, size, wanted=np.asarray(feet[generic.triangles()[0]].all(axis=1), np.bool_))
