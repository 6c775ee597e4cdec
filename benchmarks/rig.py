"""Pictures of a clone in five hard poses, with the fit's skeleton above and the corrected one below.

    python benchmarks/rig.py RESULT... --out docs/pictures

RESULT is a result's folder or its clone.npz. Writes ``rig_<folder>.jpg``: T-pose, arms up, sitting, elbow and knee bent
by 120 degrees, a fist, and a palm turned by 90 degrees (above: at the wrist alone, below: shared with the elbow).
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.generic.layers import clone_layers
from cloner.geometry.articulation.fingers import FINGERS, knuckles
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.geometry.cameras.viewpoints import framing_cameras
from cloner.motion.flesh.rest import t_pose
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import SIDES, Body, below, body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.gait import aim_limb
from cloner.picture import load_clone_at
from cloner.records.clones import Clone
from cloner.render import draw

Array = NDArray[np.float64]

PANEL: Final = (300, 420)  # pixels
FIST_DEG: Final = (80.0, 95.0, 65.0)
THUMB_DEG: Final = (20.0, 35.0, 45.0)


def _about(axis: int, degrees: float) -> Array:
    return turns.rotations_about(axis, np.array([np.radians(degrees)]))


def _world(body: Body) -> Array:
    return np.tile(np.eye(3), (1, len(body.names), 1, 1))


def _hand_along(body: Body, world: Array, side: str) -> None:
    world[:, below(body, body.joint(f"{side}_wrist"))] = world[:, [body.joint(f"{side}_elbow")]]


def arms_up(body: Body) -> Array:
    """Return (94, 3) rotations of arms held up."""
    world = _world(body)
    for side in SIDES:
        sign = 1.0 if side == "l" else -1.0
        world[:, below(body, body.joint(f"{side}_sternoclavicular"))] = _about(2, sign * 20.0)
        for name in ("shoulder", "elbow"):
            aim_limb(body, world, side, name, _about(2, sign * 170.0))
        _hand_along(body, world, side)
    return np.asarray(turns.local_from_world(world, body.parents)[0])


def sitting(body: Body) -> Array:
    """Return rotations of somebody who sits, forearms level."""
    world = _world(body)
    for side in SIDES:
        aim_limb(body, world, side, "hip", _about(0, -90.0))
        aim_limb(body, world, side, "knee", _about(0, 0.0))
        world[:, below(body, body.joint(f"{side}_ankle"))] = np.eye(3)
        aside = turns.rotations_about(2, np.array([body.arm_aside(side)]))
        aim_limb(body, world, side, "shoulder", aside @ _about(0, -15.0))
        aim_limb(body, world, side, "elbow", _about(0, -85.0))
        _hand_along(body, world, side)
    return np.asarray(turns.local_from_world(world, body.parents)[0])


def bent(body: Body) -> Array:
    """Return rotations with elbows and the left knee bent by 120 degrees."""
    world = _world(body)
    for side in SIDES:
        aim_limb(body, world, side, "shoulder", _about(0, 0.0))
        aim_limb(body, world, side, "elbow", _about(0, -120.0))
        _hand_along(body, world, side)
    aim_limb(body, world, "l", "hip", _about(0, -60.0))
    aim_limb(body, world, "l", "knee", _about(0, 60.0))
    world[:, below(body, body.joint("l_ankle"))] = world[:, [body.joint("l_knee")]]
    return np.asarray(turns.local_from_world(world, body.parents)[0])


def fist(body: Body) -> Array:
    """Return rotations of two fists."""
    rotations = np.zeros((len(body.names), 3))
    for side in SIDES:
        for finger in (*FINGERS, "thumb"):
            bones, axis = knuckles(body, side, finger)
            angles = THUMB_DEG if finger == "thumb" else FIST_DEG
            for knuckle, degrees in zip(bones, angles, strict=True):
                rotations[knuckle] = axis * np.radians(degrees)
    return rotations


def wrung(body: Body) -> Array:
    """Return rotations of a T-pose with the hands turned by 90 degrees more."""
    world = turns.world_from_local(t_pose(body)[None], body.parents)
    for side in SIDES:
        elbow, wrist = body.joint(f"{side}_elbow"), body.joint(f"{side}_wrist")
        along = world[0, elbow] @ (body.joints_m[wrist] - body.joints_m[elbow])
        hand = below(body, wrist)
        world[:, hand] = turns.matrices(along / np.linalg.norm(along) * np.pi / 2.0) @ world[:, hand]
    return np.asarray(turns.local_from_world(world, body.parents)[0])


#: Pose, azimuth in degrees, joints in the picture (none: all of the person) and how much around them, metres.
PANELS: Final[tuple[tuple[Callable[[Body], Array], float, tuple[str, ...], float], ...]] = (
    (t_pose, 0.0, (), 0.0),
    (arms_up, 0.0, (), 0.0),
    (sitting, 60.0, (), 0.0),
    (bent, 90.0, ("l_elbow",), 0.16),
    (bent, 90.0, ("l_knee",), 0.2),
    (fist, 60.0, ("l_middle1",), 0.12),
    (wrung, 0.0, ("l_wrist",), 0.12),
)


def sheet(clone: Clone) -> NDArray[np.uint8]:
    """Return the picture: a column a pose; above the fit's skeleton, below the corrected one."""
    rows = []
    for own, share in ((clone, False), (centre_joints(clone), True)):
        body = body_of(own)
        rows.append(np.hstack([_panel(own, body, panel, share=share) for panel in PANELS]))
    return np.vstack(rows)


def _panel(clone: Clone, body: Body, panel: tuple, *, share: bool) -> NDArray[np.uint8]:
    pose, azimuth, names, around = panel
    rotations = pose(body)
    rotations = shared_twist(body, rotations[None])[0] if share else rotations
    layers = clone_layers(clone, rotations)
    points = np.vstack([layer.vertices_m for layer in layers])
    if names:
        turned = joint_transforms(clone.joints_m, body.parents, rotations)
        places = [(turned[j] @ [*clone.joints_m[j], 1.0])[:3] for j in map(body.joint, names)]
        points = np.vstack([place + around * np.array(way) for place in places for way in ((1, 1, 1), (-1, -1, -1))])
    (camera,) = framing_cameras(points, [azimuth], *PANEL)
    return draw(layers, camera, shading="soft", background=(240, 240, 240))


def main() -> None:
    """Write one sheet a result."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="+", type=Path)
    parser.add_argument("--out", type=Path, default=Path("docs/pictures"))
    asked = parser.parse_args()
    for result in asked.results:
        folder = result if result.is_dir() else result.parent
        path = asked.out / f"rig_{folder.parent.name if folder.name == 'plain' else folder.name}.jpg"
        path.parent.mkdir(parents=True, exist_ok=True)
        cv2.imwrite(str(path), sheet(load_clone_at(result))[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])
        sys.stdout.write(f"{path}\n")


if __name__ == "__main__":
    main()
