"""Photographs of random dressed people whose every length, pose and camera is known.

``photograph_person`` gives the three body photos of a visitor with a held-out view and all truth; ``photograph_once``
one picture from any direction, for the calibration of nets. ``python generic_models/build/painted_people.py OUT
--people 6`` writes pictures to look at. Nothing of it is a real person.
"""

from __future__ import annotations

import argparse
import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from painted_people_bodies import RandomBody, naked_girths_mm, posed_joints, random_body, random_rotations
from painted_people_clothes import (
    CLOTH,
    TIGHTNESSES,
    Dressed,
    Tightness,
    dress,
    random_wardrobe,
)
from painted_people_pictures import (
    BACKGROUNDS,
    Background,
    developed,
    framed,
    lit,
    random_camera,
    rendered,
    room,
)

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import blend_transforms
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.views import Camera

Array = NDArray[np.float64]

SIZE_PX: Final = (1200, 1800)
HEADING_DEG: Final = 5.0  # how far a person turns away from the asked direction, at most
AZIMUTH_DEG: Final = {"body_front": 0.0, "body_side": 90.0, "body_back": 180.0, "body_three_quarter": 45.0}


@dataclass(frozen=True, slots=True, eq=False)
class Shot:
    """One photograph and what is true of it; metres, the shot's own model frame (root joint at rest).

    Attributes
    ----------
    name : str
        ``body_front`` ... ``body_three_quarter``, or the direction in degrees.
    rgb : (H, W, 3) uint8
    mask : (H, W) bool
        The dressed person with hair; more than half a pixel covered.
    camera : Camera
    focal_35mm : float
        True focal length; the photo tells it only when ``exif``.
    rotations : (94, 3) float64
        Joint rotations from the rest pose.
    joints_m : (94, 3) float64
    naked_m : (V, 3) float64
        The generic's vertices on the naked skin.
    dressed_m : (N, 3) float64
        The vertices of ``Dressed`` in this pose.
    """

    name: str
    rgb: NDArray[np.uint8]
    mask: NDArray[np.bool_]
    camera: Camera
    focal_35mm: float
    rotations: Array
    joints_m: Array
    naked_m: Array
    dressed_m: Array


@dataclass(frozen=True, slots=True, eq=False)
class KnownPerson:
    """A random person with three body photos and one held-out photo.

    Attributes
    ----------
    seed : int
    body : RandomBody
        Naked, rest pose.
    girths_mm : mapping of str to float
        Naked girths.
    dressed : Dressed
        Dressed, rest pose.
    background : str
    exif : bool
        Whether the photos tell their focal length.
    side : str
        The side the side photo shows, "left" or "right".
    shots : mapping of str to Shot
    """

    seed: int
    body: RandomBody
    girths_mm: Mapping[str, float]
    dressed: Dressed
    background: Background
    exif: bool
    side: str
    shots: Mapping[str, Shot]

    @property
    def photos(self) -> PhotoSet:
        """The three body photos as the project reads them."""
        views = (ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK)
        return PhotoSet({view: as_photo(self.shots[view.value], view, exif=self.exif) for view in views})

    @property
    def person(self) -> Person:
        """What the visitor tells at the door."""
        return Person(f"random-{self.seed}", "", self.body.stature_m)


def as_photo(shot: Shot, view: ViewId, *, exif: bool) -> Photo:
    """Return a shot as the project reads a photograph."""
    digest = hashlib.sha256(shot.rgb.tobytes()).hexdigest()
    return Photo(view, shot.rgb, shot.focal_35mm if exif else None, digest, f"{view.value}.jpg")


def known_body(
    seed: int, tightness: Tightness, background: Background, *, splits: int = 2
) -> tuple[RandomBody, Dressed]:
    """Return the naked and the dressed person of a seed; clothes of another tightness do not change the body."""
    body = random_body(load_generic(), np.random.default_rng([seed, 0]))
    rng = np.random.default_rng([seed, 1])
    alike = float(rng.uniform(0.7, 1.0)) if background == "low_contrast" else 0.0
    return body, dress(body, random_wardrobe(tightness, rng, alike=alike), rng, splits=splits)


def photograph_person(
    seed: int, *, tightness: Tightness, background: Background, size_px: tuple[int, int] = SIZE_PX, splits: int = 2
) -> KnownPerson:
    """Return a random person, three body photos in three poses, and a held-out photo in the front photo's pose.

    Parameters
    ----------
    seed : int
        The same seed is the same body whatever he wears and wherever he stands.
    tightness : "tight", "regular" or "loose"
    background : "plain", "cluttered" or "low_contrast"
    size_px : (width, height)
    splits : int
        How often the mesh's triangles are split in four: 2 for photographs, fewer for quick tests.
    """
    generic = load_generic()
    body, dressed = known_body(seed, tightness, background, splits=splits)
    rng = np.random.default_rng([seed, 2])
    side, exif = str(rng.choice(["left", "right"])), bool(rng.random() < 0.5)
    poses = {name: random_rotations(generic, body.joints_m, rng) for name in list(AZIMUTH_DEG)[:3]}
    poses["body_three_quarter"] = poses["body_front"]
    shots = {}
    for number, (name, azimuth) in enumerate(AZIMUTH_DEG.items()):
        turned = azimuth if side == "left" or name != "body_side" else -azimuth
        own = np.random.default_rng([seed, 10 + number])
        heading = turned + own.uniform(-HEADING_DEG, HEADING_DEG)
        shots[name] = take(name, body, dressed, poses[name], heading, background, size_px, own, seed)
    return KnownPerson(seed, body, naked_girths_mm(body), dressed, background, exif, side, shots)


def photograph_once(
    seed: int,
    azimuth_deg: float,
    *,
    tightness: Tightness = "regular",
    background: Background = "cluttered",
    size_px: tuple[int, int] = (800, 1200),
) -> tuple[Shot, RandomBody, Dressed]:
    """Return one picture of a random person from any direction, with true camera, pose, joints and skin."""
    body, dressed = known_body(seed, tightness, background, splits=1)
    rng = np.random.default_rng([seed, 3])
    rotations = random_rotations(load_generic(), body.joints_m, rng)
    return (
        take(f"{azimuth_deg:.0f}", body, dressed, rotations, azimuth_deg, background, size_px, rng, seed),
        body,
        dressed,
    )


def posed(dressed: Dressed, body: RandomBody, rotations: Array) -> tuple[Array, Array, Array]:
    """Return posed joints (94, 3), naked vertices (V, 3) and dressed vertices (N, 3)."""
    generic = load_generic()
    transforms, joints = posed_joints(generic, body.joints_m, rotations)
    blended = blend_transforms(transforms, generic.skin_joints, generic.skin_weights.astype(np.float64))
    naked = np.einsum("vab,vb->va", blended[:, :, :3], body.vertices_m) + blended[:, :, 3]
    carried = (dressed.carry @ blended.reshape(len(blended), -1)).reshape(-1, 3, 4)
    return joints, naked, np.einsum("vab,vb->va", carried[:, :, :3], dressed.vertices_m) + carried[:, :, 3]


def take(
    name: str,
    body: RandomBody,
    dressed: Dressed,
    rotations: Array,
    azimuth_deg: float,
    background: Background,
    size_px: tuple[int, int],
    rng: np.random.Generator,
    seed: int,
) -> Shot:
    """Return one shot of a person in a pose; the room is the seed's, wherever he is seen from."""
    joints, naked, worn = posed(dressed, body, rotations)
    floor, top = float(worn[:, 1].min()), float(worn[:, 1].max())
    camera, focal_mm = framed(*random_camera(azimuth_deg, (floor, top), size_px, rng), worn)
    normals = vertex_normals(worn, dressed.triangles)
    colours = lit(worn, normals, dressed.colours, camera, np.random.default_rng([seed, 4]))
    person = rendered(worn, dressed.triangles, colours, camera)
    seen = (dressed.kind == CLOTH) & (normals @ camera.camera_from_model[2, :3] < -0.3)
    behind = room(background, camera, floor, np.median(colours[seen], axis=0), person, np.random.default_rng([seed, 5]))
    picture = developed(person, behind, rng)
    return Shot(name, picture, person[..., 3] > 0.5, camera, focal_mm, rotations, joints, naked, worn)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--people", type=int, default=6)
    parser.add_argument("--first", type=int, default=0, metavar="SEED")
    chosen = parser.parse_args()
    chosen.out.mkdir(parents=True, exist_ok=True)
    for number in range(chosen.people):
        seed = chosen.first + number
        known = photograph_person(
            seed, tightness=TIGHTNESSES[number % 3], background=BACKGROUNDS[(number // 3 + number) % 3]
        )
        row = np.hstack([shot.rgb for shot in known.shots.values()])
        cv2.imwrite(
            str(chosen.out / f"{seed}_{known.dressed.wardrobe.tightness}_{known.background}.png"), row[..., ::-1]
        )


if __name__ == "__main__":
    main()
