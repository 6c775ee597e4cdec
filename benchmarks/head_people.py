"""Known heads for the head benchmark: random ones of the generic family and bent out of it, photographed twice."""

from __future__ import annotations

import functools
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.distance import cdist

import cloner_models
from cloner.detectors.face.face_net import load_face_net
from cloner.evaluate.measures.surfaces import sample_surface
from cloner.evaluate.truths.truth import TruthSurface
from cloner.frames import FILM_LONG_SIDE_MM, ViewId
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman, load_generic
from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.views import Camera

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "generic_models" / "build"))

Array = NDArray[np.float64]

WIDTH, HEIGHT = 900, 1200
#: Share of the picture's height that a head fills.
FILLED: Final = (0.42, 0.6)
DISTANCE_M: Final = (0.6, 2.0)
#: Largest turn about the vertical, nod and tilt, degrees: nobody stands at exactly 0 and 90.
TURN_DEG: Final = (10.0, 7.0, 4.0)
#: Head size grows with this power of the stature (correlation 0.3 to 0.4, spread 3.9 % of stature: ANSUR II).
SIZE_BY_STATURE: Final = 0.35
#: Brings eye distance, height of the face and length of the skull of these heads to people's on the average (120 heads
#: against ANSUR II: -7, +3 and +3 %; their own variety of 7, 5 and 5 % is no less than people's 5, 5 and 4).
USUAL_SIZE: Final = 1.012
#: A bend is a sum of Gaussian hills; amplitude and radii in metres (taste: 1.5 to 2 mm of face surface).
HILLS, HILL_M, HILL_RADII_M = 12, 0.0016, (0.014, 0.035)
#: Variety of build and face, in the standard deviations of the two bases, which overlap.
BUILD, FACE = 0.5, 0.7
LIGHTS: Final = ("frontal", "side", "above")
SAMPLES: Final = 6000
#: What is farther from the nose tip is no business of a face, metres.
WITHIN_M: Final = 0.16
#: Points of the canonical face beyond this from the middle are the outline of a face in a picture, metres.
RIM_M: Final = 0.055
#: Only what is larger than this of the canonical face is followed (its wings lie 3 mm before people's, its lower lip is
#: squashed by as much: it is a mask, no mean of scans), and how far from it skin follows still, metres.
SMOOTH_M, FADE_M = 0.012, 0.03


@dataclass(frozen=True, slots=True, eq=False)
class KnownHead:
    """One head, what a cloner may see of it, and what is true.

    Attributes
    ----------
    name : str
    photos, person
        All that the product gets.
    truth : TruthSurface
    vertices_m : (V, 3) float64 or None
        The truth in the generic's own topology, where it has that.
    views : mapping of ViewId to Camera
        The true cameras in the truth's frame.
    about : mapping
        Light, distances, turns: for the table of errors.
    """

    name: str
    photos: PhotoSet
    person: Person
    truth: TruthSurface
    vertices_m: Array | None
    views: Mapping[ViewId, Camera]
    about: Mapping[str, float | str]


def hills(points: Array, triangles_around: Array, rng: np.random.Generator) -> Array:
    """Return a smooth random displacement (N, 3) that no target of the generic family knows, nearly symmetric."""
    centres = triangles_around[rng.integers(len(triangles_around), size=HILLS)]
    radii = rng.uniform(*HILL_RADII_M, size=HILLS)
    heights = rng.normal(size=(HILLS, 3)) * HILL_M
    out = np.zeros_like(points)
    for centre, radius, height in zip(centres, radii, heights, strict=True):
        for sign, share in ((1.0, 1.0), (-1.0, rng.uniform(0.6, 1.0))):
            mirrored = np.array([sign, 1.0, 1.0])
            away = np.linalg.norm(points - centre * mirrored, axis=1)
            out += share * np.exp(-0.5 * (away / radius) ** 2)[:, None] * height * mirrored
    return out


@functools.cache
def usual_way() -> Array:
    """Return how head vertices (H, 3) move from the generic's mean face to people's, metres at the generic's stature.

    People do not scatter around the generic's mean face: on scans it errs by 1.97 mm where the scans' own mean errs by
    1.4 and the canonical face of the face net by 1.38 (shared facts). Heads around the generic's mean would flatter it
    as a baseline, and a clone that never leaves it.
    """
    generic = load_generic()
    place = Path(cloner_models.__file__).parent / "nets" / "canonical_face.npz"
    with np.load(place, allow_pickle=False) as archive:
        canonical = archive["vertices_cm"].astype(np.float64)
    places = load_face_net().places.at(generic.vertices_m.astype(np.float64))
    scale, rotation, shift = similarity_alignment(canonical, places)
    inner = np.abs(places[:, 0]) < RIM_M
    way = (scale * canonical @ rotation.T + shift - places)[inner]
    both = np.vstack([places[inner], places[inner] * [-1.0, 1.0, 1.0]])
    head = generic.vertices_m[generic.head_vertices].astype(np.float64)
    away = cdist(head, both)
    nearest = away.min(axis=1, keepdims=True)
    share = np.exp(-0.5 * (away**2 - nearest**2) / SMOOTH_M**2)
    share /= share.sum(axis=1, keepdims=True)
    moved = share @ np.vstack([way, way * [-1.0, 1.0, 1.0]]) * np.exp(-0.5 * (nearest / FADE_M) ** 2)
    moved *= generic.head_blend[generic.head_vertices, None]
    for part in ("eye_left", "eye_right"):
        rows = np.isin(generic.head_vertices, generic.part(part))
        moved[rows] = moved[rows].mean(axis=0)
    return np.asarray(moved)


def random_face(generic: GenericHuman, rng: np.random.Generator, *, bent: bool) -> tuple[Array, float]:
    """Return vertices (V, 3) and stature of a random person."""
    stature = float(np.clip(rng.normal(1.70, 0.09), 1.50, 1.95))
    vertices, joints = generic.shape(BUILD * rng.normal(size=len(generic.shape_basis)), stature)
    scale = stature / GENERIC_STATURE_M
    head = generic.head_vertices
    vertices[head] += scale * np.tensordot(FACE * rng.normal(size=len(generic.face_basis)), generic.face_basis, axes=1)
    vertices[head] += scale * usual_way()
    if bent:
        _bend(generic, vertices, rng)
    size = USUAL_SIZE * (stature / GENERIC_STATURE_M) ** (SIZE_BY_STATURE - 1.0)
    pivot = joints[generic.joint("skullbase")]
    return pivot + size * (vertices - pivot), stature


def _bend(generic: GenericHuman, vertices: Array, rng: np.random.Generator) -> None:
    """Bend a head in place; eyeballs are carried along whole."""
    head = generic.head_vertices
    face = np.flatnonzero(generic.region("face"))
    moved = hills(vertices[head], vertices[face], rng) * generic.head_blend[head, None]
    row = np.full(len(vertices), -1)
    row[head] = np.arange(len(head))
    for part in ("eye_left", "eye_right"):
        rows = row[generic.part(part)]
        moved[rows] = moved[rows].mean(axis=0)
    vertices[head] += moved


def towards(target: Array, azimuth_deg: float, distance_m: float, focal_px: float, rng: np.random.Generator,
            turn_deg: tuple[float, float, float] = TURN_DEG) -> Camera:  # fmt: skip
    """Return a camera about the head at an azimuth (positive: the person's left), turned by up to ``turn_deg``."""
    yaw, nod, tilt = np.radians(rng.uniform(-1.0, 1.0, 3) * turn_deg)
    yaw += np.radians(azimuth_deg)
    c, s, cn, sn = np.cos(yaw), np.sin(yaw), np.cos(nod), np.sin(nod)
    ct, st = np.cos(tilt), np.sin(tilt)
    level = np.array([[c, 0, -s], [0, -1, 0], [-s, 0, -c]])
    rotation = (
        np.array([[ct, -st, 0], [st, ct, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, cn, -sn], [0, sn, cn]]) @ level
    )
    pose = np.eye(4)
    pose[:3, :3] = rotation
    pose[:3, 3] = np.array([*rng.uniform(-0.02, 0.02, 2), distance_m]) - rotation @ target
    return Camera(WIDTH, HEIGHT, focal_px, pose)


def lights_of(kind: str, rng: np.random.Generator) -> list[tuple[float, Array]]:
    """Return a main and a fill light."""
    main = {"frontal": [0.1, 0.3, 1.0], "side": [1.0, 0.4, 0.6], "above": [0.2, 1.4, 0.7]}[kind]
    sign = np.array([rng.choice([-1.0, 1.0]), 1.0, 1.0])
    return [(2.3, np.array(main) * sign), (0.9, np.array([-0.6, 0.2, 0.9]) * sign)]


def known_head(seed: int, *, bent: bool) -> KnownHead:
    """Photograph one random head from the front and from one side."""
    from painted_heads import photograph  # needs EGL: only where something is drawn

    rng, generic = np.random.default_rng(seed), load_generic()
    vertices, stature = random_face(generic, rng, bent=bent)
    painted = _painted()
    colours = painted.colours(rng)
    light = LIGHTS[seed % len(LIGHTS)]
    distance = float(rng.uniform(*DISTANCE_M))
    middle = vertices[[generic.feature("nasion"), generic.feature("chin_front")]].mean(axis=0) - [0.0, 0.01, 0.08]
    tall = float(vertices[generic.feature("vertex_top"), 1] - vertices[generic.feature("chin_bottom"), 1])
    focal = float(rng.uniform(*FILLED)) * HEIGHT * distance / tall
    side = float(rng.choice([-90.0, 90.0]))
    exif = focal * FILM_LONG_SIDE_MM / HEIGHT if rng.random() < 0.5 else None
    photos, views = {}, {}
    for view, azimuth in ((ViewId.FACE_FRONT, 0.0), (ViewId.FACE_SIDE, side)):
        camera = towards(middle, azimuth, distance * float(rng.uniform(0.92, 1.08)), focal, rng)
        picture = photograph(painted, vertices, camera, rng, lights=lights_of(light, rng), colours=colours)
        photos[view] = Photo(view, picture, exif, "", f"{view.value}.jpg")
        views[view] = camera
    name = f"{seed:03d}_{'bent' if bent else 'family'}"
    about = {"light": light, "distance_m": distance, "exif": "yes" if exif else "no", "side": side}
    return KnownHead(name, PhotoSet(photos), Person(name, "", stature), family_truth(generic, vertices, rng),
                     vertices, views, about)  # fmt: skip


@functools.cache
def _painted() -> Any:
    """Return the paintable generic head, made once a process (2 s)."""
    from painted_heads import Head

    return Head(load_generic(), below_m=0.22, aside_m=0.3)


def family_truth(generic: GenericHuman, vertices: Array, rng: np.random.Generator) -> TruthSurface:
    """Return the rulers' truth of a head in the generic's own topology."""
    from cloner.evaluate.figures.skins import skin_triangles

    skin = skin_triangles(generic)
    tip = vertices[generic.feature("nose_tip")]
    near = np.linalg.norm(vertices - tip, axis=1) < WITHIN_M
    face = skin[near[skin].all(axis=1)]
    points, normals, _ = sample_surface(vertices, face, SAMPLES, rng=rng)
    organs = np.flatnonzero(generic.vertex_part != generic.part_names.index("body"))
    organs = organs[near[organs]]
    marks = {n: vertices[generic.feature(n)] for n in generic.feature_names}
    return TruthSurface(
        np.vstack([points, vertices[organs]]),
        np.vstack([normals, np.tile([0.0, 0.0, 1.0], (len(organs), 1))]),
        np.array(["bare"] * len(points) + ["organ"] * len(organs)),
        {}, marks, vertices, face,
    )  # fmt: skip
