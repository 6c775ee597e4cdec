"""Reader of Biovision hierarchy files (BVH): a skeleton and its joint angles over time.

References
----------
J. Thingvold, Biovision BVH (hierarchy of OFFSETs and CHANNELS, then one line of numbers a frame).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.motion.limbs import turns
from cloner.records.arrays import Array, freeze
from cloner.untrusted import read_untrusted_text

LARGEST_BYTES: Final = 200_000_000  # taste: an hour of capture at 120 Hz
#: More is no skeleton but an attack or an error.
MOST_JOINTS: Final = 1_000
MOST_ROTATIONS: Final = 30_000_000  # frames times joints, 72 bytes each: that hour with 70 joints
#: Axes by their letter.
_AXES: Final = {"X": 0, "Y": 1, "Z": 2}
_AGAIN: Final = "Export the capture again as BVH"


@dataclass(frozen=True, slots=True, eq=False)
class Capture:
    """A captured motion in its file's own frame and unit.

    Attributes
    ----------
    names : tuple of str
        Joints, parents before children.
    parents : (J,) int64, -1 for the root
    offsets : (J, 3) float64
        From the parent, in the file's zero pose.
    ends : (J, 3) float64
        Where a joint without children points, else zero.
    frame_s : float
        Seconds a frame.
    root : (F, 3) float64
        Place of the root.
    local : (F, J, 3, 3) float64
        Rotation of every joint against its parent.
    """

    names: tuple[str, ...]
    parents: NDArray[np.int64]
    offsets: Array
    ends: Array
    frame_s: float
    root: Array
    local: Array

    def __post_init__(self) -> None:
        count = len(self.names)
        freeze(
            self,
            parents=(np.int64, (count,)),
            offsets=(np.float64, (count, 3)),
            ends=(np.float64, (count, 3)),
            root=(np.float64, (None, 3)),
            local=(np.float64, (None, count, 3, 3)),
        )

    def world(self) -> Array:
        """Return (F, J, 3, 3) orientations of the joints in the file's frame."""
        world = np.array(self.local)
        for joint, parent in enumerate(self.parents):
            if parent >= 0:
                world[:, joint] = world[:, parent] @ world[:, joint]
        return world


def read_bvh(path: Path) -> Capture:
    """Return the capture in a BVH file.

    Raises
    ------
    ClonerError
        If the file is missing, too large, or no BVH.
    """
    text = read_untrusted_text(path, "the capture", "Give a .bvh file", LARGEST_BYTES, errors="replace")
    try:
        return parse_bvh(text)
    except (ValueError, IndexError) as error:
        raise ClonerError(f"the capture is broken: {error}", _AGAIN, path.name) from error


def parse_bvh(text: str) -> Capture:
    """Return the capture in the text of a BVH file.

    Raises
    ------
    ValueError
        If the text is no BVH.
    """
    head, found, tail = text.partition("MOTION")
    if not head.lstrip().startswith("HIERARCHY") or not found:
        raise ValueError("HIERARCHY or MOTION is missing")
    names, parents, offsets, ends, channels = _hierarchy(head.split())
    words = tail.split()
    if words[0] != "Frames:" or words[2:4] != ["Frame", "Time:"]:
        raise ValueError("Frames or Frame Time is missing")
    count, frame_s = int(words[1]), float(words[4])
    width = sum(map(len, channels))
    if not (0 < count * len(names) <= MOST_ROTATIONS and 0.0 < frame_s < 10.0 and width > 0):
        raise ValueError(f"{count} frames of {width} numbers and {frame_s} s")
    numbers = np.array(words[5 : 5 + count * width], dtype=np.float64)
    if len(numbers) != count * width or not np.isfinite(numbers).all():
        raise ValueError(f"{count} frames of {width} numbers are promised, {len(numbers)} numbers are there")
    root, local = _frames(numbers.reshape(count, width), np.array(offsets), channels)
    return Capture(tuple(names), np.array(parents), np.array(offsets), np.array(ends), frame_s, root, local)


def _hierarchy(
    words: list[str],
) -> tuple[list[str], list[int], list[list[float]], list[list[float]], list[list[str]]]:
    """Return names, parents, offsets, ends and channels of the joints."""
    names: list[str] = []
    parents: list[int] = []
    offsets: list[list[float]] = []
    ends: list[list[float]] = []
    channels: list[list[str]] = []
    open_joints: list[int] = []  # -1 stands for an end site
    at = 1
    while at < len(words):
        word = words[at]
        if word in ("ROOT", "JOINT"):
            if (word == "ROOT") == bool(open_joints or names):
                raise ValueError(f"{word} {words[at + 1]} stands in the wrong place")
            parents.append(open_joints[-1] if open_joints else -1)
            begin = words.index("{", at)  # names of 3ds Max have blanks
            names.append(" ".join(words[at + 1 : begin]))
            offsets.append([0.0] * 3)
            ends.append([0.0] * 3)
            channels.append([])
            open_joints.append(len(names) - 1)
            at = begin + 1
        elif word == "End":
            open_joints.append(-1)
            at += 3
        elif word == "OFFSET":
            values = [float(number) for number in words[at + 1 : at + 4]]
            if open_joints[-1] < 0:
                ends[open_joints[-2]] = values
            else:
                offsets[open_joints[-1]] = values
            at += 4
        elif word == "CHANNELS":
            count = max(int(words[at + 1]), 0)
            channels[open_joints[-1]] = words[at + 2 : at + 2 + count]
            at += 2 + count
        elif word == "}":
            open_joints.pop()
            at += 1
        else:
            raise ValueError(f"{word!r} is not expected")
        if len(names) > MOST_JOINTS:
            raise ValueError(f"more than {MOST_JOINTS} joints")
    if not names or open_joints:
        raise ValueError("a bracket is missing")
    return names, parents, offsets, ends, channels


def _frames(numbers: Array, offsets: Array, channels: list[list[str]]) -> tuple[Array, Array]:
    """Return the root's places (F, 3) and all local rotations (F, J, 3, 3)."""
    root = np.tile(offsets[0], (len(numbers), 1))
    local = np.tile(np.eye(3), (len(numbers), len(channels), 1, 1))
    column = 0
    for joint, named in enumerate(channels):
        for name in named:
            axis, kind = _AXES.get(name[:1].upper()), name[1:].lower()
            if axis is None or kind not in ("position", "rotation"):
                raise ValueError(f"the channel {name!r} is not known")
            if kind == "rotation":
                local[:, joint] = local[:, joint] @ turns.rotations_about(axis, np.radians(numbers[:, column]))
            elif joint == 0:
                root[:, axis] = numbers[:, column]
            column += 1
    return root, local
