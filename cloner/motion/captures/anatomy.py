"""Identification of body parts in a captured skeleton, whatever its joints are called.

Knees and elbows are told by name, in the dialects of CMU, Mixamo, MakeHuman, Unreal, VRM, 3ds Max and H-Anim;
everything else follows from the hierarchy: what lies above a knee is the thigh, below it the foot, and the spine joins
the two pairs.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.errors import ClonerError
from cloner.motion.captures.bvh import Capture

_KNEES: Final = {"knee", "shin", "leg", "loleg", "lowleg", "lowerleg", "calf", "tibia"}
_ELBOWS: Final = {"elbow", "forearm", "loarm", "lowarm", "lowerarm", "radius"}
_HEADS: Final = {"head", "skullbase"}
#: Other bones of the Acclaim files that carry their side as a first small letter.
_ACCLAIM: Final = {"clavicle", "humerus", "femur", "foot", "toes", "hand", "wrist", "hipjoint", "fingers", "thumb"}
_TOES: Final = re.compile("toe|ball|midtarsal")
#: Bones shorter than this share of the whole are helpers, no limbs.
_HELPER: Final = 0.01


@dataclass(frozen=True, slots=True)
class Limb:
    """Numbers of a limb's joints from the trunk on.

    Attributes
    ----------
    girdle : int
        The collar bone; -1 where there is none, and for legs.
    upper, lower, end : int
        Shoulder or hip, elbow or knee, wrist or ankle.
    tip : int
        A joint of the toes, -1 where there is none.
    """

    girdle: int
    upper: int
    lower: int
    end: int
    tip: int


@dataclass(frozen=True, slots=True)
class Anatomy:
    """Numbers of the joints that matter.

    Attributes
    ----------
    pelvis, chest, head : int
        Pelvis and chest carry both legs and both arms.
    spine : tuple of int
        From the pelvis to the chest, both included.
    neck : tuple of int
        From the chest to the head, both included.
    arms, legs : tuple of Limb, left and right
    """

    pelvis: int
    chest: int
    head: int
    spine: tuple[int, ...]
    neck: tuple[int, ...]
    arms: tuple[Limb, Limb]
    legs: tuple[Limb, Limb]


def find_anatomy(capture: Capture) -> Anatomy:
    """Return which joint of a capture is which part of the body.

    Raises
    ------
    ClonerError
        If knees, elbows or the head cannot be told.
    """
    legs = tuple(_leg(capture, _sided(capture, side, _KNEES, "knee")) for side in "lr")
    arms = tuple(_arm(capture, _sided(capture, side, _ELBOWS, "elbow")) for side in "lr")
    heads = [number for number, name in enumerate(capture.names) if plain(name)[0] in _HEADS]
    if not heads:
        raise _unknown("head")
    for limb, part in zip((*legs, *arms), ("left leg", "right leg", "left arm", "right arm"), strict=True):
        _has_length(capture, limb, part)
    pelvis = _shared(capture, legs[0].upper, legs[1].upper)
    chest = _shared(capture, arms[0].upper, arms[1].upper)
    # where legs and back begin at different joints, the trunk begins at the joint they share
    start = _shared(capture, pelvis, chest)
    return Anatomy(pelvis, chest, heads[0], _chain(capture, start, chest), _chain(capture, chest, heads[0]), arms, legs)  # type: ignore[arg-type]


def plain(name: str) -> tuple[str, str]:
    """Return a joint's name without prefix and side, in small letters, and its side "l", "r" or ""."""
    name = re.split(r"[:|]", name)[-1]
    name = re.sub(r"^mixamorig\d*|^bip\d*[ _\-.]+", "", name, flags=re.IGNORECASE)
    for pattern, side in (
        (r"^left[_\-. ]?(.+)$", "l"), (r"^right[_\-. ]?(.+)$", "r"),
        (r"^l[_\-. ](.+)$", "l"), (r"^r[_\-. ](.+)$", "r"),
        (r"^(.+)[_\-.](?:l|left)$", "l"), (r"^(.+)[_\-.](?:r|right)$", "r"),
    ):  # fmt: skip
        match = re.match(pattern, name, re.IGNORECASE)
        if match:
            return re.sub("[^a-z]", "", match[1].lower()), side
    match = re.match(r"^([lr])([A-Z].*)$", name)  # lShin, RHipJoint
    if match:
        return re.sub("[^a-z]", "", match[2].lower()), match[1]
    match = re.match(r"^([LR])([A-Z].*)$", name)
    if match:
        return re.sub("[^a-z]", "", match[2].lower()), match[1].lower()
    match = re.match(r"^([lr])(.+)$", name)  # lfemur, of the Acclaim files
    if match and match[2].lower() in _KNEES | _ELBOWS | _ACCLAIM:
        return match[2].lower(), match[1]
    return re.sub("[^a-z]", "", name.lower()), ""


def _has_length(capture: Capture, limb: Limb, part: str) -> None:
    """Refuse limbs that point nowhere."""
    longest = float(np.linalg.norm(capture.offsets, axis=1).max())
    for joint in (limb.lower, limb.end):
        if np.linalg.norm(capture.offsets[joint]) <= _HELPER * longest:
            hint = "Export the capture with the lengths of its bones"
            raise ClonerError(f"the {part} has a bone without length in the capture", hint, capture.names[joint])


def _unknown(part: str) -> ClonerError:
    hint = "Name its joints as CMU, Mixamo, MakeHuman, Unreal, VRM or H-Anim do"
    return ClonerError(f"no {part} can be found in the capture", hint, "BVH")


def _sided(capture: Capture, side: str, names: set[str], part: str) -> int:
    for number, name in enumerate(capture.names):
        base, own = plain(name)
        if own == side and base in names:
            return number
    raise _unknown(f"{'left' if side == 'l' else 'right'} {part}")


def _leg(capture: Capture, knee: int) -> Limb:
    ankle = _below(capture, knee)
    toes = [child for child in _children(capture, ankle) if _TOES.search(capture.names[child].lower())]
    return Limb(-1, _above(capture, knee), knee, ankle, toes[0] if toes else -1)


def _arm(capture: Capture, elbow: int) -> Limb:
    shoulder = _above(capture, elbow)
    girdle = _above(capture, shoulder)
    return Limb(girdle if plain(capture.names[girdle])[1] else -1, shoulder, elbow, _below(capture, elbow), -1)


def _children(capture: Capture, joint: int) -> list[int]:
    return [int(child) for child in np.flatnonzero(capture.parents == joint)]


def _above(capture: Capture, joint: int) -> int:
    """Return the joint above, over helpers that lie in the same place."""
    near = _HELPER * np.abs(capture.offsets[1:]).max()
    parent = int(capture.parents[joint])
    while parent > 0 and np.linalg.norm(capture.offsets[joint]) < near:
        joint, parent = parent, int(capture.parents[parent])
    return parent


def _below(capture: Capture, joint: int) -> int:
    """Return the joint at the far end of a bone: the child that lies farthest."""
    children = _children(capture, joint)
    if not children:
        raise _unknown(f"end of {capture.names[joint]}")
    return max(children, key=lambda child: float(np.linalg.norm(capture.offsets[child])))


def _path(capture: Capture, joint: int) -> list[int]:
    """Return a joint and all above it, the root last."""
    path = [joint]
    while capture.parents[path[-1]] >= 0:
        path.append(int(capture.parents[path[-1]]))
    return path


def _shared(capture: Capture, first: int, second: int) -> int:
    """Return the lowest joint that both hang on."""
    above = set(_path(capture, first))
    return next(joint for joint in _path(capture, second) if joint in above)


def _chain(capture: Capture, first: int, last: int) -> tuple[int, ...]:
    """Return the joints from ``first`` down to ``last``, both included."""
    path = _path(capture, last)
    return tuple(reversed(path[: path.index(first) + 1]))
