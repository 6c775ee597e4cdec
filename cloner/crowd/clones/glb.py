"""One clone's levels as a binary glTF: meshes ``ID_LOD0`` and on, one skeleton, walk and idle.

Coarser levels use the first vertices of the finer ones, so all levels share one buffer: weights, texture coordinates
and places are the same bytes. References: Khronos Group 2021, glTF 2.0 specification.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner import __version__
from cloner.crowd.clones.cast import CrowdClone
from cloner.crowd.clones.clips import Clip
from cloner.crowd.clones.groups import sorted_by_group
from cloner.crowd.clones.levels import BodyLevels, vertex_order
from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf import add_skeleton, add_texture
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.exporters.gltf.gltf_motion import add_free, animation
from cloner.exporters.shared.bones import Bones, hanim_bones
from cloner.exporters.shared.credits import CREDITS
from cloner.exporters.shared.files import jpeg_bytes, png_bytes
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

JPEG_QUALITY: Final = 85  # taste: crowds are seen from some metres
#: OpenGL's numbers, which glTF uses.
_LINEAR, _TRILINEAR, _CLAMP = 9729, 9987, 33071


def levels_glb(cast: CrowdClone, clone: Clone, body: BodyLevels) -> bytes:
    """Return a clone's levels as a GLB file's content.

    Parameters
    ----------
    cast : Cast
    clone : Clone
        The same one, for its joints.
    body : BodyLevels
    """
    gltf = pygltflib.GLTF2(
        asset=pygltflib.Asset(version="2.0", generator=f"Cloner {__version__}", copyright=CREDITS), scene=0
    )
    buffer = GltfBuffer(gltf, np.zeros((2, 3)))
    bones = hanim_bones()
    skeleton = len(clone.joints_m)
    free = cast.clips[0].frames.shape[1] - skeleton  # that carry simulated cloth
    skin = add_skeleton(gltf, buffer, clone, bones, free)
    gltf.samplers.append(pygltflib.Sampler(magFilter=_LINEAR, minFilter=_TRILINEAR, wrapS=_CLAMP, wrapT=_CLAMP))
    atlas = _material(gltf, buffer, "atlas", jpeg_bytes(cast.atlas, JPEG_QUALITY), "image/jpeg", "OPAQUE")
    loose = cast.loose
    shell = None
    if len(loose.vertices_m):
        shell = _material(gltf, buffer, "loose", png_bytes(cast.shell), "image/png", "MASK")
    own = _shared(buffer, cast.vertices_m, cast.normals, body.uv, bones.carried(body.joints, body.weights))
    own_loose = None
    order, sizes = vertex_order(loose.triangles)
    if shell is not None:
        carried = _loose_weights(bones, loose.joints[order], loose.weights[order], skeleton)
        own_loose = _shared(buffer, loose.vertices_m[order], loose.normals[order], loose.uv[order], carried)
        place = np.zeros(len(loose.vertices_m), np.int32)
        place[order] = np.arange(len(order))
    roots = [0]
    for level, triangles in enumerate(body.triangles):
        primitives = [
            pygltflib.Primitive(
                attributes=own(body.counts[level]),
                indices=buffer.indices(sorted_by_group(triangles, body.uv, cast.codes)[0]),
                material=atlas,
            )
        ]
        if shell is not None and own_loose is not None and len(loose.triangles[level]):
            indices = buffer.indices(place[loose.triangles[level]])
            primitives.append(pygltflib.Primitive(attributes=own_loose(sizes[level]), indices=indices, material=shell))
        name = f"{cast.identifier}_LOD{level}"
        gltf.meshes.append(pygltflib.Mesh(name=name, primitives=primitives))
        gltf.nodes.append(pygltflib.Node(name=name, mesh=level, skin=skin))
        roots.append(len(gltf.nodes) - 1)
    for clip in cast.clips:
        if len(clip.frames) > 1:
            gltf.animations.append(animation(buffer, clone, motion_of(clip), bones, roots[1]))
            closed = np.concatenate([clip.frames, clip.frames[:1]])[:, skeleton:]
            add_free(buffer, gltf.animations[-1], 1 + len(bones.names), closed, motion_of(clip).times_s)
    gltf.scenes.append(pygltflib.Scene(name=cast.identifier, nodes=roots))
    data = buffer.data()
    gltf.buffers.append(pygltflib.Buffer(byteLength=len(data)))
    gltf.set_binary_blob(data)
    return glb_bytes(gltf)


def _loose_weights(
    bones: Bones, joints: NDArray[np.int64], weights: Array, skeleton: int
) -> tuple[NDArray[np.int64], Array]:
    """Return bones and weights (N, 4) of loose vertices: the skeleton's, followed by the cloth's own."""
    found, share = bones.carried(np.minimum(joints, skeleton - 1), weights)
    flows = joints[:, 0] >= skeleton
    found[flows], share[flows] = joints[flows] - skeleton + len(bones.names), weights[flows]
    return found, share


def _shared(
    buffer: GltfBuffer, places: Array, normals: Array, uv: Array, carried: tuple[NDArray[np.int64], Array]
) -> Any:
    """Return a function that gives the attributes of the first vertices, all in the same buffer views."""
    joints, weights = carried
    columns: dict[str, NDArray[Any]] = {
        "POSITION": places.astype(np.float32), "NORMAL": normals.astype(np.float32),
        "TEXCOORD_0": uv.astype(np.float32),
        "JOINTS_0": joints.astype(np.uint8), "WEIGHTS_0": weights.astype(np.float32),
    }  # fmt: skip
    columns["NORMAL"] /= np.linalg.norm(columns["NORMAL"], axis=1, keepdims=True)
    views = {
        name: buffer.view(values.tobytes(), pygltflib.ARRAY_BUFFER, values.strides[0])
        for name, values in columns.items()
    }

    def attributes(count: int) -> Any:
        return pygltflib.Attributes(
            **{
                name: buffer.accessor(values[:count], views[name], bounds=name == "POSITION")
                for name, values in columns.items()
            }
        )

    return attributes


def _material(gltf: Any, buffer: GltfBuffer, name: str, data: bytes, kind: str, mode: str) -> int:
    shown = pygltflib.TextureInfo(index=add_texture(gltf, buffer, data, kind, name))
    look = pygltflib.PbrMetallicRoughness(baseColorTexture=shown, metallicFactor=0.0, roughnessFactor=0.9)
    made = pygltflib.Material(name=name, pbrMetallicRoughness=look, alphaMode=mode, doubleSided=mode != "OPAQUE")
    made.alphaCutoff = 0.4 if mode == "MASK" else None  # as in the clone's own glTF
    gltf.materials.append(made)
    return len(gltf.materials) - 1


def motion_of(clip: Clip) -> Motion:
    """Return a clip as a motion whose last frame is its first one."""
    times = np.linspace(0.0, clip.seconds, len(clip.frames) + 1)
    rotations = np.concatenate([clip.rotations, clip.rotations[:1]])
    root = np.concatenate([clip.root_m, clip.root_m[:1]])
    return Motion(clip.name, times, root, rotations, cyclic=True, speed_m_s=clip.speed_m_s)
