"""Known people for the hair benchmark: random ones in six kinds of hair, and the visitors; five photographs each."""

from __future__ import annotations

import functools
import hashlib
import itertools
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Final

import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.sparse import csr_matrix, vstack

from cloner.errors import ClonerError
from cloner.evaluate.truths.truth import read_truth
from cloner.frames import BODY_VIEWS, FACE_VIEWS, ViewId
from cloner.generic.layers import Layer
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.project.folder import load_photos
from cloner.records.bodies import PosedView
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.views import Camera
from cloner.render import draw

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "generic_models" / "build"))

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]

KINDS: Final = ("short", "full", "long", "tied", "bald", "cap")
BACKGROUNDS: Final = ("plain", "cluttered", "plain", "plain", "cluttered", "low_contrast")
BODY_PX, FACE_PX = (1200, 1800), (1200, 1600)
FACE_M: Final = 1.2
#: Height of hair over the scalp, metres.
SHORT_M, FULL_M = (0.004, 0.022), (0.028, 0.060)
#: Share of the hair's colour from which skin looks like hair.
FOOT: Final = 0.45


@dataclass(frozen=True, slots=True, eq=False)
class HairCase:
    """One person, what a cloner may see, and what is true of it.

    Attributes
    ----------
    name : str
    photos, person
        All that the product gets.
    hair, mask : mapping of ViewId to (H, W) bool
        Pixels whose nearest surface is hair or cap, and those of the whole person.
    skin_m, joints_m : (V, 3) and (94, 3) float64 or None
        The naked person at rest in the generic's topology, where the truth has that.
    views : mapping of ViewId to PosedView
        True poses and cameras of the same.
    """

    name: str
    photos: PhotoSet
    person: Person
    hair: Mapping[ViewId, Bools]
    mask: Mapping[ViewId, Bools]
    skin_m: Array | None = None
    joints_m: Array | None = None
    views: Mapping[ViewId, PosedView] = field(default_factory=dict)


def random_case(seed: int) -> HairCase:
    """Return a random person; the kind of hair goes round with the seed."""
    from painted_faces import Sitter, photograph_face  # they draw by EGL
    from painted_people import HEADING_DEG, as_photo, posed, take
    from painted_people_bodies import random_body, random_rotations
    from painted_people_clothes import dress, random_wardrobe

    generic, kind, background = load_generic(), KINDS[seed % len(KINDS)], BACKGROUNDS[seed // 6 % len(BACKGROUNDS)]
    rng = np.random.default_rng([seed, 40])
    body = random_body(generic, rng)
    wardrobe = random_wardrobe("regular", rng)
    height = float(rng.uniform(*(FULL_M if kind == "full" else SHORT_M)))
    own = {"bald": "bald", "long": "long"}.get(kind, "short")
    dressed = dress(body, replace(wardrobe, hair=own, hair_m=0.0 if own == "bald" else height), rng)
    for piece in _pieces(generic, body, dressed, kind, rng):
        dressed = _with(dressed, piece)
    dressed = _shaved(dressed) if kind == "bald" else dressed
    hairy = _hairy(dressed)
    side, exif = float(rng.choice([90.0, -90.0])), bool(rng.random() < 0.5)
    photos, hair, mask, views = {}, {}, {}, {}
    for view, azimuth in zip(BODY_VIEWS, (0.0, side, 180.0), strict=True):
        rotations = random_rotations(generic, body.joints_m, rng)
        heading = azimuth + rng.uniform(-HEADING_DEG, HEADING_DEG)
        shot = take(view.value, body, dressed, rotations, heading, background, BODY_PX, rng, seed)  # type: ignore[arg-type]
        photos[view], mask[view] = as_photo(shot, view, exif=exif), shot.mask
        views[view] = PosedView(view, shot.camera, rotations)
        hair[view] = shown_hair(hairy, dressed, shot.dressed_m, shot.camera)
    rotations = 0.4 * random_rotations(generic, body.joints_m, rng)
    joints, naked, worn = posed(dressed, body, rotations)
    sitter = Sitter(seed, body, dressed, joints, naked, worn, ())
    for view in FACE_VIEWS:
        chosen: Any = {"background": background, "facing": -1 if side > 0 else 1, "light": "soft"}
        face = photograph_face(sitter, view, distance_m=FACE_M, size_px=FACE_PX, **chosen)
        digest = hashlib.sha256(face.rgb.tobytes()).hexdigest()
        views[view] = PosedView(view, face.camera, rotations)
        photos[view] = Photo(view, face.rgb, None, digest, f"{view.value}.jpg")
        hair[view], mask[view] = shown_hair(hairy, dressed, worn, face.camera), face.mask
    name = f"{seed:03d}_{kind}"
    told = Person(name, "", body.stature_m)
    return HairCase(name, PhotoSet(photos), told, hair, mask, body.vertices_m, body.joints_m, views)


def shown_hair(hairy: Bools, dressed: Any, worn_m: Array, camera: Camera) -> Bools:
    """Return the (H, W) pixels whose nearest surface is hair or cap."""
    from painted_people_pictures import rendered

    white = np.repeat(hairy[:, None], 3, axis=1).astype(float)
    return np.asarray(rendered(worn_m, dressed.triangles, white, camera)[..., 0] > 0.5)


def _hairy(dressed: Any) -> Bools:
    """Return (N,) which vertices look like hair: also the foot of its step over the skin, which is painted so."""
    from painted_people_clothes import HAIR, SKIN, whole_human

    hairy = np.asarray(dressed.kind == HAIR)
    if dressed.wardrobe.hair != "bald":
        scalp = whole_human(2).masks["scalp"]
        hairy[: len(scalp)] |= (scalp > FOOT) & (dressed.kind[: len(scalp)] == SKIN)
    return hairy


def _shaved(dressed: Any) -> Any:
    """Return a bald person with the scalp in the skin's colour: the painter gives it stubble."""
    from painted_people_clothes import whole_human

    painter = whole_human(2)
    scalp, forehead = painter.masks["scalp"], painter.front & (painter.masks["scalp"] <= 0.0)
    forehead &= (painter.masks["lips"] + painter.masks["lids"] + painter.masks["nostrils"]) <= 0.0
    colours = dressed.colours.copy()
    skin = np.median(colours[: len(scalp)][forehead], axis=0)
    colours[: len(scalp)][scalp > 0.0] = skin
    return replace(dressed, colours=colours)


def _with(dressed: Any, piece: tuple[Any, ...]) -> Any:
    """Return the dressed person with one piece more."""
    vertices, triangles, kind, colours, carry = piece
    count = len(dressed.vertices_m)
    return replace(
        dressed,
        vertices_m=np.vstack([dressed.vertices_m, vertices]),
        triangles=np.vstack([dressed.triangles, triangles + count]),
        kind=np.concatenate([dressed.kind, kind]),
        colours=np.vstack([dressed.colours, colours]),
        carry=csr_matrix(vstack([dressed.carry, carry])),
    )


def _pieces(generic: GenericHuman, body: Any, dressed: Any, kind: str, rng: np.random.Generator) -> list[Any]:
    """Return the tail or the cap of a person."""
    from painted_people_clothes import HAIR

    if kind == "tied":
        colour = np.median(dressed.colours[dressed.kind == HAIR], axis=0)
        return [_solid(generic, _tail(generic, body.vertices_m, rng), colour, 0.15, rng)]
    if kind == "cap":
        colour = np.clip(rng.uniform(0.06, 0.9) + 0.12 * rng.normal(size=3), 0.03, 0.95)
        return [_solid(generic, mesh, colour, 0.03, rng) for mesh in _cap(generic, body.vertices_m, rng)]
    return []


def _tail(generic: GenericHuman, vertices: Array, rng: np.random.Generator) -> trimesh.Trimesh:
    """Return a pony tail: balls along a curve from the back of the head downwards, as one hull a pair."""
    top, nape = vertices[generic.feature("head_top")], vertices[generic.feature("nape")]
    scalp = vertices[generic.region("scalp")]
    start = np.array([0.0, nape[1] + rng.uniform(0.3, 0.8) * (top[1] - nape[1]), 0.0])
    near = scalp[(np.abs(scalp[:, 1] - start[1]) < 0.01) & (np.abs(scalp[:, 0]) < 0.02)]
    start[2] = float(near[:, 2].min()) if len(near) else nape[2]
    length, thick, back = rng.uniform(0.12, 0.30), rng.uniform(0.014, 0.026), rng.uniform(0.02, 0.05)
    share = np.linspace(0.0, 1.0, 9)
    away = back * np.sin(np.pi * np.minimum(share * 1.6, 0.75))
    aside = rng.normal(0.0, 0.008) * share
    curve = start + np.stack([aside, -length * share**1.3 + 0.3 * away, -away - 0.5 * thick], axis=1)
    radii = thick * (0.55 + 0.45 * np.sin(np.pi * np.clip(share * 1.2, 0.0, 0.85)))
    balls = [
        trimesh.creation.icosphere(2, radius).apply_translation(place)
        for place, radius in zip(curve, radii, strict=True)
    ]
    return trimesh.util.concatenate(
        [trimesh.convex.convex_hull(np.vstack([a.vertices, b.vertices])) for a, b in itertools.pairwise(balls)]
    )


def _cap(generic: GenericHuman, vertices: Array, rng: np.random.Generator) -> list[trimesh.Trimesh]:
    """Return a cap's crown, a hull over the scalp, and its peak."""
    normals = vertex_normals(vertices, generic.triangles()[0])
    scalp = np.flatnonzero(generic.region("scalp"))
    brow, nape = vertices[generic.feature("glabella")], vertices[generic.feature("nape")]
    line = brow[1] + 0.035 + (vertices[scalp, 2] - brow[2]) * 0.12
    high = scalp[vertices[scalp, 1] > line]
    thick = rng.uniform(0.024, 0.032)  # over the hair
    points = vertices[high] + thick * normals[high]
    crown = trimesh.convex.convex_hull(points)
    front = points[points[:, 2] > np.quantile(points[:, 2], 0.9)]
    edge, low = float(np.abs(points[:, 0]).max()) * 0.8, float(front[:, 1].min())
    reach = rng.uniform(0.045, 0.07)
    x = np.linspace(-1.0, 1.0, 13)
    arc = np.stack([edge * x, np.full(13, low - 0.012), points[:, 2].max() - 0.015 + reach * (1.0 - x**2)], axis=1)
    root = np.stack([edge * x, np.full(13, low + 0.004), np.full(13, points[:, 2].max() - 0.045)], axis=1)
    peak = trimesh.convex.convex_hull(np.vstack([arc, root, arc + [0, 0.004, 0], root + [0, 0.004, 0]]))
    del nape
    return [crown, peak]


def _solid(generic: GenericHuman, mesh: trimesh.Trimesh, colour: Array, uneven: float, rng: np.random.Generator) -> Any:
    """Return a mesh as a piece that follows the skull, striped downwards like hair or cloth."""
    from painted_people_bodies import waves
    from painted_people_clothes import HAIR
    from painted_people_shoes import following

    fine = mesh.subdivide_to_size(0.012)
    vertices, triangles = np.asarray(fine.vertices), np.asarray(fine.faces, dtype=np.int64)
    colours = np.clip(colour * (1.0 + uneven * waves(vertices * [1, 0.1, 1], (0.006, 0.02), 12, rng))[:, None], 0, 1)
    rows = np.full(len(vertices), generic.feature("head_top"))
    return vertices, triangles, np.full(len(vertices), HAIR, np.int8), colours, following(generic, rows)


def visitor_case(folder: Path, set_name: str) -> HairCase:
    """Return a visitor whose truth holds the dressed surface with its textures (shared/visitors; too big to ship).

    Raises
    ------
    ClonerError
        If the truth is missing or cannot be read.
    """
    mesh = folder / "truth_dressed.glb"
    if not mesh.is_file():
        raise ClonerError("the true dressed surface is missing", "Give a folder of shared/visitors", str(mesh.name))
    truth, photos = read_truth(folder, set_name), load_photos(folder / set_name)
    cameras = {view: truth.views[view.value].camera for view in photos.photos if view.value in truth.views}
    layers = _true_layers(mesh)
    hair = {view: draw(layers, camera, background=(0, 0, 0))[..., 0] > 127 for view, camera in cameras.items()}
    mask = {view: truth.views[view.value].mask for view in cameras}
    return HairCase(f"{folder.name}_{set_name}", photos, Person(folder.name, "", truth.stature_m), hair, mask)


def _true_layers(mesh: Path) -> list[Layer]:
    """Return a visitor's dressed surface, hair white where half opaque, all else black."""
    layers = []
    for name, piece in trimesh.load(mesh).geometry.items():
        if name.startswith(("eyebrow", "eyelash")):
            continue
        white = 255 * (name.startswith(("ponytail", "short", "long", "bob", "afro", "braid")))
        rgba = np.asarray(piece.visual.material.baseColorTexture.convert("RGBA"))
        texture = np.dstack([np.full((*rgba.shape[:2], 3), white, np.uint8), np.where(rgba[..., 3:] > 127, 255, 0)])
        uv = np.column_stack([piece.visual.uv[:, 0], 1.0 - piece.visual.uv[:, 1]])
        points, triangles = np.asarray(piece.vertices, np.float64), np.asarray(piece.faces, np.int32)
        shown = texture.astype(np.uint8) if white else None
        colour = (white / 255.0,) * 3
        layers.append(Layer(points, vertex_normals(points, triangles), triangles, uv, shown, colour, True))
    return layers


@functools.cache
def visitor_names() -> tuple[str, ...]:
    """Return the sets whose truth has the pose of its surface: the hand-held photos show other poses."""
    return tuple(f"{who}/{what}" for who in ("anna", "boris") for what in ("plain", "booth"))
