"""Joint limits for H-Anim's fields ``llimit`` and ``ulimit``.

Angles about the three axes of the model (X to the left, Y up, Z to the front) from H-Anim's own rest pose, arms
hanging with the palms inwards, feet straight: bending forwards is a turn about -X for hip, shoulder and elbow, about X
for trunk and knee; left limbs go outwards about Z. Programs of inverse kinematics read them as hints; no motion of ours
asks them. What moves by muscles of the face, and the root, has none.

References
----------
Merck Manual, table "Normal values for range of motion of joints" (hip, knee, ankle, foot, toes, shoulder, elbow, wrist,
fingers); American Academy of Orthopaedic Surgeons 1965, Joint Motion: Method of Measuring and Recording (what the table
leaves out: adduction of hip and shoulder, the shoulder's flexion to 180, the thumb's root); White and Panjabi 1990,
Clinical Biomechanics of the Spine, representative values (vertebrae: bending forwards and backwards together, to one
side, turning to one side), halves taken for forwards and backwards. Collar bones: what is left of the arm's 180 degrees
after the shoulder's own 120, two thirds of it lifting.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

import numpy as np
from scipy.spatial.transform import Rotation

from cloner.generic.load import load_generic
from cloner.motion.flesh.rest import hanging_pose
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.twist import FOREARM_PART
from cloner.records.arrays import Array
from cloner.records.clones import Clone

_Span = tuple[float, float]
_STILL: Final[_Span] = (0.0, 0.0)
_TWIST: Final[_Span] = (-90.0 * FOREARM_PART, 90.0 * FOREARM_PART)  # pronation and supination, shared by two joints

#: Degrees about X, Y and Z, least and most, of the left side.
_LEFT: Final[Mapping[str, tuple[_Span, _Span, _Span]]] = MappingProxyType({
    "hip": ((-125.0, 15.0), (-45.0, 45.0), (-30.0, 45.0)),
    "knee": ((0.0, 130.0), _STILL, _STILL),
    "ankle": ((-20.0, 50.0), _STILL, (-35.0, 25.0)),  # the foot's inversion and eversion too: our feet turn here
    "subtalar": (_STILL, _STILL, _STILL),
    "midtarsal": (_STILL, _STILL, _STILL),
    "metatarsal": ((-80.0, 30.0), _STILL, _STILL),
    "sternoclavicular": (_STILL, (-30.0, 30.0), (0.0, 40.0)),
    "acromioclavicular": (_STILL, _STILL, (0.0, 20.0)),
    "shoulder": ((-180.0, 50.0), (-90.0, 90.0), (-45.0, 180.0)),
    "elbow": ((-160.0, 0.0), _TWIST, _STILL),
    "wrist": ((-25.0, 65.0), _TWIST, (-90.0, 70.0)),
    "thumb1": ((-50.0, 40.0), (-15.0, 20.0), (-50.0, 20.0)),
    "thumb2": ((-70.0, 0.0), _STILL, (-70.0, 0.0)),
    "thumb3": ((-90.0, 0.0), _STILL, (-90.0, 0.0)),
})  # fmt: skip
_KNUCKLES: Final = (
    (_STILL, _STILL, _STILL),
    ((-25.0, 20.0), _STILL, (-90.0, 30.0)),
    (_STILL, _STILL, (-120.0, 0.0)),
    (_STILL, _STILL, (-80.0, 0.0)),
)
_FINGERS: Final = ("thumb", "index", "middle", "ring", "pinky")
#: Degrees from bent back to bent forwards, to one side, turned to one side; each joint lies below its vertebra.
_SPINE: Final[Mapping[str, tuple[float, float, float]]] = MappingProxyType({
    "skullbase": (25, 5, 5), "vc1": (20, 5, 40), "vc2": (10, 10, 3), "vc3": (15, 11, 7), "vc4": (20, 11, 7),
    "vc5": (20, 8, 7), "vc6": (17, 7, 6), "vc7": (9, 4, 2), "vt1": (4, 5, 9), "vt2": (4, 6, 8), "vt3": (4, 5, 8),
    "vt4": (4, 6, 8), "vt5": (4, 6, 8), "vt6": (5, 6, 7), "vt7": (6, 6, 7), "vt8": (6, 6, 6), "vt9": (6, 6, 4),
    "vt10": (9, 7, 2), "vt11": (12, 9, 2), "vt12": (12, 8, 2), "vl1": (12, 6, 2), "vl2": (14, 6, 2),
    "vl3": (15, 8, 2), "vl4": (16, 6, 2), "vl5": (17, 3, 1),
})  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Limits:
    """How far a joint turns from a file's rest pose.

    Attributes
    ----------
    low, high : (3,) float64
        About the three axes, radians.
    axes : (3,) float64
        Rotation vector of the axes against the model's, radians.
    """

    low: Array
    high: Array
    axes: Array


def hanging_limits(joint: str) -> Limits | None:
    """Return how far an H-Anim joint turns from the hanging pose, None where nothing is known or nothing turns it."""
    side, _, bare = joint.partition("_")
    if joint in _SPINE:
        back_and_forth, aside, turned = _SPINE[joint]
        high = np.radians([back_and_forth / 2.0, turned, aside])
        return Limits(-high, high, np.zeros(3))
    if _of_finger(joint) and bare[:-1] != "thumb":
        spans = _KNUCKLES[int(bare[-1])]
    elif side in ("l", "r") and bare in _LEFT:
        spans = _LEFT[bare]
    else:
        return None
    low, high = np.radians(np.array(spans, np.float64).T)
    if side == "r":  # mirrored: turns about Y and Z change their sense
        low, high = np.array([low[0], -high[1], -high[2]]), np.array([high[0], -low[1], -low[2]])
    return Limits(low, high, np.zeros(3))


def _of_finger(joint: str) -> bool:
    return joint[2:-1] in _FINGERS


def limits_of(clone: Clone) -> dict[str, Limits]:
    """Return the limits of every joint that has some, told from the clone's own rest pose.

    A joint's axes are those its parent has when the arms hang; how the rest pose differs there is added to the angles,
    one axis at a time: exact for a turn about one axis, and elsewhere as rough as three angles of a ball joint are.
    Fingers count from how they rest.
    """
    generic = load_generic()
    lowered = hanging_pose(body_of(clone))
    world = [Rotation.identity() for _ in generic.joint_names]
    found = {}
    for joint, (name, parent) in enumerate(zip(generic.joint_names, generic.joint_parents, strict=True)):
        above = world[parent] if parent >= 0 else Rotation.identity()
        own = Rotation.identity() if _of_finger(name) else Rotation.from_rotvec(lowered[joint])
        world[joint] = above * own
        limits = hanging_limits(name)
        if limits is not None:
            shift = (above * own * above.inv()).as_euler("XYZ")
            found[name] = Limits(limits.low + shift, limits.high + shift, above.inv().as_rotvec())
    return found
