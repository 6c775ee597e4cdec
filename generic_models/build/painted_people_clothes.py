"""Clothes, shoes and hair for random people: smoothed offsets of the skin with hems, and what they are painted with."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
import trimesh
from numpy.typing import NDArray
from painted_heads import Head
from painted_people_bodies import RandomBody, waves
from scipy.sparse import coo_matrix, csr_matrix, diags, vstack

from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.rims import vertex_normals

Array = NDArray[np.float64]
Triangles = NDArray[np.int64]
Tightness = Literal["tight", "regular", "loose"]

TIGHTNESSES: Final[tuple[Tightness, ...]] = ("tight", "regular", "loose")
#: Ease of shirt and trousers where they are widest, metres (issue 4: tight ~3 mm, regular 8-15, loose 20-35).
EASE_M: Final = {"tight": (0.002, 0.004), "regular": (0.008, 0.015), "loose": (0.020, 0.035)}
#: Rounds of smoothing: how far a cloth bridges hollows.
SMOOTHING: Final = {"tight": 6, "regular": 25, "loose": 60}
#: Greatest folds, metres.
FOLDS_M: Final = {"tight": 0.0004, "regular": 0.0018, "loose": 0.0040}
SOLE_M: Final = (0.015, 0.030)
SHOE_M: Final = 0.005  # thickness of a shoe's upper
#: Over what length a hem falls from cloth to skin, metres: about an edge of the fine mesh.
HEM_M: Final = 0.006
PATTERNS: Final = ("plain", "plain", "plain", "stripes", "checks", "print")
SKIN, CLOTH, HAIR, SHOE, ORGAN = range(5)  # kinds of vertices


@dataclass(frozen=True, slots=True)
class Wardrobe:
    """What a person wears; lengths in metres.

    Attributes
    ----------
    tightness : "tight", "regular" or "loose"
    shirt_m, trousers_m : float
        Ease where they are widest.
    sleeve, leg : float
        Where they end, 0 shoulder or hip, 1 wrist or ankle.
    sole_m : float
    hair : "short", "long" or "bald"
    hair_m : float
        Height of the hair above the scalp.
    alike : float
        How near the trousers' colour is to the shirt's, 0 any to 1 the same.
    """

    tightness: Tightness
    shirt_m: float
    trousers_m: float
    sleeve: float
    leg: float
    sole_m: float
    hair: str
    hair_m: float
    alike: float


@dataclass(frozen=True, slots=True, eq=False)
class Dressed:
    """A dressed person in the rest pose: a fine mesh that the coarse body carries.

        Attributes
        ----------
        vertices_m : (N, 3) float64
        triangles : (T, 3) int64
        kind : (N,) int8
            #: Over what length a hem falls from cloth to skin, metres: about an edge of the fine mesh.
    HEM_M: Final = 0.006
    PATTERNS: Final = ("plain", "plain", "plain", "stripes", "checks", "print")
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


def random_wardrobe(tightness: Tightness, rng: np.random.Generator, *, alike: float = 0.0) -> Wardrobe:
    """Return random clothes of a tightness; ``alike`` draws trousers and shirt together in colour."""
    ease = rng.uniform(*EASE_M[tightness], 2)
    sleeve = rng.choice([rng.uniform(0.28, 0.42), rng.uniform(0.88, 0.98)])
    leg = rng.uniform(0.97, 1.02) if rng.random() < 0.85 else rng.uniform(0.42, 0.55)
    hair = str(rng.choice(["short", "long", "bald"], p=[0.62, 0.30, 0.08]))
    hair_m = float(rng.uniform(0.004, 0.025)) if hair != "bald" else 0.0
    sole = float(rng.uniform(*SOLE_M))
    return Wardrobe(tightness, *map(float, ease), float(sleeve), float(leg), sole, hair, hair_m, alike)


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
        away[hairy] += (wardrobe.hair_m * _eased(scalp[hairy]) * curls)[:, None] * fine_normals[hairy]
    meshes = [(fine + away, painter.fine, kind, colours, painter.matrix)]
    meshes += _shoes(generic, body, normals, wardrobe, rng)
    if wardrobe.hair == "long":
        meshes.append(_long_hair(generic, body, normals, colours[scalp > 0.9].mean(axis=0), rng))
    return _joined(meshes, wardrobe)


def _joined(meshes: list[tuple[Array, Triangles, NDArray[np.int8], Array, csr_matrix]], wardrobe: Wardrobe) -> Dressed:
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


def random_colour(rng: np.random.Generator) -> Array:
    """Return an sRGB colour 0..1 as clothes have: mostly greyish."""
    return np.clip(rng.uniform(0.06, 0.90) + rng.choice([0.05, 0.15]) * rng.normal(size=3), 0.03, 0.95)


def cloth_colours(points_m: Array, base: Array, rng: np.random.Generator, *, patterns: tuple[str, ...]) -> Array:
    """Return (N, 3) colours of one cloth: a colour with wear, and perhaps stripes, checks or a print."""
    shade = 1.0 + 0.02 * waves(points_m, (0.015, 0.05), 10, rng) + 0.05 * waves(points_m, (0.1, 0.4), 8, rng)
    other = np.clip(base + rng.choice([-1.0, 1.0]) * rng.uniform(0.12, 0.4), 0.03, 0.97)
    width = rng.uniform(0.02, 0.06)
    rows, columns = (np.tanh(3.0 * np.sin(points_m[:, axis] / width * np.pi)) for axis in (1, 0))
    spot = rng.uniform(0.05, 0.1) - np.hypot(points_m[:, 0], points_m[:, 1] - np.quantile(points_m[:, 1], 0.7))
    share = {
        "plain": np.zeros(len(points_m)),
        "stripes": 0.5 + 0.5 * rows,
        "checks": 0.5 + 0.5 * rows * columns,
        "print": np.clip(0.5 + spot / HEM_M, 0.0, 1.0) * (points_m[:, 2] > 0.0),
    }[str(rng.choice(patterns))]
    return np.asarray((base + share[:, None] * (other - base)) * shade[:, None])


def _eased(mask: Array) -> Array:
    share = np.clip((mask - 0.4) / 0.6, 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def _shoes(
    generic: GenericHuman, body: RandomBody, normals: Array, wardrobe: Wardrobe, rng: np.random.Generator
) -> list[tuple[Array, Triangles, NDArray[np.int8], Array, csr_matrix]]:
    """Return both shoes: hulls of heel and forefoot on a flat sole."""
    meshes = []
    upper, sole = (np.clip(rng.uniform(0.08, 0.9) + rng.normal(0.0, 0.06, 3), 0.03, 0.95) for _ in range(2))
    high = rng.uniform(0.075, 0.11) * body.stature_m / 1.7
    for side in ("left", "right"):
        foot = np.flatnonzero(generic.vertex_segment == generic.segment_names.index(f"{side}_foot"))
        points = body.vertices_m[foot] + SHOE_M * normals[foot]
        length = float(np.ptp(points[:, 2]))
        share = (points[:, 2] - points[:, 2].min()) / length
        points[:, 2] += 0.012 * np.clip(share - 0.6, 0.0, 1.0) / 0.4
        low = points[points[:, 1] < 0.035]
        centre = low.mean(axis=0)
        flat = centre + (low - centre) * [1.05, 0.0, 1.02]
        for part in ((share < 0.62) & (points[:, 1] < high), share > 0.30):
            near = flat[np.isin(np.flatnonzero(points[:, 1] < 0.035), np.flatnonzero(part))]
            slab = [near * [1, 0, 1] + [0, at, 0] for at in (-wardrobe.sole_m, 0.006)]
            hull = trimesh.convex.convex_hull(np.vstack([points[part & (points[:, 1] < high)], *slab]))
            hull = hull.subdivide_to_size(0.012)
            vertices, triangles = np.asarray(hull.vertices), np.asarray(hull.faces, dtype=np.int64)
            colours = np.where(vertices[:, 1:2] < 0.002, sole, upper)
            heel = np.full(len(vertices), generic.feature(f"heel_{side}"))
            meshes.append(
                (vertices, triangles, np.full(len(vertices), SHOE, np.int8), colours, _following(generic, heel))
            )
    return meshes


def _long_hair(
    generic: GenericHuman, body: RandomBody, normals: Array, colour: Array, rng: np.random.Generator
) -> tuple[Array, Triangles, NDArray[np.int8], Array, csr_matrix]:
    """Return hair that falls behind the ears to neck or shoulders, as one hull that follows the skull."""
    scalp = np.flatnonzero(generic.region("scalp"))
    ears = float(body.joints_m[generic.joint("skullbase"), 2])
    behind = scalp[body.vertices_m[scalp, 2] < ears + 0.035]
    top = body.vertices_m[behind] + 0.015 * normals[behind]
    nape, chin = body.vertices_m[generic.feature("nape")], body.vertices_m[generic.feature("chin_bottom")]
    low = chin[1] + rng.uniform(-0.9, 0.3) * (chin[1] - nape[1])
    half = float(np.abs(top[:, 0]).max()) * rng.uniform(0.75, 1.0)
    back = min(float(top[:, 2].min()), nape[2] - 0.005)
    ends = np.array(
        [[x * half, low, back + depth] for x in np.linspace(-1, 1, 7) for depth in (0.0, 0.05 + 0.02 * abs(x))]
    )
    hull = trimesh.convex.convex_hull(np.vstack([top, ends])).subdivide_to_size(0.012)
    vertices, triangles = np.asarray(hull.vertices), np.asarray(hull.faces, dtype=np.int64)
    vertices = vertices + 0.002 * waves(vertices, (0.02, 0.06), 12, rng)[:, None]
    colours = np.clip(colour * (1.0 + 0.15 * waves(vertices * [1, 0.1, 1], (0.006, 0.02), 12, rng))[:, None], 0, 1)
    top_row = np.full(len(vertices), generic.feature("head_top"))
    return vertices, triangles, np.full(len(vertices), HAIR, np.int8), colours, _following(generic, top_row)


def _following(generic: GenericHuman, rows: NDArray[np.integer]) -> csr_matrix:
    """Return the matrix of vertices that move as one coarse vertex each."""
    ones = np.ones(len(rows))
    return csr_matrix((ones, (np.arange(len(rows)), rows)), shape=(len(rows), len(generic.vertices_m)))
