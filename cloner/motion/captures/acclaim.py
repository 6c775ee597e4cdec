"""Reader of Acclaim captures: a skeleton (.asf) and its joint angles over time (.amc).

A bone of these files turns itself, a joint of ours turns what hangs on it: the joint of a bone lies at the bone's
beginning. Angles are counted in the bone's own axes.

References
----------
Acclaim Motion Capture Format 1.10; M. Gleicher, "Motion capture file formats explained", 2000, ASF and AMC.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from scipy.spatial.transform import Rotation

from cloner.errors import ClonerError
from cloner.motion.captures.bvh import LARGEST_BYTES, MOST_JOINTS, Capture
from cloner.records.arrays import Array
from cloner.untrusted import read_untrusted_text

#: The files do not tell their rate; the public laboratory's is 120 frames a second.
FRAME_S: Final = 1.0 / 120.0
ROOT: Final = "root"
_AGAIN: Final = "Export the capture again as .asf and .amc, or as .bvh"


@dataclass(frozen=True, slots=True, eq=False)
class Bone:
    """One bone of a skeleton file.

    Attributes
    ----------
    vector : (3,) float64
        From its beginning to its end at rest, file frame; zero for the root.
    axes : (3, 3) float64
        Its own axes at rest, as columns.
    freedoms : tuple of str
        What a frame's numbers mean: "rx", "ry", "rz", and for the root "tx", "ty", "tz".
    """

    vector: Array
    axes: Array
    freedoms: tuple[str, ...]


def read_acclaim(path: Path) -> Capture:
    """Return the capture in an .amc file, whose .asf lies beside it.

    Raises
    ------
    ClonerError
        If a file is missing, too large or broken, or no skeleton can be told to belong to the motion.
    """
    skeleton = _skeleton_of(path)
    texts = [_text(file) for file in (skeleton, path)]
    try:
        return parse_acclaim(*texts)
    except KeyError as error:
        message = f"the capture is broken: {error.args[0]} is missing, or the skeleton does not know it"
        raise ClonerError(message, _AGAIN, path.name) from error
    except (ValueError, IndexError) as error:
        raise ClonerError(f"the capture is broken: {error}", _AGAIN, path.name) from error


def _skeleton_of(path: Path) -> Path:
    """Return the .asf of an .amc: of its name, of its subject's ("07" of "07_02"), or the only one there."""
    for stem in (path.stem, path.stem.split("_")[0]):
        if (file := path.with_name(f"{stem}.asf")).is_file():
            return file
    files = sorted(path.parent.glob("*.asf"))
    if len(files) != 1:
        raise ClonerError("the skeleton of the capture is missing", f"Put {path.stem}.asf beside it", path.name)
    return files[0]


def _text(path: Path) -> str:
    return read_untrusted_text(path, "the capture", "Give a .amc file with its .asf", LARGEST_BYTES, errors="replace")


def parse_acclaim(skeleton: str, motion: str) -> Capture:
    """Return the capture in the texts of a skeleton and a motion file.

    Raises
    ------
    ValueError, IndexError, KeyError
        If they are none.
    """
    sections = dict(_sections(skeleton))
    bones, parents = _bones(sections), _parents(sections["hierarchy"])
    names = [ROOT, *(name for name in _ordered(parents) if name != ROOT)]
    if len(names) > MOST_JOINTS:
        raise ValueError(f"more than {MOST_JOINTS} bones")
    above = [-1, *(names.index(parents[name]) for name in names[1:])]
    offsets = np.array([bones[ROOT].vector, *(bones[parents[name]].vector for name in names[1:])])
    leaves = set(names) - set(parents.values())
    ends = np.array([bones[name].vector if name in leaves else np.zeros(3) for name in names])
    root, local = _frames(motion, bones, names)
    return Capture(tuple(names), np.array(above), offsets, ends, FRAME_S, root, local)


def _sections(text: str) -> Iterator[tuple[str, list[str]]]:
    """Yield the name and the lines of every section of a skeleton file."""
    for part in re.split(r"^\s*:", text, flags=re.MULTILINE)[1:]:
        first, *lines = [line.split("#")[0].strip() for line in part.splitlines()]
        yield first.split()[0].lower(), [line for line in lines if line]


def _bones(sections: dict[str, list[str]]) -> dict[str, Bone]:
    found = {}
    root = {line.split()[0].lower(): line.split()[1:] for line in sections["root"]}
    angles = Rotation.from_euler(_order(root["axis"][0]), [float(x) for x in root["orientation"]], degrees=True)
    freedoms = tuple(word.lower() for word in root["order"])
    found[ROOT] = Bone(np.zeros(3), angles.as_matrix(), freedoms)
    for text in "\n".join(sections["bonedata"]).split("begin")[1:]:
        words = {line.split()[0].lower(): line.split()[1:] for line in text.splitlines() if line}
        direction = np.array([float(x) for x in words["direction"][:3]])
        length = float(words["length"][0])
        *turn, order = words["axis"]
        axes = Rotation.from_euler(_order(order), [float(x) for x in turn], degrees=True).as_matrix()
        if not (np.isfinite(length) and np.isfinite(direction).all()):
            raise ValueError(f"the bone {words['name'][0]} has no length")
        found[words["name"][0]] = Bone(length * direction, axes, tuple(word.lower() for word in words.get("dof", [])))
    return found


def _order(axes: str) -> str:
    """Return scipy's word for "XYZ": about fixed axes, the first letter first."""
    return axes.lower()


def _parents(lines: list[str]) -> dict[str, str]:
    rows = [line.split() for line in lines if line not in ("begin", "end")]
    parents = {child: parent for parent, *children in rows for child in children}
    if ROOT in parents:  # whoever follows the bones from there would never come to an end
        raise ValueError("the root hangs on a bone")
    return parents


def _ordered(parents: dict[str, str]) -> Iterator[str]:
    """Yield all bones, parents before children."""
    waiting = [ROOT]
    while waiting:
        name = waiting.pop(0)
        yield name
        waiting += [child for child, parent in parents.items() if parent == name]


def _frames(motion: str, bones: dict[str, Bone], names: list[str]) -> tuple[Array, Array]:
    """Return the root's places (F, 3) and all local rotations (F, J, 3, 3) of a motion file."""
    rows: dict[str, list[list[str]]] = {name: [] for name in names}
    count = 0
    for line in motion.splitlines():
        words = line.split()
        if len(words) == 1 and words[0].isdigit():
            count += 1
        elif count and words:
            rows[words[0]].append(words[1:])
    if not count:
        raise ValueError("there are no frames")
    root, local = np.zeros((count, 3)), np.tile(np.eye(3), (count, len(names), 1, 1))
    for joint, name in enumerate(names):
        bone, width = bones[name], len(bones[name].freedoms)
        if not width and not rows[name]:
            continue
        whole = len(rows[name]) == count and all(len(row) == width for row in rows[name])
        numbers = np.array(rows[name] if whole else np.nan, dtype=np.float64)
        if not np.isfinite(numbers).all():
            raise ValueError(f"{count} frames of {width} numbers are expected of {name}")
        angles = np.zeros((count, 3))
        for column, freedom in enumerate(bone.freedoms):
            axis = "xyz".index(freedom[1])
            (root if freedom[0] == "t" else angles)[:, axis] = numbers[:, column]
        turned = Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
        local[:, joint] = bone.axes @ turned @ bone.axes.T
    return root, local
