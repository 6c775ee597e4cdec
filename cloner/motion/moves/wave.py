"""A greeting: an idle stance with the right arm raised and waving."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from cloner.easing import smoothstep
from cloner.geometry.articulation.fingers import palm_normal
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import Body, below
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.gait import X, Z, aim_limb, idle
from cloner.records.arrays import Array
from cloner.records.motions import Motion

#: Of the upper arm from hanging, and of the forearm from hanging to upright, degrees; taste.
LIFTED_DEG: Final = 62.0
UPRIGHT_DEG: Final = 165.0
SWING_DEG: Final = 20.0
FORWARD_DEG: Final = 18.0
WAVES: Final = 4
UP_S: Final = (0.6, 1.3, 4.2, 5.0)  # begins to lift, is up, begins to sink, is down


def wave(body: Body) -> Motion:
    """Return six seconds of standing in which the right hand waves, closed into a circle."""
    standing = idle(body)
    times = standing.times_s
    world = body.world(standing)
    share = smoothstep(np.interp(times, UP_S, (0.0, 1.0, 1.0, 0.0)))
    swing = np.sin(2.0 * np.pi * WAVES * (times - UP_S[1]) / (UP_S[2] - UP_S[1])) * share
    hanging = abs(body.arm_aside("r"))
    upper = np.radians(LIFTED_DEG) * share + hanging * (1.0 - share)
    fore = np.radians(UPRIGHT_DEG) * share + hanging * (1.0 - share) + np.radians(SWING_DEG) * swing
    ahead = turns.rotations_about(X, -np.radians(FORWARD_DEG) * share - np.radians(12.0) * (1.0 - share))
    aim_limb(body, world, "r", "shoulder", turns.rotations_about(Z, -upper))
    aim_limb(body, world, "r", "elbow", ahead @ turns.rotations_about(Z, -fore))
    _show_palm(body, world, share)
    rotations = shared_twist(body, turns.local_from_world(world, body.parents))
    return replace(standing, name="wave", rotations=rotations)


def _show_palm(body: Body, world: Array, share: Array) -> None:
    """Turn the right hand, as far as it is lifted, so that its palm faces forward and its fingers are straight."""
    elbow, wrist = body.joint("r_elbow"), body.joint("r_wrist")
    forearm = world[:, elbow]
    along = forearm @ (body.joints_m[wrist] - body.joints_m[elbow])
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    inward = np.array([1.0, 0.0, -0.5])
    aim = share[:, None] * np.array([0.0, 0.0, 1.0]) + (1.0 - share)[:, None] * inward
    now, wanted = (
        vectors - np.einsum("fa,fa->f", vectors, along)[:, None] * along
        for vectors in (forearm @ palm_normal(body, "r"), aim)
    )
    world[:, below(body, wrist)] = (turns.rotations_between(now, wanted) @ forearm)[:, None]
