"""Find where the pose net's points lie on a body: ``python generic_models/build/calibrate_body_net.py PEOPLE``.

People of two families are photographed from the front, a side and the back and shown to the net: dressed ones painted
here, and as many from PEOPLE, folders of the generator of photographed synthetic people (its seeds 7001 and on, far
from those that benchmarks draw). A painter's people alone mislead: the net finds their ankles 12 mm below the joint,
the generator's and the samples' 3 to 13 mm above it. Every point's mean place beside a joint of the skeleton, and its
spread, go to ``cloner_models/body_net.npz``, apart for what faces the camera from the front, from the back, on the near
and on the far side of a side photo.
"""

from __future__ import annotations

import argparse
import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

import numpy as np
from archives import save
from numpy.typing import NDArray
from painted_people import Shot, photograph_once
from painted_people_bodies import RandomBody
from painted_people_clothes import TIGHTNESSES
from painted_people_pictures import BACKGROUNDS

from cloner.detectors.nets import litert
from cloner.evaluate.measures.posing import JOINTS
from cloner.evaluate.measures.rulers import fit_similarity
from cloner.evaluate.truths.kit import KitTruth, kit_people, read_kit, side_shown
from cloner.generic.body_net import LANDMARKS, SIDES, base_position
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.seen_points import visible_aspect
from cloner.geometry.articulation.skinning import blend_transforms, joint_transforms
from cloner.records.views import Camera

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "body_net.npz"
FIRST_SEED = 7000  # far from the seeds that tests and benchmarks draw
TURNED_DEG = 8.0  # how far people turn away from the direction they were asked for
BASES = tuple(dict.fromkeys(mark.base(left) for mark in LANDMARKS for left in (True, False)))
DIRECTIONS = {"front": 0.0, "left": 90.0, "back": 180.0, "right": -90.0}
MIRROR = np.array([-1.0, 1.0, 1.0])
#: Holds an offset's component along the line of sight, which no photo shows, at zero; share of one photo's weight.
RIDGE = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """One landmark in one photo, mirrored to the left side of the body; lengths in shares of the stature.

    Attributes
    ----------
    landmark : int, row of `LANDMARKS`
    side : str, one of `SIDES`
    sight : (2, 3) picture axes in the rest frame of the point
    error : (2,) net point minus the projected base, along the picture's axes
    """

    landmark: int
    side: str
    sight: Array
    error: Array


@dataclass(frozen=True, slots=True, eq=False)
class Photographed:
    """A photo of somebody whose body is known.

    Attributes
    ----------
    rgb : (H, W, 3) uint8
    camera : Camera
    direction : str, key of `DIRECTIONS`: what the photo shows
    stature_m : float
    bases : mapping of a landmark's base to its true place (3,), metres, and its turn (3, 3) from the rest pose
    """

    rgb: NDArray[np.uint8]
    camera: Camera
    direction: str
    stature_m: float
    bases: Mapping[str, tuple[Array, Array]]


def painted(shot: Shot, body: RandomBody, direction: str, generic: GenericHuman) -> Photographed:
    """Return a photo painted here."""
    transforms = joint_transforms(body.joints_m, generic.joint_parents.astype(np.int32), shot.rotations)
    blended = blend_transforms(transforms, generic.skin_joints, generic.skin_weights.astype(np.float64))

    def turn(base: str) -> Array:
        if base in generic.joint_names:
            return np.asarray(transforms[generic.joint(base), :3, :3])
        return np.asarray(blended[generic.feature(base), :, :3])

    bases = {base: (base_position(generic, base, shot.naked_m, shot.joints_m), turn(base)) for base in BASES}
    return Photographed(shot.rgb, shot.camera, direction, body.stature_m, bases)


def generated(kit: KitTruth, view: str, generic: GenericHuman) -> Photographed:
    """Return a photo of a generated person; what its truth does not name lies where its part of the body carries it."""
    truth, body = kit.truth.views[view], kit.bodies_m[view]
    rest, head = generic.vertices_m[: len(body)], generic.joint("skullbase")
    told = {ours: truth.joints_m[name] for name, ours in JOINTS.items()} | dict(truth.points_m)
    owner = generic.skin_joints[np.arange(len(body)), generic.skin_weights[: len(body)].argmax(axis=1)]

    def found(base: str) -> tuple[Array, Array]:
        joint = generic.joint(base) if base in generic.joint_names else head
        skin = owner == joint
        motion = fit_similarity(rest[skin].astype(np.float64), body[skin], scale=True)
        turn = motion[:3, :3] / np.cbrt(np.linalg.det(motion[:3, :3]))
        return told[base] if base in told else motion[:3, :3] @ generic.joints_m[joint] + motion[:3, 3], turn

    return Photographed(truth.photo, truth.camera, side_shown(truth), kit.truth.stature_m, {b: found(b) for b in BASES})


def findings(photo: Photographed) -> Iterator[Found]:
    """Give every landmark that the net finds in a photo."""
    pose = litert.detect_pose(photo.rgb)
    if pose is None:
        return
    for row, landmark in enumerate(LANDMARKS):
        middle = landmark.rows[0] == landmark.rows[1]
        for number, left in enumerate((True,) if middle else (True, False)):
            place, turn = photo.bases[landmark.base(left)]
            metres = photo.camera.metres_per_pixel(place) / photo.stature_m
            error = (pose.points_px[landmark.rows[number]] - photo.camera.project(place[None])[0]) * metres
            sight = photo.camera.camera_from_model[:2, :3] @ turn
            mirrored = (photo.direction == "right") if middle else not left
            yield Found(
                row,
                visible_aspect("" if middle else "left" if left else "right", photo.direction),
                sight * MIRROR if mirrored else sight,
                error,
            )


def solve(found: list[Found]) -> tuple[Array, float]:
    """Return the offset (3,) that explains one landmark best, and the median-based spread of one axis."""
    sights, errors = np.array([f.sight for f in found]), np.array([f.error for f in found])
    weight, offset = np.ones(len(found)), np.zeros(3)
    spread = 1.0
    for _ in range(8):
        normal = np.einsum("n,nia,nib->ab", weight, sights, sights) + RIDGE * np.eye(3)
        offset = np.linalg.solve(normal, np.einsum("n,nia,ni->a", weight, sights, errors))
        rest = np.linalg.norm(errors - sights @ offset, axis=1)
        spread = float(np.median(rest)) / 1.1774  # median of a Rayleigh distribution
        weight = 1.0 / (1.0 + (rest / (3.0 * spread)) ** 2)
    return offset, spread


def main() -> None:
    """Photograph, ask, average, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("people", type=Path, help="folders of generated people")
    people = kit_people([parser.parse_args().people])
    generic = load_generic()
    found: list[Found] = []
    for number, person in enumerate(people):
        kit = read_kit(person)
        for view in ("body_front", "body_side", "body_back"):
            found.extend(findings(generated(kit, view, generic)))
        seed = FIRST_SEED + number
        rng = np.random.default_rng(seed)
        beside = "left" if number % 2 else "right"
        for direction in ("front", beside, "back"):
            azimuth = DIRECTIONS[direction] + rng.uniform(-TURNED_DEG, TURNED_DEG)
            clothes, room = rng.choice(len(TIGHTNESSES)), rng.choice(len(BACKGROUNDS))
            shot, body, _ = photograph_once(seed, azimuth, tightness=TIGHTNESSES[clothes], background=BACKGROUNDS[room])
            found.extend(findings(painted(shot, body, direction, generic)))
        if number % 10 == 9:
            print(f"{number + 1} people", flush=True)
    offset, spread = np.zeros((len(SIDES), len(LANDMARKS), 3)), np.zeros((len(SIDES), len(LANDMARKS)))
    for row, landmark in enumerate(LANDMARKS):
        for place, side in enumerate(SIDES):
            own = [f for f in found if f.landmark == row and f.side == side]
            if own:
                offset[place, row], spread[place, row] = solve(own)
                shift = 1700.0 * offset[place, row]
                print(f"{landmark.name:10s} {side:5s} n {len(own):3d} offset mm at 1.70 m {shift.round(1)}"
                      f" spread {1700.0 * spread[place, row]:5.1f}")  # fmt: skip
    net = (files("cloner_models") / "nets" / "pose_landmark_heavy.tflite").read_bytes()
    save(OUT, {"names": np.array([m.name for m in LANDMARKS], dtype=np.str_), "sides": np.array(SIDES, dtype=np.str_),
               "offset": offset.astype(np.float32), "spread": spread.astype(np.float32),
               "people": np.array(2 * len(people)),
               "net_sha256": np.array(hashlib.sha256(net).hexdigest())})  # fmt: skip


if __name__ == "__main__":
    main()
