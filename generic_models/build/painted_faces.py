"""Face photographs of random dressed people whose every feature point is known.

``photograph_face`` gives one front or side photo with its truth: turned by up to 10 degrees, 0.6 to 2 m away, under
three kinds of light, with short, long or no hair, and on request with a beard, glasses, hair over the ear or a dark
wall. ``python generic_models/build/painted_faces.py OUT --people 6`` writes pictures to look at. Nobody of them lives.
"""

from __future__ import annotations

import argparse
import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final, Literal

import cv2
import numpy as np
from numpy.typing import NDArray
from painted_faces_extras import bearded, over_ears, spectacled
from painted_people import posed
from painted_people_bodies import RandomBody, random_body, random_rotations, waves
from painted_people_clothes import HAIR, Dressed, dress, random_wardrobe
from painted_people_pictures import Background, developed, in_shadow, rendered, room

from cloner.frames import ViewId, focal_px_from_35mm
from cloner.generic.load import GENERIC_STATURE_M, load_generic
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.photos import Photo
from cloner.records.views import Camera

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]
Light = Literal["soft", "side", "lamp"]
Extra = Literal["beard", "glasses", "ear_hair", "dark_wall"]

LIGHTS: Final[tuple[Light, ...]] = ("soft", "side", "lamp")
EXTRAS: Final[tuple[Extra, ...]] = ("beard", "glasses", "ear_hair", "dark_wall")
SIZE_PX: Final = (900, 1200)
TURN_DEG: Final = 10.0
DISTANCE_M: Final = (0.6, 2.0)
#: Share of the photo's height that a head fills.
FILL: Final = (0.38, 0.55)
#: Smooth bumps that no face of the family has: root mean square and wave lengths, metres.
BUMPS_M: Final = 0.0008
BUMP_LENGTHS_M: Final = (0.03, 0.09)
_GAMMA: Final = 2.2
#: Points of the body that a portrait does not name.
_FACE: Final = (
    "vertex_top", "nasion", "glabella", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front",
    "chin_bottom", *(f"{name}_{side}" for side in "LR" for name in (
        "eye_inner", "eye_outer", "eye_upper", "eye_lower", "mouth_corner", "ala", "ear_top", "ear_lobe", "ear_back",
        "ear_outer", "pupil",
    )),
)  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class KnownFace:
    """One face photograph and what is true of it.

    Attributes
    ----------
    view : ViewId
        FACE_FRONT or FACE_SIDE.
    rgb : (H, W, 3) uint8
    mask, hair : (H, W) bool
        The person, and the pixels whose nearest surface is hair.
    camera : Camera
    vertices_m : (V, 3) float64
        The generic's vertices on the naked skin.
    marks_px : mapping of str to (2,) float64
        Features of the face by name and MPEG-4 points as ``fdp_3.1``; those that can be seen.
    iod_px : float
        True distance of the pupils at their depth, px.
    facing : int
        +1 when a side photo's person looks to the image's right, -1 left, 0 front.
    light : str
    extras : tuple of str
    """

    view: ViewId
    rgb: NDArray[np.uint8]
    mask: Bools
    hair: Bools
    camera: Camera
    vertices_m: Array
    marks_px: Mapping[str, Array]
    iod_px: float
    facing: int
    light: str
    extras: tuple[str, ...]

    @property
    def photo(self) -> Photo:
        """The photograph as the project reads it, without a told focal length."""
        return Photo(self.view, self.rgb, None, hashlib.sha256(self.rgb.tobytes()).hexdigest(), f"{self.view}.jpg")


@dataclass(frozen=True, slots=True, eq=False)
class Sitter:
    """A random person ready to be photographed: naked body, clothes, and the head's pose."""

    seed: int
    body: RandomBody
    dressed: Dressed
    joints_m: Array
    naked_m: Array
    worn_m: Array
    extras: tuple[str, ...]


def make_sitter(
    seed: int,
    extras: tuple[Extra, ...] = (),
    *,
    hair: str | None = None,
    splits: int = 2,
    beyond_m: Array | None = None,
) -> Sitter:
    """Return a random person.

    ``hair`` forces "short", "long" or "bald"; ``beyond_m`` (H, 3) moves the head's vertices at the generic's stature.
    """
    generic, rng = load_generic(), np.random.default_rng([seed, 20])
    body = random_body(generic, rng)
    if beyond_m is not None:
        moved = body.vertices_m.copy()
        moved[generic.head_vertices] += body.stature_m / GENERIC_STATURE_M * beyond_m
        body = replace(body, vertices_m=moved)
    normals = vertex_normals(body.vertices_m, generic.triangles()[0])
    rough = BUMPS_M * generic.head_blend * waves(body.vertices_m, BUMP_LENGTHS_M, 40, rng)
    skin = generic.vertex_part == generic.part_names.index("body")
    body = replace(body, vertices_m=body.vertices_m + (skin * rough)[:, None] * normals)
    wardrobe = random_wardrobe("regular", rng)
    if hair is not None:
        wardrobe = replace(wardrobe, hair=hair, hair_m=0.0 if hair == "bald" else max(wardrobe.hair_m, 0.008))
    dressed = dress(body, wardrobe, rng, splits=splits)
    if "beard" in extras:
        dressed = replace(dressed, colours=bearded(dressed, rng, splits))
    rotations = 0.4 * random_rotations(generic, body.joints_m, rng)
    joints, naked, worn = posed(dressed, body, rotations)
    return Sitter(seed, body, dressed, joints, naked, worn, tuple(extras))


def photograph_face(
    sitter: Sitter,
    view: ViewId,
    *,
    light: Light | None = None,
    background: Background = "plain",
    facing: int | None = None,
    distance_m: float | None = None,
    size_px: tuple[int, int] = SIZE_PX,
) -> KnownFace:
    """Return a front or side portrait of a person; what is not given is drawn from the person's seed."""
    number = 0 if view is ViewId.FACE_FRONT else 1
    rng = np.random.default_rng([sitter.seed, 21 + number])
    chosen = light or LIGHTS[int(rng.integers(3))]
    looks = 0 if number == 0 else (facing or int(rng.choice([-1, 1])))
    camera = _portrait_camera(sitter, -90.0 * looks, distance_m, size_px, rng)
    worn, dressed = sitter.worn_m, sitter.dressed
    normals = vertex_normals(worn, dressed.triangles)
    colours = _lit(worn, normals, dressed.colours, camera, chosen, rng)
    person = rendered(worn, dressed.triangles, colours, camera)
    kind = rendered(worn, dressed.triangles, np.repeat((dressed.kind == HAIR)[:, None], 3, 1).astype(float), camera)
    behind = room(background, camera, 0.0, np.median(colours, axis=0), person, np.random.default_rng([sitter.seed, 5]))
    if "dark_wall" in sitter.extras:
        behind = behind * np.float32(rng.uniform(0.04, 0.18))
    hair = kind[..., 0] > 0.5
    marks = _marks(sitter, camera)
    if "ear_hair" in sitter.extras:
        person, hair = over_ears(person, hair, sitter.dressed, marks, rng)
    picture = developed(person, behind, rng)
    if "glasses" in sitter.extras:
        picture = spectacled(picture, sitter.naked_m, camera, looks, rng)
    return KnownFace(
        view, picture, person[..., 3] > 0.5, hair, camera, sitter.naked_m, _seen(marks, hair, looks),
        _iod_px(sitter, camera), looks, chosen, sitter.extras,
    )  # fmt: skip


def _iod_px(sitter: Sitter, camera: Camera) -> float:
    generic = load_generic()
    left, right = (sitter.naked_m[generic.feature(f"pupil_{side}")] for side in "LR")
    return float(np.linalg.norm(left - right)) / camera.metres_per_pixel((left + right) / 2.0)


def _portrait_camera(
    sitter: Sitter, azimuth_deg: float, distance_m: float | None, size_px: tuple[int, int], rng: np.random.Generator
) -> Camera:
    """Return a camera before the head, turned, tipped and rolled a little around the asked direction."""
    generic = load_generic()
    spot = [sitter.naked_m[generic.feature(name)] for name in ("nasion", "chin_bottom", "ear_top_L", "ear_top_R")]
    target = np.mean(spot, axis=0) + rng.uniform(-0.02, 0.02, 3)
    head = float(np.ptp(sitter.naked_m[[generic.feature("vertex_top"), generic.feature("chin_bottom")], 1]))
    away = float(np.exp(rng.uniform(*np.log(DISTANCE_M)))) if distance_m is None else distance_m
    yaw, pitch = np.radians([azimuth_deg, 0.0] + rng.uniform(-TURN_DEG, TURN_DEG, 2))
    out = np.array([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)])
    forward, eye = -out, target + away * out
    right = np.cross(forward, [0.0, 1.0, 0.0])
    right /= np.linalg.norm(right)
    level = np.stack([right, np.cross(forward, right), forward])
    roll = cv2.Rodrigues(np.array([0.0, 0.0, np.radians(rng.uniform(-4, 4))]))[0]
    matrix = np.eye(4)
    matrix[:3, :3] = roll @ level
    matrix[:3, 3] = -matrix[:3, :3] @ eye
    focal = rng.uniform(*FILL) * size_px[1] * away / head
    return Camera(*size_px, max(focal, focal_px_from_35mm(20.0, *size_px)), matrix)


def _lit(worn: Array, normals: Array, colours: Array, camera: Camera, light: Light, rng: np.random.Generator) -> Array:
    """Return (N, 3) sRGB colours under one of three lights: a wide soft one, a window aside, or a lamp above."""
    to_model = camera.camera_from_model[:3, :3].T
    aside = rng.choice([-1.0, 1.0])
    ambient, strength, place = {
        "soft": (0.50, 0.45, [0.5 * aside, -0.5, -1.0]),
        "side": (0.22, 0.85, [1.6 * aside, -0.3, -0.7]),
        "lamp": (0.30, 0.70, [0.3 * aside, -1.6, -0.9]),
    }[light]
    towards = to_model @ (np.array(place) + rng.normal(0.0, 0.15, 3))
    towards /= np.linalg.norm(towards)
    lamp = strength * np.clip(normals @ towards, 0.0, 1.0) * (1.0 - 0.8 * in_shadow(worn, towards))
    shade = ambient * (0.75 + 0.25 * normals[:, 1]) + lamp
    half = towards - to_model @ np.array([0.0, 0.0, 1.0])
    shine = rng.uniform(0.0, 0.10) * np.clip(normals @ (half / np.linalg.norm(half)), 0.0, 1.0) ** 24
    warm = 1.0 + rng.uniform(-0.07, 0.07) * np.array([1.0, 0.0, -1.0])
    linear = colours**_GAMMA * shade[:, None] * warm + (shine * strength)[:, None]
    return np.asarray(np.clip(linear * rng.uniform(0.9, 1.2), 0.0, 1.0) ** (1.0 / _GAMMA))


def _marks(sitter: Sitter, camera: Camera) -> dict[str, Array]:
    generic = load_generic()
    rows = {name: generic.feature(name) for name in _FACE}
    rows |= {f"fdp_{n}": int(v) for n, v in zip(generic.fdp_names, generic.fdp_vertices, strict=True) if n[:2] != "6."}
    return dict(zip(rows, camera.project(sitter.naked_m[list(rows.values())]), strict=True))


def _seen(marks: dict[str, Array], hair: Bools, facing: int) -> dict[str, Array]:
    """Return the marks that hair does not hide; of a side photo those of the near side and the midline."""
    out = {}
    for name, place in marks.items():
        column, row = np.round(place).astype(int)
        inside = 0 <= row < hair.shape[0] and 0 <= column < hair.shape[1]
        if not inside or (name.startswith("ear") and hair[row, column]):
            continue
        far = {1: "_L", -1: "_R"}.get(facing, "-")  # who looks to the image's right shows the right side
        if not name.endswith(far):
            out[name] = place
    return out


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--people", type=int, default=6)
    chosen = parser.parse_args()
    chosen.out.mkdir(parents=True, exist_ok=True)
    for seed in range(chosen.people):
        sitter = make_sitter(seed, (EXTRAS[seed % len(EXTRAS)],) if seed % 2 else ())
        faces = [photograph_face(sitter, view) for view in (ViewId.FACE_FRONT, ViewId.FACE_SIDE)]
        for face in faces:
            for place in face.marks_px.values():
                cv2.circle(face.rgb, np.round(place).astype(int).tolist(), 2, (0, 255, 0), -1)
        cv2.imwrite(str(chosen.out / f"{seed}.png"), np.hstack([face.rgb for face in faces])[..., ::-1])


if __name__ == "__main__":
    main()
