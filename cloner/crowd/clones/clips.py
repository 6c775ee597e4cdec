"""Motions of the crowd as frames of bone matrices, one set per clone.

References
----------
McDonnell et al. 2007: cycles of one second; 16 poses a second suffice in the background, 30 in front.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np

from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.motion.captures.acclaim import read_acclaim
from cloner.motion.captures.bvh import read_bvh
from cloner.motion.captures.retarget import retarget
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import SIDES, Body, body_of
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.acts import ACTS
from cloner.motion.moves.contact import on_ground
from cloner.motion.moves.cycle import walk_cycle
from cloner.motion.moves.gait import aim_limb, follow, idle, stands_at, upright, walk
from cloner.motion.moves.planting import planted
from cloner.motion.moves.slide import posed_at
from cloner.motion.moves.styles import REGULAR, RUN, STYLES, Style, suited
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

#: Frames of a walk that geometry shows; impostors take every third of them, or as ``--poses`` says.
WALK_FRAMES: Final = 48
IDLE_FRAMES: Final = 16
IDLE_POSES: Final = 2  # breath and sway of a standing person are under a texel where impostors are shown
SIT_FRAMES: Final = 1
#: Two frames a clap of `acts.applaud`, between which whoever is near is blended; taste.
ACT_FRAMES: Final = 24
ACT_POSES: Final = 8
CAPTURES: Final = {".bvh": read_bvh, ".amc": read_acclaim}


@dataclass(frozen=True, slots=True, eq=False)
class Clip:
    """One motion of one clone.

    Attributes
    ----------
    name : str
    seconds : float
        Length of the cycle.
    speed_m_s : float
        At which the ground runs back under the feet.
    frames : (F, J, 3, 4) float64
        Posed-from-rest transforms of the joints; the cycle closes after the last.
    rotations : (F, J, 3) float64, root_m : (F, 3) float64
        The same as turns of the joints against their parents, and the root's place.
    poses : int
        That coarse levels and impostors show: every ``F // poses``-th frame.
    far : str
        Name of the clip whose impostors stand for it, "" for its own: people of 38 px tell walks by their steps alone.
    around : bool
        Seen from all around; else from the front half alone, as in a stand.
    """

    name: str
    seconds: float
    speed_m_s: float
    frames: Array
    rotations: Array
    root_m: Array
    poses: int
    around: bool = True
    far: str = ""


def make_clips(clone: Clone, poses: int, walks: Sequence[Path] = (), *, feelings: bool = False) -> tuple[Clip, ...]:
    """Return walk, idle, sitting, the walks of feelings and the acts if requested, and the captured walks of a clone.

    Raises
    ------
    ClonerError
        If a capture cannot be read or holds no walk.
    """
    body = body_of(clone)
    found = [
        _clip(clone, sample_walk(body, suited(REGULAR, clone.sex, clone.age_years)), poses),
        _clip(clone, resample_motion(idle(body), IDLE_FRAMES), IDLE_POSES),
        _clip(clone, resample_motion(sitting(body), SIT_FRAMES), SIT_FRAMES, around=False),
    ]
    if feelings:
        others = [*(style for style in STYLES.values() if style is not REGULAR), RUN]
        own = [suited(style, clone.sex, clone.age_years) for style in others]
        found += [_clip(clone, sample_walk(body, style), poses, far=found[0].name) for style in own]
        found += [
            _clip(clone, resample_motion(act(body), ACT_FRAMES), ACT_POSES, far=found[1].name) for act in ACTS.values()
        ]
    return (*found, *(_clip(clone, resample_motion(capture_cycle(body, path), WALK_FRAMES), poses) for path in walks))


def sample_walk(body: Body, style: Style) -> Motion:
    """Return a walk at the shown frames, its feet planted between them.

    Planted between others, 60 a second, feet slid by up to 17 mm a step from one shown frame to the next. Whoever is
    shown between frames as well is seen low above the ground when a foot has just left it: it rises for two.
    """
    motion = resample_motion(walk(body, style), WALK_FRAMES)
    return planted(body, motion, stands_at(motion.times_s / motion.times_s[-1], style), straight=2)


def resample_motion(motion: Motion, count: int) -> Motion:
    """Return a motion with a number of frames, and the first once more."""
    at = np.arange(count + 1) * float(motion.times_s[-1]) / count
    rotations, root = posed_at(motion, at)
    return Motion(motion.name, at, root, rotations, cyclic=True, speed_m_s=motion.speed_m_s)


def capture_cycle(body: Body, path: Path) -> Motion:
    """Return a motion capture as an endless walk on the spot.

    Raises
    ------
    ClonerError
        If it cannot be read or holds no walk.
    """
    if path.suffix.lower() not in CAPTURES:
        raise ClonerError("this is no capture of a walk", f"Give {' or '.join(CAPTURES)} files", path.name)
    return walk_cycle(body, retarget(CAPTURES[path.suffix.lower()](path), body, name=path.stem))


def sitting(body: Body) -> Motion:
    """Return a person sitting upright on a bench, hands on the thighs; one frame that lasts a second.

    Feet are as far apart as in standing: who sits down or gets up moves neither.
    """
    still = np.tile(np.eye(3), (2, 1, 1))
    world = upright(body, still, turns.rotations_about(0, np.full(2, 0.06)))
    for side in SIDES:
        aim_limb(body, world, side, "hip", turns.rotations_about(0, np.full(2, -1.5)))
        aim_limb(body, world, side, "knee", still)
        for joint in ("ankle", "subtalar", "midtarsal", "metatarsal"):
            world[:, body.joint(f"{side}_{joint}")] = still
        out = turns.rotations_about(2, np.full(2, body.arm_aside(side)))
        aim_limb(body, world, side, "shoulder", out @ turns.rotations_about(0, np.full(2, -0.35)))
        aim_limb(body, world, side, "elbow", out @ turns.rotations_about(0, np.full(2, -1.25)))
        follow(body, world, side)
    rotations = shared_twist(body, turns.local_from_world(world, body.parents))
    return on_ground(body, Motion("sit", np.array([0.0, 1.0]), np.zeros((2, 3)), rotations, cyclic=True))


def bone_frames(clone: Clone, root_m: Array, rotations: Array) -> Array:
    """Return (F, J, 3, 4) posed-from-rest transforms of a clone's joints, its root moved by (F, 3)."""
    parents = load_generic().joint_parents.astype(np.int32)
    frames = joint_transforms(clone.joints_m, parents, rotations)[:, :, :3]
    frames[..., 3] += root_m[:, None]
    return frames


def _clip(clone: Clone, motion: Motion, poses: int, *, around: bool = True, far: str = "") -> Clip:
    """Return a motion whose last frame equals its first as a clip."""
    rotations, root = motion.rotations[:-1], motion.root_m[:-1]
    frames = bone_frames(clone, root, rotations)
    seconds, count = float(motion.times_s[-1]), len(frames)
    return Clip(motion.name, seconds, motion.speed_m_s, frames, rotations, root, min(poses, count), around, far)
