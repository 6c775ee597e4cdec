"""Spring bones of a VRM: along tails of hair and loose cloth, with colliders.

Other formats keep tails on head and chest, and cloth on trunk and thighs: nothing would swing them there.

References
----------
VRM Consortium 2022, VRMC_springBone 1.0: joints with stiffness, gravity, drag and a radius; spheres and capsules.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Final

import numpy as np
import pygltflib

from cloner.generic.load import load_generic
from cloner.motion.limbs.hems import hems
from cloner.motion.limbs.tails import Tail, tails
from cloner.records.arrays import Array
from cloner.records.clones import Clone

EXTENSION: Final = "VRMC_springBone"


@dataclass(frozen=True, slots=True)
class Swing:
    """How a kind of shell swings, in the format's own numbers, and what it does not fall into.

    Attributes
    ----------
    name : str
        How its bones' names begin.
    stiffness : (first, float, others)
        The first bone keeps the way in which it leaves the body.
    gravity, drag : float
    bodies : mapping of str to (str, str or None)
        A joint, and where its capsule ends (the skull is a sphere), by name.
    """

    name: str
    stiffness: tuple[float, float]
    gravity: float
    drag: float
    bodies: Mapping[str, tuple[str, str | None]]


#: Taste: a turned head's tail is still after a second; a skirt keeps its flare and follows its leg so closely that a
#: walk's knee does not come through (at a stiffness of 1.6 it does, at 4 now and then).
SWINGS: Final[Mapping[str, Swing]] = MappingProxyType({
    "hair": Swing("hair_tail", (1.2, 0.5), 0.6, 0.35,
                  {"head": ("skullbase", None), "neck": ("vc4", "skullbase"), "chest": ("vt6", "vt1")}),
    "cloth": Swing("hem", (8.0, 6.0), 0.12, 0.8,
                   {f"{side}_{joint}": (f"{side}_{joint}", f"{side}_{end}")
                    for side in ("l", "r") for joint, end in (("hip", "knee"), ("knee", "ankle"))}),
})  # fmt: skip
#: Only this far beside a bone the skin behind tells how thick a body is, metres.
_BESIDE_M: Final = 0.03
#: Smaller bodies, and less room around resting hair, are left out, metres; taste.
_LEAST_M: Final = 0.02


def add_spring_bones(gltf: Any, clone: Clone) -> dict[str, Any] | None:
    """Add spring bones to a clone's tails and loose cloth, in place, and return the extension; None without any.

    Parameters
    ----------
    gltf : pygltflib.GLTF2
        As `cloner.exporters.gltf.gltf.build` made it of this very clone, with H-Anim's joints.
    clone : Clone
    """
    data: dict[str, Any] = {"specVersion": "1.0", "colliders": [], "colliderGroups": [], "springs": []}
    nodes = {node.name: number for number, node in enumerate(gltf.nodes)}
    every: list[Tail] = []
    for kind, found in (("hair", tails(clone)), ("cloth", hems(clone))):
        if not found:
            continue
        swing, every = SWINGS[kind], [*every, *found]
        chains = [_add_bones(gltf, clone, tail, f"{swing.name}{k + 1}", nodes) for k, tail in enumerate(found)]
        for shell in sorted({tail.shell for tail in found}):
            _rewrite_weights(gltf, clone, shell, [(tail, chain) for tail, chain in zip(found, chains, strict=True)
                                        if tail.shell == shell])  # fmt: skip
        bodies = _colliders(clone, swing, found)
        first, group = len(data["colliders"]), len(data["colliderGroups"])
        data["colliders"] += [{"node": nodes[swing.bodies[name][0]], "shape": shape} for name, shape in bodies.items()]
        if bodies:
            rows = list(range(first, first + len(bodies)))
            data["colliderGroups"].append({"name": kind, "colliders": rows})
        data["springs"] += [
            {
                "name": gltf.nodes[chain[0]].name,
                "joints": [_joint(swing, node, k, float(tail.radius_m[k])) for k, node in enumerate(chain)],
                "colliderGroups": [group] if bodies else [],
            }
            for tail, chain in zip(found, chains, strict=True)
        ]
    if not every:
        return None
    _bind(gltf, np.vstack([tail.points_m[:-1] for tail in every]))
    return data


def _joint(swing: Swing, node: int, place: int, radius_m: float) -> dict[str, Any]:
    return {
        "node": node, "hitRadius": round(radius_m, 4), "stiffness": swing.stiffness[min(place, 1)],
        "gravityPower": swing.gravity, "gravityDir": [0.0, -1.0, 0.0], "dragForce": swing.drag,
    }  # fmt: skip


def _add_bones(gltf: Any, clone: Clone, tail: Tail, name: str, nodes: dict[str, int]) -> list[int]:
    """Add the nodes of a chain below the joint that it hangs on, its end among them, and return them."""
    root = nodes[tail.joint]
    first, above = len(gltf.nodes), clone.joints_m[load_generic().joint(tail.joint)]
    for place, point in enumerate(tail.points_m):
        own = pygltflib.Node(name=f"{name}_{place + 1}", translation=(point - above).tolist(), children=[])
        gltf.nodes.append(own)
        parent = root if place == 0 else first + place - 1
        gltf.nodes[parent].children = [*(gltf.nodes[parent].children or []), first + place]
        above = point
    return list(range(first, first + len(tail.points_m)))


def _rewrite_weights(gltf: Any, clone: Clone, shell: int, hung: Sequence[tuple[Tail, list[int]]]) -> None:
    """Let bones carry a shell: its joints and weights are written anew where they lie."""
    kind = clone.shells[shell].kind
    row = sum(one.kind == kind for one in clone.shells[:shell])
    mesh = next(mesh for mesh in gltf.meshes if mesh.name == kind.capitalize())
    attributes = mesh.primitives[row].attributes
    joints = [clone.shells[shell].skin_joints.astype(np.int64)]
    weights = [clone.shells[shell].skin_weights.astype(np.float64)]
    left, joined = np.ones(len(joints[0])), gltf.skins[0].joints
    for tail, chain in hung:
        left -= tail.share.sum(axis=1)
        joints.append(np.tile(len(joined) + np.arange(tail.share.shape[1]), (len(left), 1)))
        weights.append(tail.share)
        joined += chain[:-1]
    weights[0] = weights[0] * np.clip(left, 0.0, 1.0)[:, None]
    every, share = np.hstack(joints), np.hstack(weights)
    order = np.argsort(-share, axis=1, kind="stable")[:, :4]
    every, share = np.take_along_axis(every, order, axis=1), np.take_along_axis(share, order, axis=1)
    share = (share / share.sum(axis=1, keepdims=True)).astype(np.float32)
    every = np.where(share > 0.0, every, 0).astype(np.uint8)
    blob = bytearray(gltf.binary_blob())
    for accessor, values in ((attributes.JOINTS_0, every), (attributes.WEIGHTS_0, share)):
        start = gltf.bufferViews[gltf.accessors[accessor].bufferView].byteOffset
        blob[start : start + values.nbytes] = values.tobytes()
    gltf.set_binary_blob(bytes(blob))


def _bind(gltf: Any, points_m: Array) -> None:
    """Add the bones' inverse bind matrices to the skin's: those before are stored once more, all at the file's end."""
    accessor = gltf.accessors[gltf.skins[0].inverseBindMatrices]
    view, blob = gltf.bufferViews[accessor.bufferView], gltf.binary_blob()
    inverse = np.tile(np.eye(4, dtype=np.float32), (len(points_m), 1, 1))
    inverse[:, 3, :3] = -points_m  # by columns, as glTF stores them
    data = blob[view.byteOffset : view.byteOffset + view.byteLength] + inverse.tobytes()
    accessor.count += len(points_m)
    view.byteOffset, view.byteLength = len(blob), len(data)
    gltf.set_binary_blob(blob + data)
    gltf.buffers[0].byteLength = len(gltf.binary_blob())


def _colliders(clone: Clone, swing: Swing, found: Sequence[Tail]) -> dict[str, dict[str, Any]]:
    """Return the colliders of a resting shell by name, as large as body and rest pose allow."""
    generic, shapes = load_generic(), {}
    points = np.vstack([tail.points_m for tail in found])
    radii = np.concatenate([tail.radius_m for tail in found])
    scalp = clone.vertices_m[generic.region("scalp")]
    for name, (joint, end) in swing.bodies.items():
        node = clone.joints_m[generic.joint(joint)]
        first = 0.5 * (scalp.min(axis=0) + scalp.max(axis=0)) if end is None else node
        last = first if end is None else clone.joints_m[generic.joint(end)]
        skin = scalp if end is None else clone.vertices_m[generic.skin]
        radius = min(_thick(skin, first, last), float((_away(points, first, last) - radii).min()))
        if radius < _LEAST_M:
            continue
        data = {"offset": _rounded(first - node), "radius": round(radius, 4)}
        shapes[name] = {"sphere": data} if end is None else {"capsule": {**data, "tail": _rounded(last - node)}}
    return shapes


def _thick(skin_m: Array, first: Array, last: Array) -> float:
    """Return the median distance of the skin behind a bone, of the spine or a leg, from it, metres."""
    low, high = sorted((float(first[1]), float(last[1])))
    behind = (skin_m[:, 2] < first[2]) & (np.abs(skin_m[:, 0] - first[0]) < _BESIDE_M)
    level = (skin_m[:, 1] > low - _LEAST_M) & (skin_m[:, 1] < high + _LEAST_M)
    return float(np.median(_away(skin_m[behind & level], first, last))) if (behind & level).any() else 0.0


def _away(points_m: Array, first: Array, last: Array) -> Array:
    """Return (N,) distances of points from a stretch, metres."""
    way = last - first
    share = np.clip((points_m - first) @ way / max(float(way @ way), 1e-12), 0.0, 1.0)
    return np.asarray(np.linalg.norm(points_m - first - share[:, None] * way, axis=1))


def _rounded(point: Array) -> list[float]:
    return [round(float(x), 5) for x in point]
