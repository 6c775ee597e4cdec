"""H-Anim 1.1 names of segments, and version 2 names of joints.

References
----------
Humanoid Animation Working Group 1999, Specification for a Standard Humanoid, version 1.1, sections 3 and 5.
"""

from __future__ import annotations

import re
from typing import Final

_FIXED: Final = {
    "HumanoidRoot": "sacrum",
    "sacroiliac": "pelvis",
    "skullbase": "skull",
    "temporomandibular": "jaw",
}
_SIDED: Final = {
    "hip": "thigh",
    "knee": "calf",
    "ankle": "hindfoot",
    "subtalar": "midproximal",
    "midtarsal": "middistal",
    "metatarsal": "forefoot",
    "sternoclavicular": "clavicle",
    "acromioclavicular": "scapula",
    "shoulder": "upperarm",
    "elbow": "forearm",
    "wrist": "hand",
    "eyeball_joint": "eyeball",
    "eyelid_joint": "eyelid",
    "eyebrow_joint": "eyebrow",
}
_PHALANGES: Final = {"0": "metacarpal", "1": "proximal", "2": "middle", "3": "distal"}
_THUMB: Final = {"1": "metacarpal", "2": "proximal", "3": "distal"}


def segment_name(joint: str) -> str:
    """Return the segment that hangs on a joint.

    Raises
    ------
    ValueError
        If the joint is not one of the 94.
    """
    if joint in _FIXED:
        return _FIXED[joint]
    if joint[0] == "v" and joint[1] in "lct" and joint[2:].isdigit():
        return joint[1:]  # vl5 carries l5: a vertebra, not a left-side part
    side, _, bare = joint.partition("_")
    if side in ("l", "r"):
        if bare in _SIDED:
            return f"{side}_{_SIDED[bare]}"
        finger, number = bare[:-1], bare[-1:]
        names = _THUMB if finger == "thumb" else _PHALANGES
        if finger in ("thumb", "index", "middle", "ring", "pinky") and number in names:
            return f"{side}_{finger}_{names[number]}"
    raise ValueError(f"unknown H-Anim joint {joint!r}")


_JOINTS_2: Final = {
    "HumanoidRoot": "humanoid_root",
    "ankle": "talocrural",
    "subtalar": "tarsometatarsal_2",
    "midtarsal": "metatarsophalangeal_2",
    "metatarsal": "tarsal_distal_interphalangeal_2",
    "wrist": "radiocarpal",
    "thumb1": "carpometacarpal_1",
    "thumb2": "metacarpophalangeal_1",
    "thumb3": "carpal_interphalangeal_1",
}
#: Fingers by their number in H-Anim 2.
_FINGERS_2: Final = {"index": 2, "middle": 3, "ring": 4, "pinky": 5}
_KNUCKLES_2: Final = {
    "0": "carpometacarpal",
    "1": "metacarpophalangeal",
    "2": "carpal_proximal_interphalangeal",
    "3": "carpal_distal_interphalangeal",
}


def joint_name_2(joint: str) -> str:
    """Return the H-Anim 2 (ISO/IEC 19774:2019) name of an H-Anim 1.1 joint; most are the same."""
    side, _, bare = joint.partition("_")
    if side not in ("l", "r") or not bare:
        return _JOINTS_2.get(joint, joint)
    finger, number = bare[:-1], bare[-1:]
    if finger in _FINGERS_2 and number in _KNUCKLES_2:
        return f"{side}_{_KNUCKLES_2[number]}_{_FINGERS_2[finger]}"
    return f"{side}_{_JOINTS_2.get(bare, bare)}"


def node_name(name: str) -> str:
    """Return any text as the name of a node: an identifier that begins with a letter."""
    return identifier(name) if re.match(r"[A-Za-z]", name) else f"m_{identifier(name)}"


def identifier(name: str) -> str:
    """Return a name with everything but letters, digits and _ replaced: "fdp_2.1" gives "fdp_2_1"."""
    return re.sub(r"[^A-Za-z0-9_]", "_", name)
