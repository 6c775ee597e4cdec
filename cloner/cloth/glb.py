"""A dressed clone as GLB: one morph target per frame, with covered skin masked."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner.cloth.dressing import DressedClone
from cloner.cloth.simulation.covered import deeply_covered
from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf import build
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.generic.surfaces import load_surfaces
from cloner.geometry.meshes.wedges import vertex_normals

#: Material of cloth; taste.
ROUGHNESS: Final = 0.9
#: The material of skin under cloth.
MASKED: Final = "under the garment"


class _AppendedBuffer(GltfBuffer):
    """A buffer that continues a finished file's."""

    def __init__(self, gltf: Any, before: bytes) -> None:
        super().__init__(gltf, np.zeros((2, 3)))
        self._chunks, self._length = [before], len(before)


def glb(found: DressedClone) -> bytes:
    """Return the walking clone with its garments: one morph target per frame, switched by the walk's own animation.

    Skin that cloth always covers has a material of its own, which is not seen; nothing is taken away.
    """
    gltf = build(found.clone, moves=lambda _: (found.motion,))
    _hide(gltf, np.any([deeply_covered(one.worn, one.loop.frames_m) for one in found.layers], axis=0))
    buffer = _AppendedBuffer(gltf, gltf.binary_blob())
    for number, one in enumerate(found.layers, start=1):
        _add(gltf, buffer, one, "Garment" if number == 1 else f"Garment {number}")
    data = buffer.data()
    gltf.buffers[0].byteLength = len(data)
    gltf.set_binary_blob(data)
    return glb_bytes(gltf)


def _add(gltf: Any, buffer: GltfBuffer, one: DressedClone, name: str) -> None:
    """Add a garment's mesh with its targets, its material, and the keys of each target."""
    cloth, frames = one.worn.cloth, one.loop.frames_m
    faces = cloth.faces.astype(np.int32)
    normals = np.array([vertex_normals(frame, faces) for frame in frames])
    points, turned = frames[:, cloth.vertex], normals[:, cloth.vertex]
    attributes = pygltflib.Attributes(
        POSITION=buffer.positions(points[0]), NORMAL=buffer.normals(turned[0]), TEXCOORD_0=buffer.uv(cloth.flat_m)
    )
    targets = [
        {
            "POSITION": buffer.positions(points[k] - points[0]),
            "NORMAL": buffer.attribute((turned[k] - turned[0]).astype(np.float32)),
        }
        for k in range(1, len(points))
    ]
    colour = [*one.fabric.linear_rgb(), 1.0]
    look = pygltflib.PbrMetallicRoughness(baseColorFactor=colour, metallicFactor=0.0, roughnessFactor=ROUGHNESS)
    gltf.materials.append(pygltflib.Material(name=one.fabric.name, pbrMetallicRoughness=look, doubleSided=True))
    primitive = pygltflib.Primitive(
        attributes=attributes, indices=buffer.indices(cloth.triangles.astype(np.int32)),
        material=len(gltf.materials) - 1, targets=targets,
    )  # fmt: skip
    gltf.meshes.append(pygltflib.Mesh(name=name, primitives=[primitive], weights=[0.0] * len(targets)))
    gltf.nodes.append(pygltflib.Node(name=name, mesh=len(gltf.meshes) - 1))
    gltf.scenes[0].nodes.append(len(gltf.nodes) - 1)
    _show_in_turn(gltf, buffer, len(points), float(one.motion.times_s[-1]), len(gltf.nodes) - 1)


def _show_in_turn(gltf: Any, buffer: GltfBuffer, count: int, seconds: float, node: int) -> None:
    """Add to the first animation that one frame's target after the other is fully on; the first frame needs none."""
    weights = np.zeros((count + 1, count - 1))
    weights[np.arange(1, count), np.arange(count - 1)] = 1.0
    times = buffer.values(np.arange(count + 1) / count * seconds, bounds=True)
    made = gltf.animations[0]
    output = buffer.values(weights.reshape(-1))
    made.samplers.append(pygltflib.AnimationSampler(input=times, output=output, interpolation="LINEAR"))
    target = pygltflib.AnimationChannelTarget(node=node, path="weights")
    made.channels.append(pygltflib.AnimationChannel(sampler=len(made.samplers) - 1, target=target))


def _hide(gltf: Any, hidden: NDArray[np.bool_]) -> None:
    """Give the skin's triangles whose three vertices are hidden (V,) a primitive with an invisible material."""
    surface, primitive = load_surfaces()[0], gltf.meshes[0].primitives[0]
    under = hidden[surface.vertex[surface.triangles]].all(axis=1)
    if not under.any() or under.all():
        return
    accessor = gltf.accessors[primitive.indices]
    view = gltf.bufferViews[accessor.bufferView]
    kind = np.dtype({pygltflib.UNSIGNED_SHORT: np.uint16, pygltflib.UNSIGNED_INT: np.uint32}[accessor.componentType])
    ordered = np.concatenate([surface.triangles[~under], surface.triangles[under]]).astype(kind).tobytes()
    start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
    blob = bytearray(gltf.binary_blob())
    blob[start : start + len(ordered)] = ordered
    gltf.set_binary_blob(bytes(blob))
    accessor.count = 3 * int((~under).sum())
    rest = pygltflib.Accessor(
        bufferView=accessor.bufferView, byteOffset=(accessor.byteOffset or 0) + accessor.count * kind.itemsize,
        componentType=accessor.componentType, count=3 * int(under.sum()), type="SCALAR",
    )  # fmt: skip
    gltf.accessors.append(rest)
    look = pygltflib.PbrMetallicRoughness(baseColorFactor=[1.0, 1.0, 1.0, 0.0], metallicFactor=0.0)
    gltf.materials.append(pygltflib.Material(name=MASKED, pbrMetallicRoughness=look, alphaMode="MASK", alphaCutoff=0.5))
    gltf.meshes[0].primitives.append(
        pygltflib.Primitive(
            attributes=primitive.attributes, indices=len(gltf.accessors) - 1, material=len(gltf.materials) - 1,
            targets=primitive.targets,
        )
    )  # fmt: skip
