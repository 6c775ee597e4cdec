"""A clone's walk and idle as vertex animation textures."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner import __version__
from cloner.crowd.clones.cast import CrowdClone, skin_vertices
from cloner.crowd.clones.levels import BodyLevels
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.exporters.shared.credits import CREDITS
from cloner.exporters.shared.files import jpeg_bytes
from cloner.exporters.vat import columns, mesh_glb, vat_pictures
from cloner.records.arrays import Array

#: The finest level under 8,192 vertices with its hair: what readers of the layout take.
LEVEL: Final = 1


def vat_files(cast: CrowdClone, body: BodyLevels) -> dict[str, bytes]:
    """Return mesh, pictures and remap file by their names in the clone's folder."""
    count = body.counts[LEVEL]
    used = np.unique(cast.loose.triangles[LEVEL]).astype(np.int64)
    triangles = np.concatenate([
        body.triangles[LEVEL], count + np.searchsorted(used, cast.loose.triangles[LEVEL]).astype(np.int32),
    ])  # fmt: skip
    rest = np.concatenate([cast.vertices_m[:count], cast.loose.vertices_m[used]])
    moved, turned, animations = _frames(cast, body, count, used)
    name = f"vat/{cast.identifier}_vat"
    files = {name + end: data for end, data in vat_pictures(rest, moved, turned, animations).items()}
    return files | {f"{name}.glb": _mesh(cast, body, count, used, triangles, rest, len(moved))}


def _frames(
    cast: CrowdClone, body: BodyLevels, count: int, used: NDArray[np.int64]
) -> tuple[Array, Array, dict[str, Any]]:
    """Return (F, N, 3) positions and normals of all frames of all clips, and the index of clips."""
    moved: list[Array] = []
    turned: list[Array] = []
    animations: dict[str, Any] = {}
    joints = np.concatenate([body.joints[:count], cast.loose.joints[used]])
    weights = np.concatenate([body.weights[:count], cast.loose.weights[used]])
    rest = np.concatenate([cast.vertices_m[:count], cast.loose.vertices_m[used]])
    normals = np.concatenate([cast.normals[:count], cast.loose.normals[used]])
    for clip in cast.clips:
        animations[clip.name] = {
            "startFrame": len(moved), "endFrame": len(moved) + len(clip.frames) - 1,
            "framerate": len(clip.frames) / clip.seconds, "looping": True,
        }  # fmt: skip
        for frame in clip.frames:
            moved.append(skin_vertices(rest, joints, weights, frame))
            turning = frame.copy()
            turning[..., 3] = 0.0
            n = skin_vertices(normals, joints, weights, turning)
            turned.append(n / np.linalg.norm(n, axis=1, keepdims=True))
    return np.stack(moved), np.stack(turned), animations


def _mesh(
    cast: CrowdClone,
    body: BodyLevels,
    count: int,
    used: NDArray[np.int64],
    triangles: NDArray[np.int32],
    rest: Array,
    frames: int,
) -> bytes:
    """Return the mesh in rest pose: one primitive; the second texture coordinate is each vertex's column."""
    gltf = pygltflib.GLTF2(
        asset=pygltflib.Asset(version="2.0", generator=f"Cloner {__version__}", copyright=CREDITS), scene=0
    )
    buffer = GltfBuffer(gltf, np.zeros((2, 3)))
    normals = np.concatenate([cast.normals[:count], cast.loose.normals[used]])
    picture = np.concatenate([cast.atlas, np.zeros((cast.shell.shape[0], cast.atlas.shape[1], 3), np.uint8)])
    picture[len(cast.atlas) :, : cast.shell.shape[1]] = cast.shell[..., :3]
    uv = np.concatenate([body.uv[:count], cast.loose.uv[used]])
    tall = len(picture)
    uv[:count, 1] *= len(cast.atlas) / tall
    uv[count:, 0] *= cast.shell.shape[1] / picture.shape[1]
    uv[count:, 1] = (len(cast.atlas) + uv[count:, 1] * cast.shell.shape[0]) / tall
    gltf.images.append(
        pygltflib.Image(name="atlas", mimeType="image/jpeg", bufferView=buffer.view(jpeg_bytes(picture, 85)))
    )
    gltf.textures.append(pygltflib.Texture(source=0, name="atlas"))
    look = pygltflib.PbrMetallicRoughness(
        baseColorTexture=pygltflib.TextureInfo(index=0), metallicFactor=0.0, roughnessFactor=0.9
    )
    gltf.materials.append(pygltflib.Material(name="atlas", pbrMetallicRoughness=look, doubleSided=True))
    attributes = pygltflib.Attributes(
        POSITION=buffer.positions(rest), NORMAL=buffer.normals(normals), TEXCOORD_0=buffer.uv(uv),
        TEXCOORD_1=buffer.uv(columns(len(rest), frames)),
    )  # fmt: skip
    primitive = pygltflib.Primitive(attributes=attributes, indices=buffer.indices(triangles), material=0)
    return mesh_glb(gltf, buffer, primitive, f"{cast.identifier}_LOD{LEVEL}", cast.identifier)
