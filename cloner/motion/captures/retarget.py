"""Retargeting: limbs point as the captured ones do, with the clone's own lengths.

Every limb keeps the capture's direction frame by frame, so neither rest poses nor lengths need to agree; the trunk's
turn is spread over the vertebrae, and the hips travel in proportion to the legs. Then the soles are put on the floor
and standing feet are held.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

import numpy as np

from cloner.motion.captures.anatomy import Anatomy, Limb, find_anatomy
from cloner.motion.captures.bvh import Capture
from cloner.motion.captures.soles import belt_speed, flattened, settled, tilt_of
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import FOOT, NECK, SIDES, SPINE, Body, below
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.planting import planted
from cloner.records.arrays import Array
from cloner.records.motions import Motion

#: Frames a second of what comes out; places between two captured frames are interpolated.
FRAMES_PER_S: Final = 60.0
#: Heads that are carried farther off the upright than this do so on purpose, radians (45 degrees).
CARRIED_RAD: Final = 0.8


def retarget(capture: Capture, body: Body, *, name: str) -> Motion:
    """Return the capture as a motion of a clone.

    Parameters
    ----------
    capture : Capture
    body : Body
    name : str

    Raises
    ------
    ClonerError
        If the capture's joints cannot be told.
    """
    anatomy = find_anatomy(capture)
    count = max(round((len(capture.root) - 1) * capture.frame_s * FRAMES_PER_S), 1)
    times = np.arange(count + 1) / FRAMES_PER_S
    source, offsets, where = _in_our_axes(capture, anatomy, times)
    world = _trunk(body, anatomy, source)
    for side, leg, arm in zip(SIDES, anatomy.legs, anatomy.arms, strict=True):
        _limb(body, world, side, ("hip", "knee", "ankle"), leg, source, offsets)
        _foot(body, world, side, leg, source, offsets)
        _arm(body, world, side, arm, source, offsets)
    rotations = shared_twist(body, turns.local_from_world(world, body.parents))
    motion = Motion(name, times, _travel(body, anatomy, where), rotations)
    motion = settled(body, motion)
    motion = replace(motion, speed_m_s=belt_speed(body, motion))
    return planted(body, settled(body, flattened(body, motion)))


def _in_our_axes(capture: Capture, anatomy: Anatomy, times_s: Array) -> tuple[Array, Array, Array]:
    """Return (F, J, 3, 3) orientations, (J, 3) offsets and (F, J, 3) places of a capture at some times, our axes."""
    place = np.clip(times_s / capture.frame_s, 0.0, len(capture.root) - 1.0)
    before = np.minimum(place.astype(int), max(len(capture.root) - 2, 0))
    after, part = np.minimum(before + 1, len(capture.root) - 1), place - before
    world = capture.world()
    step = turns.vectors(np.swapaxes(world[before], -1, -2) @ world[after])
    world = world[before] @ turns.matrices(part[:, None, None] * step)
    root = capture.root[before] + part[:, None] * (capture.root[after] - capture.root[before])
    model = facing_front(capture, anatomy, model_from_file(capture, anatomy))
    source = np.einsum("ab,fjbc,dc->fjad", model, world, model)  # turns of our axes
    offsets = capture.offsets @ model.T
    return source, offsets, _places(capture, source, offsets, root @ model.T)


def captured_directions(capture: Capture, anatomy: Anatomy, times_s: Array) -> dict[tuple[str, str], Array]:
    """Return (F, 3) the unit directions of the captured limbs, our axes, by the two H-Anim joints of each bone."""
    _, _, where = _in_our_axes(capture, anatomy, times_s)
    found = {}
    for side, leg, arm in zip(SIDES, anatomy.legs, anatomy.arms, strict=True):
        for limb, names in ((leg, ("hip", "knee", "ankle")), (arm, ("shoulder", "elbow", "wrist"))):
            for (first, start), (last, end) in pairwise(zip(names, (limb.upper, limb.lower, limb.end), strict=True)):
                bone = where[:, end] - where[:, start]
                found[f"{side}_{first}", f"{side}_{last}"] = bone / np.linalg.norm(bone, axis=1, keepdims=True)
    return found


def model_from_file(capture: Capture, anatomy: Anatomy) -> Array:
    """Return the (3, 3) turn from the file's axes to ours: x to the left, y up, z to the front.

    Up is the axis along which the body is longest at rest, left is where the left hip is.
    """
    rest = np.zeros_like(capture.offsets)
    for joint, parent in enumerate(capture.parents):
        if parent >= 0:
            rest[joint] = rest[parent] + capture.offsets[joint]
    feet = (rest[anatomy.legs[0].end] + rest[anatomy.legs[1].end]) / 2.0
    up = _axis(rest[anatomy.head] - feet)
    across = rest[anatomy.legs[0].upper] - rest[anatomy.legs[1].upper]
    left = _axis(across - across @ up * up)
    return np.array([left, up, np.cross(left, up)])


def facing_front(capture: Capture, anatomy: Anatomy, model: Array) -> Array:
    """Return the turn from the file's axes with which the hips of the first frame face the front."""
    ahead = model @ capture.world()[0, anatomy.pelvis] @ model.T @ np.array([0.0, 0.0, 1.0])
    return np.asarray(turns.rotations_about(1, -np.arctan2(ahead[0], ahead[2])) @ model)


def _axis(direction: Array) -> Array:
    """Return the signed unit axis nearest to a direction."""
    axis = np.zeros(3)
    axis[np.abs(direction).argmax()] = np.sign(direction[np.abs(direction).argmax()])
    return axis


def _places(capture: Capture, world: Array, offsets: Array, root: Array) -> Array:
    """Return (F, J, 3) places of the captured joints."""
    where = np.empty((len(world), len(capture.parents), 3))
    for joint, parent in enumerate(capture.parents):
        where[:, joint] = root if parent < 0 else where[:, parent] + world[:, parent] @ offsets[joint]
    return where


def _trunk(body: Body, anatomy: Anatomy, source: Array) -> Array:
    """Return orientations of all joints with the trunk's, neck's and head's set; limbs as the trunk."""
    source = _levelled(source, anatomy.neck[1:])
    world = np.tile(np.eye(3), (len(source), len(body.names), 1, 1))
    world[:] = source[:, [anatomy.pelvis]]
    for names, knots in ((SPINE, anatomy.spine), (NECK, anatomy.neck)):
        first = source[:, anatomy.pelvis] if names is SPINE else source[:, knots[0]]
        turns_of = [first, *(source[:, knot] for knot in knots[1:])]
        for row, joint in enumerate(names):
            place = (row + 1) / len(names) * (len(turns_of) - 1)
            low = min(int(place), max(len(turns_of) - 2, 0))
            high = min(low + 1, len(turns_of) - 1)
            turned = turns.interpolated_rotations(turns_of[low], turns_of[high], place - low)
            world[:, below(body, body.joint(joint))] = turned[:, None]
    return world


def _levelled(source: Array, joints: tuple[int, ...]) -> Array:
    """Return the orientations with neck and head upright as they are carried in the capture's calm stretches.

    What a marker set calls a head at rest may look up by 20 degrees; people who walk or stand look ahead.
    """
    out = source.copy()
    for joint in joints:
        tilt = tilt_of(source[:, joint])
        speed = np.linalg.norm(np.diff(tilt, axis=0, append=tilt[-1:]), axis=1)
        usual = np.median(tilt[speed <= np.median(speed)], axis=0)
        if np.linalg.norm(usual) < CARRIED_RAD:
            out[:, joint] = source[:, joint] @ turns.matrices(-usual)
    return out


def _aimed(body: Body, names: tuple[str, str], source: Array, joint: int, direction: Array) -> Array:
    """Return (F, 3, 3) a joint's orientations that let its bone point as the captured joint's ``direction`` does."""
    first, second = (body.joint(name) for name in names)
    rest = body.joints_m[second] - body.joints_m[first]
    return np.asarray(source[:, joint] @ turns.rotations_between(rest, direction))


def _limb(
    body: Body, world: Array, side: str, names: tuple[str, str, str], limb: Limb, source: Array, offsets: Array
) -> None:
    upper, lower, end = (f"{side}_{name}" for name in names)
    world[:, body.joint(upper)] = _aimed(body, (upper, lower), source, limb.upper, offsets[limb.lower])
    world[:, body.joint(lower)] = _aimed(body, (lower, end), source, limb.lower, offsets[limb.end])


def _foot(body: Body, world: Array, side: str, leg: Limb, source: Array, offsets: Array) -> None:
    """Turn a foot as the captured one; both stand flat at rest, so only the way they point at rest is evened."""
    toe = body.joints_m[body.joint(f"{side}_metatarsal")] - body.joints_m[body.joint(f"{side}_ankle")]
    ahead = offsets[leg.tip] if leg.tip >= 0 else np.array([0.0, 0.0, 1.0])
    level = np.array([1.0, 0.0, 1.0])
    foot = source[:, leg.end] @ turns.rotations_between(toe * level, ahead * level)
    for name in FOOT:
        world[:, body.joint(f"{side}_{name}")] = foot
    bent = foot if leg.tip < 0 else source[:, leg.tip] @ turns.rotations_between(toe * level, ahead * level)
    world[:, body.joint(f"{side}_metatarsal")] = bent


def _arm(body: Body, world: Array, side: str, arm: Limb, source: Array, offsets: Array) -> None:
    if arm.girdle >= 0:
        lift = _aimed(body, (f"{side}_acromioclavicular", f"{side}_shoulder"), source, arm.girdle, offsets[arm.upper])
        rest = turns.rotations_between(
            body.joints_m[body.joint(f"{side}_shoulder")] - body.joints_m[body.joint(f"{side}_acromioclavicular")],
            offsets[arm.upper],
        )
        for name in ("sternoclavicular", "acromioclavicular"):  # the collar moves as the captured one, from our rest
            world[:, body.joint(f"{side}_{name}")] = lift @ rest.T
    _limb(body, world, side, ("shoulder", "elbow", "wrist"), arm, source, offsets)
    forearm = body.joint(f"{side}_elbow")
    hand = source[:, arm.end] @ np.swapaxes(source[:, arm.lower], -1, -2) @ world[:, forearm]
    world[:, below(body, body.joint(f"{side}_wrist"))] = hand[:, None]


def _travel(body: Body, anatomy: Anatomy, where: Array) -> Array:
    """Return (F, 3) the root's displacements: the captured hips' way in proportion to the legs, from the origin on."""
    hips = where[:, [leg.upper for leg in anatomy.legs]].mean(axis=1)
    theirs = np.mean([_leg_length(where[0], (leg.upper, leg.lower, leg.end)) for leg in anatomy.legs])
    ours = np.mean([_leg_length(body.joints_m, tuple(body.joint(f"{side}_{name}") for name in ("hip", "knee", "ankle")))
                    for side in SIDES])  # fmt: skip
    way = (hips - hips[0] * (1.0, 0.0, 1.0)) * (ours / theirs)
    low = min(where[:, leg.end, 1].min() for leg in anatomy.legs) * (ours / theirs)
    rest = body.joints_m[[body.joint(f"{side}_hip") for side in SIDES]].mean(axis=0)
    ankle = min(body.joints_m[body.joint(f"{side}_ankle"), 1] for side in SIDES)
    return np.asarray(way - (0.0, rest[1] + low - ankle, 0.0))


def _leg_length(points: Array, joints: tuple[int, ...]) -> float:
    hip, knee, ankle = (points[joint] for joint in joints)
    return float(np.linalg.norm(hip - knee) + np.linalg.norm(knee - ankle))
