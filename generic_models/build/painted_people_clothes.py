"""Clothes of random people: smoothed offsets of the skin with hems, and how a whole dressed person is put together."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from painted_heads import Head
from painted_people_bodies import RandomBody, waves
from painted_people_shoes import Piece, long_hair, shoes
from painted_people_wardrobe import (
    CLOTH,
    FOLDS_M,
    HAIR,
    HEM_M,
    ORGAN,
    PATTERNS,
    SHOE,
    SKIN,
    SMOOTHING,
    TIGHTNESSES,
    Tightness,
    Wardrobe,
    cloth_colours,
    random_colour,
    random_wardrobe,
)
from scipy.sparse import coo_matrix, csr_matrix, diags, vstack

from cloner.easing import smoothstep
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.outlines.silhouette import vertex_normals

__all__ = [
    "CLOTH", "HAIR", "ORGAN", "SHOE", "SKIN", "TIGHTNESSES", "Dressed", "Tightness", "Wardrobe", "dress",
    "random_wardrobe", "whole_human",
]  # fmt: skip

Array = NDArray[np.float64]
Triangles = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Dressed:
    """A dressed person in the rest pose: a fine mesh that the coarse body carries.

    Attributes
    ----------
    vertices_m : (N, 3) float64
    triangles : (T, 3) int64
    kind : (N,) int8
        SKIN, CLOTH, HAIR, SHOE or ORGAN.
    colours : (N, 3) float64, sRGB 0..1
    carry : (N, V) sparse
        Shares of the coarse vertices whose motion each fine vertex follows.
    wardrobe : Wardrobe
    """

    vertices_m: Array
    triangles: Triangles
    kind: NDArray[np.int8]
    colours: Array
    carry: csr_matrix
    wardrobe: Wardrobe


@functools.cache
def whole_human(splits: int) -> Head:
    """Return the generic human's triangles, each split in four some times, with the face's paint."""
    return Head(load_generic(), below_m=np.inf, aside_m=np.inf, splits=splits)


@functools.cache
def _near() -> csr_matrix:
    """Return the (V, V) matrix that takes the mean of a vertex's neighbours."""
    generic = load_generic()
    triangles, _ = generic.triangles()
    count = len(generic.vertices_m)
    edges = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    edges = np.unique(np.concatenate([edges, edges[:, ::-1]]), axis=0)
    links = coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(count, count)).tocsr()
    return csr_matrix(diags(1.0 / np.maximum(np.asarray(links.sum(axis=1)).ravel(), 1.0)) @ links)


def dress(body: RandomBody, wardrobe: Wardrobe, rng: np.random.Generator, *, splits: int = 2) -> Dressed:
    """Return the dressed person; ``rng`` draws colours, folds and the cut, ``splits`` is the mesh's fineness."""
    generic, painter = load_generic(), whole_human(splits)
    triangles, _ = generic.triangles()
    normals = vertex_normals(body.vertices_m, triangles)
    shirt, trousers = _cloths(generic, body, wardrobe, normals)
    fine = painter.matrix @ body.vertices_m
    covered = _covered(generic, painter, body, fine, wardrobe, rng)
    part = (painter.matrix @ np.eye(len(generic.part_names))[generic.vertex_part])[:, 0] > 0.99
    kind = np.where(part, SKIN, ORGAN).astype(np.int8)
    fine_normals = painter.matrix @ normals
    folds = FOLDS_M[wardrobe.tightness] * waves(fine, (0.04, 0.15), 20, rng)
    away = np.zeros_like(fine)
    for name, cloth, rumpled in (("trousers", trousers, 0.6), ("shirt", shirt, 1.0)):
        worn = (painter.matrix @ cloth) + (rumpled * folds)[:, None] * fine_normals
        away += covered[name][:, None] * (worn - away)  # soft at the hem, which mesh edges would make jagged
        kind[covered[name] > 0.5] = CLOTH
    colours = _colours(painter, covered, fine, wardrobe, rng)
    scalp = painter.masks["scalp"]
    if wardrobe.hair != "bald":
        hairy = scalp > 0.5
        kind[hairy & (kind == SKIN)] = HAIR
        curls = 1.0 + rng.uniform(0.03, 0.16) * waves(fine[hairy], (0.01, 0.04), 16, rng)
        away[hairy] += (wardrobe.hair_m * smoothstep(scalp[hairy], 0.4) * curls)[:, None] * fine_normals[hairy]
    meshes = [(fine + away, painter.fine, kind, colours, painter.matrix)]
    meshes += shoes(generic, body, normals, wardrobe, rng)
    if wardrobe.hair == "long":
        meshes.append(long_hair(generic, body, normals, colours[scalp > 0.9].mean(axis=0), rng))
    return _joined(meshes, wardrobe)


def _joined(meshes: list[Piece], wardrobe: Wardrobe) -> Dressed:
    starts = np.cumsum([0, *(len(mesh[0]) for mesh in meshes[:-1])])
    return Dressed(
        np.vstack([mesh[0] for mesh in meshes]),
        np.vstack([mesh[1] + start for mesh, start in zip(meshes, starts, strict=True)]),
        np.concatenate([mesh[2] for mesh in meshes]),
        np.vstack([mesh[3] for mesh in meshes]),
        csr_matrix(vstack([mesh[4] for mesh in meshes])),
        wardrobe,
    )


def _weights(generic: GenericHuman, *names: str) -> Array:
    """Return (V,) the summed weights of segments; a name without a side means both sides."""
    rows = [k for k, own in enumerate(generic.segment_names) if own in names or own.split("_", 1)[-1] in names]
    return np.asarray(generic.segment_weights[:, rows].sum(axis=1), dtype=np.float64)


def _cloths(generic: GenericHuman, body: RandomBody, wardrobe: Wardrobe, normals: Array) -> tuple[Array, Array]:
    """Return (V, 3) displacements of shirt and trousers; both are defined beyond their hems."""
    height = body.vertices_m[:, 1]
    legs = _weights(generic, "thigh", "calf", "pelvis")
    arms = _weights(generic, "upper_arm", "forearm")
    chest = float(body.vertices_m[generic.feature("armpit_left"), 1])
    crotch = float(body.vertices_m[generic.feature("crotch"), 1])
    navel = float(body.vertices_m[generic.feature("waist_front"), 1])
    hang = np.interp(height, [navel, chest, chest + 0.12], [1.0, 0.65, 0.30])  # a shirt hangs from the shoulders
    shirt = wardrobe.shirt_m * ((1.0 - arms) * hang + 0.65 * arms)
    trousers = wardrobe.trousers_m * np.interp(height, [crotch, navel], [1.0, 0.35])
    under = np.clip(legs, 0.0, 1.0) * (0.002 + np.interp(height, [crotch, navel], [0.8, 0.3]) * wardrobe.trousers_m)
    body_part = generic.vertex_part == generic.part_names.index("body")
    rounds = SMOOTHING[wardrobe.tightness]
    wrapped = [
        _wrapped(body.vertices_m, normals, ease, rounds, body_part) for ease in (np.maximum(shirt, under), trousers)
    ]
    return wrapped[0], wrapped[1]


def _wrapped(vertices_m: Array, normals: Array, ease: Array, rounds: int, part: NDArray[np.bool_]) -> Array:
    """Return (V, 3) displacement of a cloth that bridges hollows and never comes nearer than half its ease."""
    cloth = vertices_m + ease[:, None] * normals
    for _ in range(rounds):
        cloth = np.where(part[:, None], 0.5 * cloth + 0.5 * (_near() @ cloth), cloth)
        short = np.maximum(0.5 * ease + 0.001 - np.einsum("va,va->v", cloth - vertices_m, normals), 0.0)
        cloth = cloth + short[:, None] * normals
    return np.asarray(cloth - vertices_m)


def _covered(
    generic: GenericHuman, painter: Head, body: RandomBody, fine: Array, wardrobe: Wardrobe, rng: np.random.Generator
) -> dict[str, Array]:
    """Return how much the shirt and the trousers cover, (N,) 0..1 each; hems run a little uneven."""
    point = {
        name: body.vertices_m[generic.feature(name)] for name in ("nape", "neck_front_base", "crotch", "waist_front")
    }
    joint = {
        name: body.joints_m[generic.joint(name)] for name in ("l_shoulder", "l_elbow", "l_wrist", "l_hip", "l_ankle")
    }
    arm = painter.matrix @ _weights(generic, "upper_arm", "forearm", "hand") > 0.5
    head = painter.matrix @ _weights(generic, "head") > 0.6
    organ = (painter.matrix @ (generic.vertex_part != 0).astype(np.float64)) > 0.0
    mirrored = np.abs(fine[:, :1]) * [1.0, 0.0, 0.0] + fine * [0.0, 1.0, 1.0]
    upper, fore = joint["l_elbow"] - joint["l_shoulder"], joint["l_wrist"] - joint["l_elbow"]
    length = np.linalg.norm(upper) + np.linalg.norm(fore)
    along = np.clip((mirrored - joint["l_shoulder"]) @ upper / np.linalg.norm(upper), -1.0, np.linalg.norm(upper))
    along += np.maximum((mirrored - joint["l_elbow"]) @ fore / np.linalg.norm(fore), 0.0)
    uneven = 0.004 * waves(fine, (0.05, 0.2), 8, rng)
    front = np.clip((fine[:, 2] - point["nape"][2]) / (point["neck_front_base"][2] - point["nape"][2]), 0.0, 1.0)
    opening = rng.uniform(0.0, 0.05) * front * np.clip(1.0 - np.abs(fine[:, 0]) / 0.09, 0.0, 1.0)
    collar = point["nape"][1] + front * (point["neck_front_base"][1] - point["nape"][1]) + 0.012 - opening
    hem = point["crotch"][1] + rng.uniform(0.02, 0.14) + uneven
    waistband = point["waist_front"][1] - 0.03
    cuff = joint["l_hip"][1] + wardrobe.leg * (joint["l_ankle"][1] - 0.01 - joint["l_hip"][1]) + uneven
    shirt = np.where(arm, wardrobe.sleeve * length - along - uneven, np.minimum(fine[:, 1] - hem, collar - fine[:, 1]))
    trousers = np.minimum(waistband - fine[:, 1], fine[:, 1] - cuff)
    inside = {"shirt": np.where(head | organ, -1.0, shirt), "trousers": np.where(arm | organ, -1.0, trousers)}
    return {name: np.clip(0.5 + depth_m / HEM_M, 0.0, 1.0) for name, depth_m in inside.items()}


def _colours(
    painter: Head, covered: dict[str, Array], fine: Array, wardrobe: Wardrobe, rng: np.random.Generator
) -> Array:
    """Return (N, 3) sRGB colours 0..1 of skin, face, hair and clothes."""
    colours = painter.colours(rng)
    shirt, trousers = random_colour(rng), random_colour(rng)
    trousers = wardrobe.alike * shirt + (1.0 - wardrobe.alike) * trousers
    for name, base, plain in (("trousers", trousers, True), ("shirt", shirt, wardrobe.alike > 0.0)):
        worn = cloth_colours(fine, base, rng, patterns=("plain",) if plain else PATTERNS)
        colours += covered[name][:, None] * (worn - colours)
    return np.clip(colours, 0.0, 1.0)
