"""Acts of standing people: look, wave, point, photograph, pay, applaud, lift; each a closed cycle.

The lower body is that of the idle; hands go to places told in shares of the arm's length, so that they meet and reach
whatever the person's size. All places and times are taste.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Final

import numpy as np

from cloner.easing import smoothstep
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import SIDES, Body, below
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.gait import FRAMES_PER_S, X, Y, aim_limb, follow, idle
from cloner.motion.moves.slide import posed_at
from cloner.motion.moves.wave import wave
from cloner.records.arrays import Array
from cloner.records.motions import Motion

#: How long each act takes, seconds, and claps in one (taste).
LOOK_S: Final = 6.0
POINT_S: Final = 4.0
PHOTOGRAPH_S: Final = 4.0
PAY_S: Final = 4.0
APPLAUD_S: Final = 2.0
CLAPS: Final = 4
LIFT_S: Final = 8.0
#: Who lifts something from the ground bends so far from the hips and on along the spine, and leans thighs and shanks so
#: far, radians; the wrists go so far outwards, up and ahead of the feet, metres for somebody of 1.7 m.
BEND, CURL, THIGH, SHANK = 1.1, 0.5, 1.25, 0.9
LOW_M: Final = (0.14, 0.20, 0.46)
#: An arm never gets straighter than this share of its length: elbows must not snap.
REACH: Final = 0.985
_DOWN: Final = np.array([0.0, -1.0, 0.0])


def look(body: Body) -> Motion:
    """Return somebody who looks at something, a hand at the chin."""
    motion, world, turn = _standing(body, LOOK_S, "look")
    _nod(
        body,
        world,
        turns.rotations_about(Y, 0.10 * np.sin(turn)) @ turns.rotations_about(X, -0.06 + 0.05 * np.sin(2.0 * turn)),
    )
    _reach(body, world, motion, "r", _of_head(body, world, motion, "r", (0.14, -0.30, 0.34)), (0.5, -1.0, 0.0))
    return _made(body, motion, world)


def point(body: Body) -> Motion:
    """Return somebody who points ahead with the right arm."""
    motion, world, turn = _standing(body, POINT_S, "point")
    shake = 0.02 * np.sin(2.0 * turn)
    place = _of_shoulder(body, world, motion, "r", (0.12, 0.10, 0.97)) + np.outer(shake, (0.0, 1.0, 0.0))
    _reach(body, world, motion, "r", place, (1.0, -1.0, 0.0))
    hand = world[:, body.joint("r_wrist")]
    world[:, below(body, body.joint("r_index1"))] = hand[:, None]
    return _made(body, motion, world)


def photograph(body: Body) -> Motion:
    """Return somebody who takes a picture, both hands before the face."""
    motion, world, turn = _standing(body, PHOTOGRAPH_S, "photograph")
    nearer = 0.03 * np.sin(turn)
    for side in SIDES:
        place = _of_head(body, world, motion, side, (0.22, -0.20, 0.60)) + np.outer(nearer, (0.0, 0.0, 1.0))
        _reach(body, world, motion, side, place, (0.4, -1.0, 0.0))
    return _made(body, motion, world)


def pay(body: Body) -> Motion:
    """Return somebody who hands something over a counter and takes it back, eyes on the hand."""
    motion, world, turn = _standing(body, PAY_S, "pay")
    given = (0.5 - 0.5 * np.cos(turn))[:, None]
    _nod(body, world, turns.rotations_about(X, np.full(len(turn), 0.30)))
    near, far = (_of_shoulder(body, world, motion, "r", place) for place in ((0.05, -0.46, 0.42), (0.0, -0.38, 0.84)))
    _reach(body, world, motion, "r", near + given * (far - near), (0.3, -1.0, -0.4))
    return _made(body, motion, world)


def applaud(body: Body) -> Motion:
    """Return somebody who claps the hands before the chest."""
    motion, world, turn = _standing(body, APPLAUD_S, "applaud")
    apart = 0.24 - 0.07 * np.cos(CLAPS * turn)
    for side in SIDES:
        place = _of_head(body, world, motion, side, (0.0, -0.50, 0.56))
        place[:, 0] += (1.0 if side == "l" else -1.0) * apart * _arm_m(body, side)
        _reach(body, world, motion, side, place, (0.35, -1.0, 0.0))
    return _made(body, motion, world)


def lift(body: Body) -> Motion:
    """Return somebody who picks something up with both hands, lifts it before the face and drops it."""
    motion, world, turn = _standing(body, LIFT_S, "lift")
    hanging = {side: _wrist(body, world, motion, side) for side in SIDES}
    share = turn / (2.0 * np.pi)
    down = smoothstep(share, 0.0, 0.3) * (1.0 - smoothstep(share, 0.4, 0.66))
    up = smoothstep(share, 0.42, 0.66) * (1.0 - smoothstep(share, 0.84, 1.0))
    motion = _bent(body, world, motion, down)
    size = body.joints_m[body.joint("skullbase"), 1] / 1.52  # of somebody of 1.7 m
    for side in SIDES:
        low = _sided(side, LOW_M) * size
        high = _of_head(body, world, motion, side, (0.27, -0.20, 0.62))
        place = hanging[side] + (low - hanging[side]) * down[:, None]
        _reach(body, world, motion, side, place + (high - place) * up[:, None], (0.7, -0.6, -0.3))
    return _made(body, motion, world)


#: By the words that scenarios have for them.
ACTS: Final[Mapping[str, Callable[[Body], Motion]]] = MappingProxyType({
    "look": look, "wave": wave, "point": point, "photograph": photograph, "pay": pay, "applaud": applaud, "lift": lift,
})  # fmt: skip


def _wrist(body: Body, world: Array, motion: Motion, side: str) -> Array:
    return np.asarray(
        turns.joint_positions(world, body.joints_m, body.parents, motion.root_m)[:, body.joint(f"{side}_wrist")]
    )


def _bent(body: Body, world: Array, motion: Motion, share: Array) -> Motion:
    """Bend (F,) shares of a bow into the orientations; the feet stay, so the root moves, which is returned."""
    ankles = [body.joint("l_ankle"), body.joint("r_ankle")]
    legs = {one for side in SIDES for one in below(body, body.joint(f"{side}_hip"))}
    before = turns.joint_positions(world, body.joints_m, body.parents, motion.root_m)[:, ankles].mean(axis=1)
    spine = [body.joint(name) for name in ("vl4", "vl1", "vt10", "vt6", "vt1")]
    for joint in range(len(body.joints_m)):
        if joint not in legs:
            curl = sum(joint in below(body, one) for one in spine) / len(spine)
            world[:, joint] = turns.rotations_about(X, share * (BEND + CURL * curl)) @ world[:, joint]
    for side in SIDES:
        for name, lean in (("hip", -THIGH), ("knee", SHANK)):
            joint = body.joint(f"{side}_{name}")
            world[:, joint] = turns.rotations_about(X, share * lean) @ world[:, joint]
    after = turns.joint_positions(world, body.joints_m, body.parents, motion.root_m)[:, ankles].mean(axis=1)
    return replace(motion, root_m=motion.root_m + before - after)


def _standing(body: Body, seconds: float, name: str) -> tuple[Motion, Array, Array]:
    """Return some seconds of a slower or faster idle: orientations (F, J, 3, 3) and phase (F,), 0 to 2 pi."""
    own = idle(body)
    times = np.linspace(0.0, seconds, round(seconds * FRAMES_PER_S) + 1)
    rotations, root = posed_at(own, times * own.times_s[-1] / seconds)
    motion = Motion(name, times, root, rotations, cyclic=True)
    return motion, body.world(motion), 2.0 * np.pi * times / seconds


def _made(body: Body, motion: Motion, world: Array) -> Motion:
    return replace(motion, rotations=shared_twist(body, turns.local_from_world(world, body.parents)))


def _nod(body: Body, world: Array, head: Array) -> None:
    """Turn the head by (F, 3, 3)."""
    for joint in below(body, body.joint("skullbase")):
        world[:, joint] = head @ world[:, joint]


def _arm_m(body: Body, side: str) -> float:
    """Return the length of an arm from shoulder to wrist, metres."""
    shoulder, elbow, wrist = (body.joints_m[body.joint(f"{side}_{name}")] for name in ("shoulder", "elbow", "wrist"))
    return float(np.linalg.norm(elbow - shoulder) + np.linalg.norm(wrist - elbow))


def _of_head(body: Body, world: Array, motion: Motion, side: str, shares: tuple[float, float, float]) -> Array:
    """Return (F, 3) places outwards, above and before the skull base, in shares of the arm's length."""
    head = turns.joint_positions(world, body.joints_m, body.parents, motion.root_m)[:, body.joint("skullbase")]
    return head + _sided(side, shares) * _arm_m(body, side)


def _of_shoulder(body: Body, world: Array, motion: Motion, side: str, shares: tuple[float, float, float]) -> Array:
    """Return (F, 3) places outwards, above and before the shoulder, in shares of the arm's length."""
    shoulder = turns.joint_positions(world, body.joints_m, body.parents, motion.root_m)[
        :, body.joint(f"{side}_shoulder")
    ]
    return shoulder + _sided(side, shares) * _arm_m(body, side)


def _sided(side: str, way: tuple[float, float, float]) -> Array:
    return np.array(way) * (1.0 if side == "l" else -1.0, 1.0, 1.0)


def _reach(
    body: Body, world: Array, motion: Motion, side: str, wrist_m: Array, elbow_way: tuple[float, float, float]
) -> None:
    """Bend an arm so that its wrist is at (F, 3) places, the elbow towards a way (outwards, up, ahead)."""
    shoulder = turns.joint_positions(world, body.joints_m, body.parents, motion.root_m)[
        :, body.joint(f"{side}_shoulder")
    ]
    rest = [body.joints_m[body.joint(f"{side}_{name}")] for name in ("shoulder", "elbow", "wrist")]
    upper, fore = float(np.linalg.norm(rest[1] - rest[0])), float(np.linalg.norm(rest[2] - rest[1]))
    straight = wrist_m - shoulder
    far = np.linalg.norm(straight, axis=1)
    along = straight / far[:, None]
    far = np.clip(far, abs(upper - fore) + 1e-3, REACH * (upper + fore))
    aside = _sided(side, elbow_way) - (along @ _sided(side, elbow_way))[:, None] * along
    aside /= np.linalg.norm(aside, axis=1, keepdims=True)
    cosine = np.clip((upper**2 + far**2 - fore**2) / (2.0 * upper * far), -1.0, 1.0)
    to_elbow = upper * (cosine[:, None] * along + np.sqrt(1.0 - cosine**2)[:, None] * aside)
    to_wrist = far[:, None] * along - to_elbow
    for name, bone in (("shoulder", to_elbow), ("elbow", to_wrist)):
        aim_limb(body, world, side, name, turns.rotations_between(np.broadcast_to(_DOWN, bone.shape), bone))
    follow(body, world, side)
