"""Motions as X3D: clocks, interpolators for joints and displacer weights, and routes.

The first motion plays at once; a click on the person stops it and starts the second.

References
----------
ISO/IEC 19775-1:2023 (X3D 4), 8 (TimeSensor), 19 (interpolators), 20 (TouchSensor), 26.3.1 (HAnimDisplacer's weight).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.exporters.hanim.hanim_names import identifier, node_name
from cloner.exporters.vrml.vrml_motion import joint_turns
from cloner.records.arrays import Array
from cloner.records.motions import Motion

#: The sensor that is clicked on.
TOUCH: Final = "touch"
#: Smaller weights of a target in a whole motion are left out; taste.
_LEAST_WEIGHT: Final = 1e-3


def motions_text(motions: Sequence[Motion], joints: Sequence[str], targets: Sequence[str]) -> Iterator[str]:
    """Yield clocks, interpolators and routes of the first two motions.

    What one of them moves the other one sets too: nothing stays as the first left it.

    Parameters
    ----------
    motions : sequence of Motion
    joints : sequence of str
        In the order of the motions' joints, the root first; their nodes are named ``hanim_<joint>``.
    targets : sequence of str
        The face's targets that have a displacer; its node is named ``face_<target>``.
    """
    played = list(motions[:2])
    moved = {name for motion in played for name, _ in joint_turns(motion, joints)}
    faces = [name for name in targets if any(motion.weights[name].max() > _LEAST_WEIGHT for motion in played
                                             if name in motion.weights)]  # fmt: skip
    for number, motion in enumerate(played):
        yield from _motion(motion, joints, moved, faces, waits=number > 0)
    if len(played) > 1:
        for motion, field in zip(played, ("stopTime", "startTime"), strict=True):
            yield f'<ROUTE fromNode="{TOUCH}" fromField="touchTime" toNode="{_clock(motion)}" toField="set_{field}"/>\n'


def _clock(motion: Motion) -> str:
    return f"{node_name(motion.name)}_clock"


def _motion(
    motion: Motion, joints: Sequence[str], moved: set[str], faces: Sequence[str], *, waits: bool
) -> Iterator[str]:
    """Yield a motion; one that ``waits`` goes on for ever from its first start."""
    duration, name = float(motion.times_s[-1]), node_name(motion.name)
    keys = motion.times_s / duration
    # it has stopped, until a later start
    still = ' startTime="-1" stopTime="0"' if waits else ""
    yield f'<TimeSensor DEF="{_clock(motion)}" cycleInterval="{duration:.4f}" loop="true"{still}/>\n'
    turns = dict(joint_turns(motion, joints))
    rest = np.array([[0.0, 0.0, 1.0, 0.0]] * 2)
    for joint in (one for one in joints if one in moved):
        own = (keys, turns[joint]) if joint in turns else (np.array([0.0, 1.0]), rest)
        yield from _interpolated("Orientation", name, joint, own, (f"hanim_{joint}", "set_rotation"))
    yield from _interpolated("Position", name, "way", (keys, motion.root_m), (f"hanim_{joints[0]}", "set_translation"))
    for target in faces:
        weights = np.asarray(motion.weights.get(target, np.zeros(len(keys))), dtype=np.float64)
        rows = _turning(weights)
        own = (keys[rows], weights[rows, None])
        face = identifier(target)
        yield from _interpolated("Scalar", name, f"face_{face}", own, (f"face_{face}", "weight"))


def _interpolated(kind: str, motion: str, name: str, values: tuple[Array, Array], to: tuple[str, str]) -> Iterator[str]:
    """Yield an interpolator with its keys (F,) and values (F, k), and the routes through it."""
    keys, rows = values
    line = " ".join(["%.5f"] * rows.shape[1]) + ", "
    node, key_values = f"{motion}_{name}", (line * len(rows)) % tuple(rows.ravel().tolist())
    key = ("%.4f " * len(keys)) % tuple(keys.tolist())
    yield f'<{kind}Interpolator DEF="{node}" key="{key}" keyValue="{key_values}"/>\n'
    yield f'<ROUTE fromNode="{motion}_clock" fromField="fraction_changed" toNode="{node}" toField="set_fraction"/>\n'
    yield f'<ROUTE fromNode="{node}" fromField="value_changed" toNode="{to[0]}" toField="{to[1]}"/>\n'


def _turning(values: Array) -> NDArray[np.int64]:
    """Return the rows (K,) that straight lines between them need: the ends, and all beside which a value changes."""
    change = np.abs(np.diff(values)) > 0.0
    kept = np.concatenate([[True], change[:-1] | change[1:], [True]])
    return np.flatnonzero(kept)
