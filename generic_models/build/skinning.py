"""Skin weights: the default rig's bones become H-Anim joints; spine and neck weights spread over the vertebrae."""

from __future__ import annotations

from dataclasses import dataclass

import hanim
import numpy as np
from cage import Cage
from source import FloatArray, IntArray, Source

INFLUENCES = 4  # what glTF readers take in one set
_FINGER = {"1": "thumb", "2": "index", "3": "middle", "4": "ring", "5": "pinky"}
_PLAIN = {
    "root": "HumanoidRoot",
    "head": "skullbase",
    "jaw": "temporomandibular",
    "pelvis": "sacroiliac",
    "clavicle": "sternoclavicular",
    "shoulder01": "acromioclavicular",
    "upperarm01": "shoulder",
    "upperarm02": "shoulder",
    "lowerarm01": "elbow",
    "lowerarm02": "elbow",
    "wrist": "wrist",
    "upperleg01": "hip",
    "upperleg02": "hip",
    "lowerleg01": "knee",
    "lowerleg02": "knee",
    "foot": "ankle",
    "metacarpal1": "index0",
    "metacarpal2": "middle0",
    "metacarpal3": "ring0",
    "metacarpal4": "pinky0",
    "breast": "SPINE",
    "eye": "skullbase",
}


def _joint_of_bone(bone: str, parents: dict[str, str | None]) -> str:
    """Return the H-Anim joint (or SPINE / NECK, to be spread) that takes over a bone's weights."""
    stem, _, side = bone.partition(".")
    prefix = {"L": "l_", "R": "r_"}.get(side, "")
    if stem.startswith("spine"):
        return "SPINE"
    if stem.startswith("neck"):
        return "NECK"
    if stem.startswith("toe"):
        return prefix + "metatarsal"
    if stem.startswith("finger"):
        finger, number = stem.removeprefix("finger").split("-")
        return f"{prefix}{_FINGER[finger]}{number}"
    if stem in _PLAIN:
        joint = _PLAIN[stem]
        return (
            joint
            if joint in hanim.INDEX or joint == "SPINE"
            else (joint if stem in ("head", "jaw", "eye", "root", "pelvis") else prefix + joint)
        )
    parent = parents[bone]  # a facial muscle: it goes with the head or the jaw, whichever carries it
    if parent is None:
        raise ValueError(f"bone {bone} has no joint")
    return _joint_of_bone(parent, parents)


def _spread(weights: FloatArray, total: FloatArray, along: FloatArray, names: list[str], centres_m: FloatArray) -> None:
    """Add ``total`` to the joints ``names``, each vertex between the two bones whose middles enclose it."""
    starts = centres_m[[hanim.INDEX[n] for n in names], 1]
    middles = starts.copy()
    middles[:-1] = (starts[:-1] + starts[1:]) / 2
    share = np.column_stack([np.interp(along, middles, row) for row in np.eye(len(names))])
    for k, name in enumerate(names):
        weights[:, hanim.INDEX[name]] += total * share[:, k]


@dataclass(frozen=True, slots=True, eq=False)
class Shares:
    """What the default rig's bones carry, spine and neck not yet spread over the vertebrae.

    Attributes
    ----------
    joints : (V, 94)
    spine, neck : (V,)
    """

    joints: FloatArray
    spine: FloatArray
    neck: FloatArray

    def __post_init__(self) -> None:
        for array in (self.joints, self.spine, self.neck):
            array.setflags(write=False)


def shares(source: Source, cage: Cage) -> Shares:
    """Return the default rig's weights of the body's skin; eyes, teeth and lashes carry none yet."""
    table = source.json("mpfb2/rigs/standard/weights.default.json")["weights"]
    rig = source.json("mpfb2/rigs/standard/rig.default.json")
    bones = rig.get("bones", rig)
    parents = {name: bone.get("parent") or None for name, bone in bones.items()}
    body = cage.full_of_vertex[: (cage.vertex_part == 0).sum()]
    of_full = np.full(cage.base.vertices_m.shape[0], -1)
    of_full[body] = np.arange(body.size)
    weights = np.zeros((cage.vertex_part.size, len(hanim.NAMES)))
    loose = {"SPINE": np.zeros(cage.vertex_part.size), "NECK": np.zeros(cage.vertex_part.size)}
    for bone, pairs in table.items():
        rows = np.array([i for i, _ in pairs], dtype=np.int64).reshape(-1)
        values = np.array([w for _, w in pairs]).reshape(-1)
        vertex = of_full[rows] if rows.size else rows
        keep = vertex >= 0
        joint = _joint_of_bone(bone, parents)
        column = loose[joint] if joint in loose else weights[:, hanim.INDEX[joint]]
        np.add.at(column, vertex[keep], values[keep])
    return Shares(weights, loose["SPINE"], loose["NECK"])


def skin(carried: Shares, cage: Cage, vertices_m: FloatArray, joints_m: FloatArray) -> FloatArray:
    """Return dense symmetric skin weights, (V, 94), at most four per vertex, rows summing to one.

    Parameters
    ----------
    vertices_m, joints_m : the rest shape, (V, 3) and (94, 3); heights decide which vertebra a vertex follows.
    """
    weights = carried.joints.copy()
    height = vertices_m[:, 1]
    _spread(weights, carried.spine, height, ["HumanoidRoot", *hanim.LUMBAR_UP], joints_m)
    _spread(weights, carried.neck, height, [*hanim.CERVICAL_UP], joints_m)
    for part, joint in (
        ("eye_left", "l_eyeball_joint"),
        ("eye_right", "r_eyeball_joint"),
        ("teeth_upper", "skullbase"),
        ("teeth_lower", "temporomandibular"),
        ("tongue", "temporomandibular"),
        ("lashes_left", "skullbase"),
        ("lashes_right", "skullbase"),
    ):
        weights[cage.part(part), hanim.INDEX[joint]] = 1.0
    weights /= weights.sum(axis=1, keepdims=True)
    swap = np.array([hanim.INDEX[other_side(n)] for n in hanim.NAMES])
    weights = (weights + weights[cage.mirror][:, swap]) / 2
    rank = np.argsort(np.argsort(-weights, axis=1, kind="stable"), axis=1, kind="stable")
    keep = (rank < INFLUENCES) & (weights >= 1e-4)
    middle = cage.mirror == np.arange(cage.mirror.size)
    keep[middle] &= keep[middle][:, swap]  # on the midline a pair stays or goes together
    weights[~keep] = 0.0
    weights /= weights.sum(axis=1, keepdims=True)
    # A tie at the fourth place may fall differently on the two sides: take the left body's answer for both.
    right = vertices_m[:, 0] < -1e-6
    weights[right] = weights[cage.mirror[right]][:, swap]
    return weights


def other_side(name: str) -> str:
    """Return the name of a joint's mirror twin."""
    if name[:2] == "l_":
        return "r_" + name[2:]
    return "l_" + name[2:] if name[:2] == "r_" else name


def pack(weights: FloatArray) -> tuple[IntArray, FloatArray]:
    """Return the four heaviest joints and their renormalised weights, (V, 4) int16 and (V, 4) float32."""
    joints = np.argsort(-weights, axis=1, kind="stable")[:, :INFLUENCES]
    values = np.take_along_axis(weights, joints, axis=1)
    joints = np.where(values > 0.0, joints, joints[:, :1])
    values = (values / values.sum(axis=1, keepdims=True)).astype(np.float32)
    values[:, 0] += 1.0 - values.sum(axis=1)
    return joints.astype(np.int16), values
