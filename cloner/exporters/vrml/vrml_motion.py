"""A motion as VRML97: a clock, interpolators for the joints, and routes.

References
----------
ISO/IEC 14772-1:1997, 6.49 (TimeSensor), 6.32 (OrientationInterpolator), 6.38 (PositionInterpolator).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.exporters.vrml.vrml_segments import row_text
from cloner.records.motions import Motion

#: Smaller turns of a joint in a whole motion are left out, radians; taste.
STILL: Final = 1e-3


def motion_text(motion: Motion, joint_names: Sequence[str], root: str) -> Iterator[str]:
    """Yield nodes and routes that play a motion for ever from the moment the world is loaded.

    Parameters
    ----------
    motion : Motion
    joint_names : sequence of str
        In the order of the motion's joints; their nodes are named ``hanim_<joint>``.
    root : str
        The joint that moves in space.
    """
    yield from motion_nodes(motion, joint_names, root)
    yield from motion_routes(motion, joint_names, root)


def motion_nodes(motion: Motion, joint_names: Sequence[str], root: str, *, loop: bool = True) -> Iterator[str]:
    """Yield the clock and the interpolators; a clock that is not ``loop`` goes from its first start on, for ever."""
    duration = float(motion.times_s[-1])
    keys = " ".join(f"{time / duration:.4f}" for time in motion.times_s)
    waits = "" if loop else "startTime -1 stopTime 0 "  # it has stopped, until a later start
    yield f"DEF {motion.name}_clock TimeSensor {{ cycleInterval {duration:.4f} loop TRUE {waits}}}\n"
    for name, turns in joint_turns(motion, joint_names):
        values = ", ".join(f"{row_text(row[:3])} {row[3]:.4f}" for row in turns)
        yield f"DEF {motion.name}_{name}_rotation OrientationInterpolator {{ key [ {keys} ] keyValue [ {values} ] }}\n"
    values = ", ".join(row_text(row) for row in motion.root_m)
    yield f"DEF {motion.name}_{root}_translation PositionInterpolator {{ key [ {keys} ] keyValue [ {values} ] }}\n"


def motion_routes(motion: Motion, joint_names: Sequence[str], root: str) -> Iterator[str]:
    """Yield the routes from the clock through the interpolators to the joints."""
    routes = [(f"{name}_rotation", f"{name}.set_rotation") for name, _ in joint_turns(motion, joint_names)]
    for node, target in (*routes, (f"{root}_translation", f"{root}.set_translation")):
        yield f"ROUTE {motion.name}_clock.fraction_changed TO {motion.name}_{node}.set_fraction\n"
        yield f"ROUTE {motion.name}_{node}.value_changed TO hanim_{target}\n"


def joint_turns(motion: Motion, joint_names: Sequence[str]) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Yield the joints that move and their (F, 4) turns: a unit axis and an angle, radians."""
    for joint, name in enumerate(joint_names):
        rotations = motion.rotations[:, joint]
        if np.abs(rotations).max() < STILL:
            continue
        angle = np.linalg.norm(rotations, axis=1, keepdims=True)
        axis = np.where(angle > 1e-9, rotations / np.maximum(angle, 1e-9), [0.0, 0.0, 1.0])
        yield name, np.hstack([axis, angle])
