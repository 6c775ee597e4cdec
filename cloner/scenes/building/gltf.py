"""A room as a binary glTF file, with light maps if it is lit.

glTF has no light map of its own: the second texture coordinates are ordinary, and the map hangs on each material as
``MOZ_lightmap`` (Hubs and its Blender add-on read it; others show the room without).

References: Khronos Group 2021, glTF 2.0; Mozilla Hubs 2020, MOZ_lightmap.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner import __version__
from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.exporters.shared.files import jpeg_bytes, png_bytes
from cloner.records.arrays import Array
from cloner.scenes.building.charts import Chart, make_charts
from cloner.scenes.building.looks import Look
from cloner.scenes.building.solids import Panel, Room

LIGHT_MAP: Final = "MOZ_lightmap"
#: What a full texel of the map stands for: brighter is white on any surface that gives back half of it.
BRIGHTEST: Final = 2.0
_LINEAR, _TRILINEAR, _REPEAT, _CLAMP = 9729, 9987, 10497, 33071


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """All parts with one look: (N, 3) positions, metres, and unit normals; (N, 2) uv and light-map uv; (T, 3)
    triangles.
    """

    look: str
    places: Array
    normals: Array
    uv: Array
    light_uv: Array
    triangles: NDArray[np.int64]


def make_meshes(charts: tuple[Chart, ...], size: tuple[int, int], looks: Mapping[str, Look]) -> list[Mesh]:
    """Return the meshes of a room, one per look."""
    found: dict[str, list[tuple[Array, Array, Array, Array]]] = {}
    for chart in charts:
        panel = chart.panel
        for (u0, v0, u1, v1), look in panel.parts:
            u, v = np.array([u0, u1, u1, u0]), np.array([v0, v0, v1, v1])
            uv = (np.stack([u, v], axis=1) - _texture_origin(panel, look, looks)) * (1.0, -1.0) / looks[look].span_m
            normals = np.tile(panel.normal, (4, 1))
            found.setdefault(look, []).append((panel.at(u, v), normals, uv, chart.uv(u, v, size)))
    made = []
    for look, rows in sorted(found.items()):
        parts = [np.concatenate(one) for one in zip(*rows, strict=True)]
        corners = np.array([[0, 1, 2], [0, 2, 3]])
        triangles = (4 * np.arange(len(rows))[:, None, None] + corners).reshape(-1, 3)
        made.append(Mesh(look, parts[0], parts[1], parts[2], parts[3], triangles))
    return made


def _texture_origin(panel: Panel, name: str, looks: Mapping[str, Look]) -> Array:
    """Return the origin of a look on a panel, metres: the lower left corner of its parts, or the plan's origin."""
    if looks[name].fits:
        return np.asarray(np.min([rect[:2] for rect, look in panel.parts if look == name], axis=0))
    return -np.array([panel.corner @ panel.along, panel.corner @ panel.up])


def to_bytes(light: NDArray[np.float32], brightest: float = BRIGHTEST) -> NDArray[np.uint8]:
    """Return a light map as sRGB bytes; ``brightest`` becomes white."""
    linear = np.clip(light / brightest, 0.0, 1.0)
    srgb = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)
    return np.asarray((srgb * 255.0 + 0.5).astype(np.uint8))


def room_glb(room: Room, light: NDArray[np.float32] | None = None) -> bytes:
    """Return a room as a GLB file's content.

    Parameters
    ----------
    room : Room
    light : (H, W, 3) or None
        The map of :func:`cloner.scenes.lighting.light.light_room`, with texels of usual sizes.
    """
    charts, size = make_charts(room)
    gltf = pygltflib.GLTF2(asset=pygltflib.Asset(version="2.0", generator=f"Cloner {__version__}"), scene=0)
    buffer = GltfBuffer(gltf, np.zeros((2, 3)))
    gltf.samplers = [
        pygltflib.Sampler(magFilter=_LINEAR, minFilter=_TRILINEAR, wrapS=_REPEAT, wrapT=_REPEAT),
        pygltflib.Sampler(magFilter=_LINEAR, minFilter=_LINEAR, wrapS=_CLAMP, wrapT=_CLAMP),
    ]
    lamp: dict[str, Any] = {}
    if light is not None:
        number = _picture(gltf, buffer, "light", png_bytes(to_bytes(light)), "image/png", 1)
        lamp = {LIGHT_MAP: {"index": number, "texCoord": 1, "intensity": BRIGHTEST}}
        gltf.extensionsUsed = [LIGHT_MAP]
    primitives = []
    for mesh in make_meshes(charts, size, room.looks):
        number = _picture(gltf, buffer, mesh.look, jpeg_bytes(room.looks[mesh.look].pixels), "image/jpeg", 0)
        shine = pygltflib.PbrMetallicRoughness(
            baseColorTexture=pygltflib.TextureInfo(index=number), metallicFactor=0.0, roughnessFactor=0.9
        )
        material = pygltflib.Material(name=mesh.look, pbrMetallicRoughness=shine, alphaCutoff=None, extensions=lamp)
        gltf.materials.append(material)
        attributes = pygltflib.Attributes(
            POSITION=buffer.positions(mesh.places), NORMAL=buffer.normals(mesh.normals),
            TEXCOORD_0=buffer.uv(mesh.uv), TEXCOORD_1=buffer.uv(mesh.light_uv),
        )  # fmt: skip
        primitives.append(
            pygltflib.Primitive(attributes=attributes, indices=buffer.indices(mesh.triangles),
                                material=len(gltf.materials) - 1)
        )  # fmt: skip
    gltf.meshes.append(pygltflib.Mesh(name=room.plan.name, primitives=primitives))
    gltf.nodes.append(pygltflib.Node(name=room.plan.name, mesh=0))
    gltf.scenes.append(pygltflib.Scene(name=room.plan.name, nodes=[0]))
    data = buffer.data()
    gltf.buffers.append(pygltflib.Buffer(byteLength=len(data)))
    gltf.set_binary_blob(data)
    return glb_bytes(gltf)


def _picture(gltf: Any, buffer: GltfBuffer, name: str, data: bytes, kind: str, sampler: int) -> int:
    gltf.images.append(pygltflib.Image(name=name, mimeType=kind, bufferView=buffer.view(data)))
    gltf.textures.append(pygltflib.Texture(sampler=sampler, source=len(gltf.images) - 1, name=name))
    return len(gltf.textures) - 1
