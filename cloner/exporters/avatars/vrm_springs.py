"""Hair that swings in a VRM: bones along every tail, and round bodies that it does not fall into.

Other formats keep the tail on head and chest: nothing would swing it there.

References
----------
VRM Consortium 2022, VRMC_springBone 1.0: joints with stiffness, gravity, drag and a radius; spheres and capsules.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.motion.limbs.tails import Tail, tails
from cloner.records.clones import Clone

Array = NDArray[np.float64]

EXTENSION: Final = "VRMC_springBone"
#: How hair swings, in the format's own numbers; taste: the first bone keeps the way in which hair leaves its band, the
#: others hang, and a turned head's tail is still after a second.
STIFFNESS: Final = (1.2, 0.5)
GRAVITY: Final = 0.6
DRAG: Final = 0.35
#: What hair does not fall into: a joint, and where its capsule ends (the skull is a sphere).
BODIES: Final = {"head": ("skullbase", None), "neck": ("vc4", "skullbase"), "chest": ("vt6", "vt1")}
#: Only this far beside the spine the skin behind tells how thick a body is, metres.
_BESIDE_M: Final = 0.03
#: Smaller bodies, and less room around resting hair, are left out, metres; taste.
_LEAST_M: Final = 0.02


def hang_tails(gltf: Any, clone: Clone) -> dict[str, Any] | None:
    """Add bones to a clone's tails, in place, and return what the extension says of them; None without a tail.

    Parameters
    ----------
    gltf : pygltflib.GLTF2
        As `cloner.exporters.gltf.gltf.build` made it of this very clone, with H-Anim's joints.
    clone : Clone
    """
    found = tails(clone)
    if not found:
        return None
    nodes = {node.name: number for number, node in enumerate(gltf.nodes)}
    chains = [_add_bones(gltf, clone, tail, number, nodes) for number, tail in enumerate(found)]
    for shell in sorted({tail.shell for tail in found}):
        _weigh(gltf, clone, shell, [(tail, chain) for tail, chain in zip(found, chains, strict=True)
                                    if tail.shell == shell])  # fmt: skip
    _bind(gltf, np.vstack([tail.points_m[:-1] for tail in found]))
    bodies = _bodies(clone, found)
    return {
        "specVersion": "1.0",
        "colliders": [{"node": nodes[BODIES[name][0]], "shape": shape} for name, shape in bodies.items()],
        "colliderGroups": [{"name": "body", "colliders": list(range(len(bodies)))}] if bodies else [],
        "springs": [
            {
                "name": gltf.nodes[chain[0]].name,
                "joints": [_joint(node, k, float(tail.radius_m[k])) for k, node in enumerate(chain)],
                "colliderGroups": [0] if bodies else [],
            }
            for tail, chain in zip(found, chains, strict=True)
        ],
    }


def _joint(node: int, place: int, radius_m: float) -> dict[str, Any]:
    return {
        "node": node, "hitRadius": round(radius_m, 4), "stiffness": STIFFNESS[min(place, len(STIFFNESS) - 1)],
        "gravityPower": GRAVITY, "gravityDir": [0.0, -1.0, 0.0], "dragForce": DRAG,
    }  # fmt: skip


def _add_bones(gltf: Any, clone: Clone, tail: Tail, number: int, nodes: dict[str, int]) -> list[int]:
    """Add the nodes of a tail's chain below the skull, its end among them, and return them."""
    skull = nodes["skullbase"]
    first, above = len(gltf.nodes), clone.joints_m[load_generic().joint("skullbase")]
    for place, point in enumerate(tail.points_m):
        name = f"hair_tail{number + 1}_{place + 1}"
        gltf.nodes.append(pygltflib.Node(name=name, translation=(point - above).tolist(), children=[]))
        parent = skull if place == 0 else first + place - 1
        gltf.nodes[parent].children = [*(gltf.nodes[parent].children or []), first + place]
        above = point
    return list(range(first, first + len(tail.points_m)))


def _weigh(gltf: Any, clone: Clone, shell: int, hung: Sequence[tuple[Tail, list[int]]]) -> None:
    """Let bones carry a shell's tails: its joints and weights are written anew where they lie."""
    row = sum(one.kind == "hair" for one in clone.shells[:shell])
    mesh = next(mesh for mesh in gltf.meshes if mesh.name == "Hair")
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


def _bodies(clone: Clone, found: Sequence[Tail]) -> dict[str, dict[str, Any]]:
    """Return the shapes that resting hair does not touch, by name, as large as the body and that rest allow."""
    generic, shapes = load_generic(), {}
    points = np.vstack([tail.points_m for tail in found])
    radii = np.concatenate([tail.radius_m for tail in found])
    scalp = clone.vertices_m[generic.region("scalp")]
    for name, (joint, end) in BODIES.items():
        node = clone.joints_m[generic.joint(joint)]
        first = 0.5 * (scalp.min(axis=0) + scalp.max(axis=0)) if end is None else node
        last = first if end is None else clone.joints_m[generic.joint(end)]
        skin = scalp if end is None else clone.vertices_m[generic.skin]
        radius = min(_thick(skin, first, last), float((_away(points, first, last) - radii).min()))
        if radius < _LEAST_M:
            continue
        told = {"offset": _rounded(first - node), "radius": round(radius, 4)}
        shapes[name] = {"sphere": told} if end is None else {"capsule": {**told, "tail": _rounded(last - node)}}
    return shapes


def _thick(skin_m: Array, first: Array, last: Array) -> float:
    """Return the median distance of the skin behind a stretch of spine from it, metres."""
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
