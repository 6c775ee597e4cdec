"""A procedural walk and idle for any clone, from human gait angles.

The curves are ours: knots read off the usual sagittal angles of healthy gait (hip 30 degrees forward at heel strike and
10 back, knee 60 degrees in swing, ankle 10 up and 18 down), so nobody's capture is in them.

References
----------
D. A. Winter, The Biomechanics and Motor Control of Human Gait, 1991 (ranges of the joints' angles).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from cloner.geometry.articulation.fingers import FINGERS, knuckles, palm_normal
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import FOOT, NECK, SIDES, SPINE, Body, below
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.contact import on_ground
from cloner.motion.moves.planting import planted
from cloner.motion.moves.styles import REGULAR, Style
from cloner.records.arrays import Array
from cloner.records.motions import Motion

#: Axes.
X, Y, Z = 0, 1, 2
#: Frames a second of every cycle.
FRAMES_PER_S: Final = 30
#: Feet roll over the ground between two frames of a walk; at half as many they slide by millimetres in between.
WALK_FRAMES_PER_S: Final = 60
#: Steps are this share of what the free swing of the legs would make: the pelvis then goes up and down by 44 mm, as
#: people's does at this speed, instead of 52.
STEP_SHARE: Final = 0.95
#: Waves of the pelvis' height a cycle that are kept: one a step and its first overtone; the body's weight has no more.
HEIGHT_WAVES: Final = (0, 2, 4)
IDLE_S: Final = 6.0
#: Angles of a leg over its own cycle from heel strike on, degrees: thigh forward of the vertical, knee bent, foot
#: pitched up, toes up.
_LEG: Final[Mapping[str, tuple[tuple[float, float], ...]]] = MappingProxyType({
    "thigh": ((0.0, 21.0), (0.12, 16.0), (0.3, -2.0), (0.5, -19.0), (0.62, -10.0), (0.75, 16.0), (0.88, 25.0)),
    "knee": ((0.0, 4.0), (0.12, 16.0), (0.3, 7.0), (0.42, 5.0), (0.52, 14.0), (0.62, 42.0), (0.72, 64.0), (0.85, 30.0),
             (0.95, 3.0)),
    "foot": ((0.0, 18.0), (0.08, 2.0), (0.15, 0.0), (0.38, 0.0), (0.5, -26.0), (0.62, -58.0), (0.75, -22.0),
             (0.88, 8.0), (0.95, 17.0)),
    "toes": ((0.0, 8.0), (0.12, 0.0), (0.38, 0.0), (0.5, 16.0), (0.6, 32.0), (0.7, 4.0), (0.85, 4.0)),
})  # fmt: skip
CURL: Final = 0.30  # of each knuckle of a relaxed hand, radians
PALM_BACK: Final = 0.5  # how much a hanging palm faces backwards, against inwards
STEP_WIDTH_M: Final = 0.10  # between the ankles, at a stature of 1.70 m
TOE_OUT_DEG: Final = 7.0
_STATURE_M: Final = 1.70


def walk(body: Body, style: Style = REGULAR) -> Motion:
    """Return walking on the spot in a style, two steps, closed into a circle; the regular one takes a second.

    The ground's speed is in ``speed_m_s``; standing feet follow it without sliding.
    """
    times = np.arange(style.cycle_frames + 1) / WALK_FRAMES_PER_S
    phase = times / times[-1]
    turn = 2.0 * np.pi * phase
    pelvis = turns.rotations_about(Y, np.radians(-style.pelvis_turn_deg) * np.cos(turn)) @ turns.rotations_about(
        Z, np.radians(style.pelvis_drop_deg) * np.sin(turn)
    )
    still = np.ones(len(turn))
    chest = turns.rotations_about(Y, np.radians(style.chest_turn_deg) * np.cos(turn)) @ turns.rotations_about(
        X, np.radians(style.lean_deg) * still
    )
    world = upright(body, pelvis, chest, turns.rotations_about(X, np.radians(style.bow_deg) * still))
    for side, own in zip(SIDES, (phase, phase + 0.5), strict=True):
        _swing_leg(body, world, side, own, style)
        _swing_arm(body, world, side, np.cos(2.0 * np.pi * own), style)
    root = np.zeros((len(times), 3))
    root[:, 0] = style.sway_m * np.sin(turn)
    rotations = shared_twist(body, turns.local_from_world(world, body.parents))
    name = {"regular": "walk", "run": "run"}.get(style.name, f"walk_{style.name}")
    motion = Motion(name, times, root, rotations, cyclic=True)
    motion = _smooth_height(on_ground(body, motion))
    return planted(body, replace(motion, speed_m_s=_ground_speed(body, motion)), stands_at(phase, style))


def stands_at(phase: Array, style: Style) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return (F,) whether the left and the right foot of a style's walk stand at shares (F,) of its cycle."""
    return np.mod(phase + 1e-9, 1.0) < style.stance, np.mod(phase + 0.5 + 1e-9, 1.0) < style.stance


def _smooth_height(motion: Motion) -> Motion:
    """Return a cyclic motion whose root height has only the slow harmonics of `HEIGHT_WAVES`."""
    waves = np.fft.rfft(motion.root_m[:-1, 1])
    kept = np.zeros_like(waves)
    kept[list(HEIGHT_WAVES)] = waves[list(HEIGHT_WAVES)]
    root = motion.root_m.copy()
    root[:-1, 1] = np.fft.irfft(kept, len(root) - 1)
    root[-1] = root[0]
    return replace(motion, root_m=root)


def idle(body: Body) -> Motion:
    """Return six seconds of standing: breath, a slow sway of chest and head, two blinks; closed into a circle."""
    times = np.linspace(0.0, IDLE_S, round(IDLE_S * FRAMES_PER_S) + 1)
    turn = 2.0 * np.pi * times / IDLE_S
    still = np.tile(np.eye(3), (len(times), 1, 1))
    breath = 0.012 * (1.0 - np.cos(2.0 * turn))
    chest = turns.rotations_about(Y, 0.02 * np.sin(turn)) @ turns.rotations_about(X, -breath)
    world = upright(body, still, chest)
    for side in SIDES:
        sign = 1.0 if side == "l" else -1.0
        aim_limb(body, world, side, "hip", still)
        aim_limb(body, world, side, "knee", still)
        for joint in (*FOOT, "metatarsal"):
            world[:, body.joint(f"{side}_{joint}")] = still
        out = turns.rotations_about(Z, np.full(len(times), body.arm_aside(side)) + sign * 0.5 * breath)
        aim_limb(body, world, side, "shoulder", out)
        aim_limb(body, world, side, "elbow", out @ turns.rotations_about(X, np.full(len(times), np.radians(-12.0))))
        follow(body, world, side)
    head = turns.rotations_about(Y, 0.05 * np.sin(turn + 0.7)) @ turns.rotations_about(X, 0.02 * np.sin(2.0 * turn))
    world[:, below(body, body.joint("skullbase"))] = head[:, None]
    blinks = np.maximum(*(np.clip(1.0 - np.abs(times - at) / 0.12, 0.0, 1.0) for at in (1.7, 4.6)))
    weights = {"eyeBlinkLeft": blinks, "eyeBlinkRight": blinks}
    rotations = shared_twist(body, turns.local_from_world(world, body.parents))
    return on_ground(body, Motion("idle", times, np.zeros((len(times), 3)), rotations, weights, cyclic=True))


def upright(body: Body, pelvis: Array, chest: Array, head: Array | None = None) -> Array:
    """Return (F, 94, 3, 3) orientations of a trunk turning from ``pelvis`` to ``chest`` (F, 3, 3).

    The neck turns on from there to ``head``; None is straight ahead.
    """
    head = np.broadcast_to(np.eye(3), chest.shape) if head is None else head
    world = np.tile(np.eye(3), (len(pelvis), len(body.names), 1, 1))
    world[:, body.joint("HumanoidRoot")] = world[:, body.joint("sacroiliac")] = pelvis
    for row, name in enumerate(SPINE):
        world[:, below(body, body.joint(name))] = turns.interpolated_rotations(pelvis, chest, (row + 1) / len(SPINE))[
            :, None
        ]
    for row, name in enumerate(NECK):
        part = 1.0 - (row + 1) / len(NECK)
        world[:, below(body, body.joint(name))] = turns.interpolated_rotations(head, chest, part)[:, None]
    for side in SIDES:
        world[:, below(body, body.joint(f"{side}_sternoclavicular"))] = chest[:, None]
    return world


def aim_limb(body: Body, world: Array, side: str, name: str, swing: Array) -> None:
    """Turn one limb's joint so that at no ``swing`` (F, 3, 3) it hangs straight down, whatever the rest pose."""
    chain = {"hip": "knee", "knee": "ankle", "shoulder": "elbow", "elbow": "wrist"}
    joint, end = body.joint(f"{side}_{name}"), body.joint(f"{side}_{chain[name]}")
    hanging = turns.rotations_between(body.joints_m[end] - body.joints_m[joint], np.array([0.0, -1.0, 0.0]))
    world[:, joint] = swing @ hanging


def follow(body: Body, world: Array, side: str) -> None:
    """Let a hand hang from its forearm: palm to the thigh, fingers a little curled."""
    elbow, wrist = body.joint(f"{side}_elbow"), body.joint(f"{side}_wrist")
    palm, forearm = palm_normal(body, side), world[:, elbow]
    along = forearm @ (body.joints_m[wrist] - body.joints_m[elbow])
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    inward = np.array([-1.0 if side == "l" else 1.0, 0.0, -PALM_BACK])
    now, wanted = (
        vectors - np.einsum("fa,fa->f", vectors, along)[:, None] * along
        for vectors in (forearm @ palm, np.broadcast_to(inward, along.shape))
    )
    twist = turns.rotations_between(now, wanted)
    world[:, below(body, wrist)] = (twist @ forearm)[:, None]
    for finger in FINGERS:
        bones, axis = knuckles(body, side, finger)
        for number, knuckle in enumerate(bones, start=1):
            world[:, below(body, knuckle)] = (twist @ forearm @ turns.matrices(axis * number * CURL))[:, None]


def _swing_leg(body: Body, world: Array, side: str, phase: Array, style: Style) -> None:
    shares = {"thigh": style.thigh, "knee": style.knee, "foot": style.foot, "toes": style.foot}
    angle = {name: shares[name] * np.radians(_curve(knots, phase)) for name, knots in _LEG.items()}
    angle["thigh"] += np.radians(style.crouch_deg)
    angle["knee"] += 2.0 * np.radians(style.crouch_deg)
    hip, knee, ankle = (body.joints_m[body.joint(f"{side}_{name}")] for name in ("hip", "knee", "ankle"))
    length = np.linalg.norm(hip - knee) + np.linalg.norm(knee - ankle)
    sign = 1.0 if side == "l" else -1.0
    half = 0.5 * STEP_WIDTH_M * length / (0.48 * _STATURE_M)
    # straight down at most: who walks wider waddles, and trousers give way
    aside = max(float(np.arcsin((half - abs(hip[0])) / length)), min(body.leg_clearance_rad, 0.0))
    inward = turns.rotations_about(Z, np.full(len(phase), sign * aside))
    thigh = inward @ turns.rotations_about(X, -angle["thigh"])
    aim_limb(body, world, side, "hip", thigh)
    aim_limb(body, world, side, "knee", thigh @ turns.rotations_about(X, angle["knee"]))
    toe = body.joints_m[body.joint(f"{side}_metatarsal")] - ankle
    outward = np.arctan2(toe[0], toe[2])
    turned = turns.rotations_about(Y, np.full(len(phase), sign * np.radians(TOE_OUT_DEG) - outward))
    foot = (
        turned
        @ turns.rotations_about(Y, np.full(len(phase), outward))
        @ turns.rotations_about(X, -angle["foot"])
        @ turns.rotations_about(Y, np.full(len(phase), -outward))
    )
    for name in FOOT:
        world[:, body.joint(f"{side}_{name}")] = foot
    world[:, body.joint(f"{side}_metatarsal")] = foot @ turns.rotations_about(X, -angle["toes"])


def _swing_arm(body: Body, world: Array, side: str, back: Array, style: Style) -> None:
    """Swing an arm against its own leg: ``back`` (F,) is 1 at its heel strike."""
    if style.shrug_deg:
        raised = turns.rotations_about(
            Z, np.full(len(back), np.radians(style.shrug_deg) * (1.0 if side == "l" else -1.0))
        )
        collar = body.joint(f"{side}_sternoclavicular")
        world[:, below(body, collar)] = (raised @ world[:, collar])[:, None]
    out = turns.rotations_about(Z, np.full(len(back), body.arm_aside(side)))
    forward = np.radians(style.arm_deg) * (-back - 0.1)
    bent = np.radians(np.interp(-back, (-1.0, 1.0), style.elbow_deg))
    aim_limb(body, world, side, "shoulder", out @ turns.rotations_about(X, -forward))
    aim_limb(body, world, side, "elbow", out @ turns.rotations_about(X, -forward - bent))
    follow(body, world, side)


def _curve(knots: tuple[tuple[float, float], ...], phase: Array) -> Array:
    """Return the smooth periodic curve through knots of (phase, value) at phases of any turn."""
    place, value = np.array([*knots, (1.0 + knots[0][0], knots[0][1])]).T
    return np.asarray(CubicSpline(place, value, bc_type="periodic")(np.mod(phase, 1.0)))


def _ground_speed(body: Body, motion: Motion) -> float:
    """Return the speed at which the standing feet carry the ground backwards, metres a second."""
    step = float(np.diff(motion.times_s).mean())
    left, right = body.sole_points(body.world(motion), motion.root_m)
    speeds = []
    for points, rolls in zip((left, right), body.rolls, strict=True):
        ball = np.einsum("n,fna->fa", rolls[1], points)
        flat = np.diff(ball[:, 1]) / step
        back = -np.diff(ball[:, 2]) / step
        stands = (np.abs(flat) < 0.15) & (back > 0.2) & (ball[1:, 1] < 0.03)
        speeds.append(back[stands])
    return STEP_SHARE * float(np.median(np.concatenate(speeds)))
