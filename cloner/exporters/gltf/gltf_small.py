"""A small glTF for the web: quantised, compressed, with textures of half the size.

Positions keep 1/32767 of the person's box (some 0.03 mm), normals half a degree, texture coordinates a thirtieth of a
texel, quaternions of motions a 250th of a degree.

References
----------
Khronos Group 2021, KHR_mesh_quantization; glTF 2.0 specification, 3.6.2 (normalised integers), 3.11 (animations).
"""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray
from PIL import Image

from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf import build
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.exporters.gltf.gltf_packed import pack
from cloner.exporters.shared.files import write_bytes
from cloner.motion.limbs.rig import centre_joints
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.heads import Shell

EXTENSION: Final = "KHR_mesh_quantization"
WEBP: Final = "EXT_texture_webp"
WEBP_QUALITY: Final = 85  # taste: no difference seen on a face at its pictures' own size
SMALLEST_OFFSET_M: Final = 1e-4  # what moves less is not seen at a picture's size; a third of the targets' rows
#: Largest number of 16 bits with a sign.
FULL: Final = 32767
HALVED_ABOVE_PX: Final = 512  # smaller pictures stay; taste


class QuantisedBuffer(GltfBuffer):
    """Stores normalised integers; what turns positions back into metres lies in the bind matrices.

    Who reads this reads sparse accessors without a view as well.
    """

    founded = False

    def __init__(self, gltf: Any, box_m: Array) -> None:
        super().__init__(gltf, box_m)
        self._middle_m = box_m.mean(axis=0)
        self._half_m = float(np.ptp(box_m, axis=0).max()) / 2.0
        self._places: dict[str, int] = {}
        self._kept: dict[str, bytearray] = {}
        gltf.extensionsUsed = [*gltf.extensionsUsed, EXTENSION]
        gltf.extensionsRequired = [EXTENSION]

    def positions(self, values_m: Array) -> int:
        """Add positions in -1..1 of the box."""
        return self._padded(_whole((values_m - self._middle_m) / self._half_m, FULL, np.int16), bounds=True)

    def normals(self, values: Array) -> int:
        """Add normals as bytes."""
        return self._padded(_whole(values, 127, np.int8))

    def uv(self, values: Array) -> int:
        """Add texture coordinates as short integers."""
        return self.attribute(_whole(np.clip(values, 0.0, 1.0), 65535, np.uint16), normalised=True)

    def skin(self, bones: NDArray[np.integer], weights: Array) -> tuple[int, int]:
        """Add bones, and weights as bytes whose sum is exactly 255."""
        whole = np.floor(weights * 255.0 + 1e-6).astype(np.int64)
        heaviest = whole.argmax(axis=1)
        whole[np.arange(len(whole)), heaviest] += 255 - whole.sum(axis=1)
        used = np.where(whole > 0, bones, 0).astype(np.uint8)
        return self.attribute(used), self.attribute(whole.astype(np.uint8), normalised=True)

    def offsets(self, count: int, index: NDArray[Any], values: NDArray[np.float32]) -> int:
        """Add offsets of a morph target in the positions' unit."""
        seen = np.abs(values).max(axis=1, initial=0.0) > SMALLEST_OFFSET_M
        index, values = index[seen], values[seen]
        whole = _whole(np.asarray(values, dtype=np.float64) / self._half_m, FULL, np.int16)
        return self.sparse(count, index, whole)

    def stored(self, rows: NDArray[Any], values: NDArray[Any]) -> tuple[Any, Any]:
        """Return where rows and values of a sparse accessor lie."""
        places = [self._beside(name, own) for name, own in (("rows", rows), ("values", values))]
        return (
            pygltflib.AccessorSparseIndices(**places[0], componentType=pygltflib.UNSIGNED_SHORT),
            pygltflib.AccessorSparseValues(**places[1]),
        )

    def _beside(self, name: str, values: NDArray[Any]) -> dict[str, int]:
        """Return where values lie in the one view of their name: like things side by side pack best."""
        if name not in self._places:
            self._places[name], self._kept[name] = self.view(b""), bytearray()
        place = {"bufferView": self._places[name], "byteOffset": len(self._kept[name])}
        self._kept[name] += values.tobytes()
        return place

    def data(self) -> bytes:
        """Return everything added so far."""
        for name, number in self._places.items():
            self.fill(number, bytes(self._kept[name]))
        return super().data()

    def turns(self, values: Array) -> int:
        """Add quaternions as short integers."""
        whole = _whole(values, FULL, np.int16)
        place = self._beside("turns", whole)
        return self.accessor(whole, place["bufferView"], normalised=True, offset=place["byteOffset"])

    def bind(self, values: Array) -> int:
        """Add bind matrices that first turn positions back into metres."""
        metres = np.diag([*[self._half_m] * 3, 1.0])
        metres[:3, 3] = self._middle_m
        return self.matrices(values @ metres)

    def _padded(self, values: NDArray[Any], *, bounds: bool = False) -> int:
        """Add (N, 3) short numbers with every row on 4 bytes, as vertex attributes must lie."""
        rows = np.zeros((len(values), 4), dtype=values.dtype)
        rows[:, :3] = values
        view = self.view(rows.tobytes(), pygltflib.ARRAY_BUFFER, stride=rows.itemsize * 4)
        return self.accessor(values, view, bounds=bounds, normalised=True)


def _whole(values: Array, full: int, kind: Any) -> NDArray[Any]:
    return np.rint(np.clip(values, -1.0, 1.0) * full).astype(kind)


def export(clone: Clone, folder: Path, *, name: str = "clone") -> tuple[Path, ...]:
    """Write ``<name>_small.glb`` and return its path.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    path = folder / f"{name}_small.glb"
    gltf = build(_with_half_pictures(centre_joints(clone)), buffer_type=QuantisedBuffer)
    _as_webp(gltf)
    pack(gltf)
    write_bytes(path, glb_bytes(gltf))
    return (path,)


def _as_webp(gltf: Any) -> None:
    """Store every picture as WebP, in place: at a like look half of JPEG and a third of PNG."""
    blob = gltf.binary_blob()
    parts: list[bytes] = []
    pictures = {image.bufferView: image for image in gltf.images}
    for number, view in enumerate(gltf.bufferViews):
        start = view.byteOffset or 0
        data = blob[start : start + view.byteLength]
        if number in pictures:
            data, pictures[number].mimeType = _webp(data), "image/webp"
        view.byteOffset, view.byteLength = sum(len(part) for part in parts), len(data)
        parts.append(data + b"\0" * (-len(data) % 4))
    for texture in gltf.textures:
        texture.extensions = {WEBP: {"source": texture.source}}
        texture.source = None
    gltf.extensionsUsed, gltf.extensionsRequired = [*gltf.extensionsUsed, WEBP], [*gltf.extensionsRequired, WEBP]
    gltf.set_binary_blob(b"".join(parts))
    gltf.buffers[0].byteLength = len(gltf.binary_blob())


def _webp(data: bytes) -> bytes:
    stream = io.BytesIO()
    with Image.open(io.BytesIO(data)) as picture:
        picture.save(stream, "WEBP", quality=WEBP_QUALITY, method=4, alpha_quality=WEBP_QUALITY)
    return stream.getvalue()


def _with_half_pictures(clone: Clone) -> Clone:
    atlas = replace(clone.atlas, rgb=half_size(clone.atlas.rgb), coverage=half_size(clone.atlas.coverage))
    return replace(clone, atlas=atlas, shells=tuple(_half_shell(shell) for shell in clone.shells))


def _half_shell(shell: Shell) -> Shell:
    return replace(shell, rgba=half_size(shell.rgba))


def half_size(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a picture (H, W[, C]) of half the size, each pixel the mean of four; small and odd ones as they are."""
    height, width = pixels.shape[:2]
    if min(height, width) <= HALVED_ABOVE_PX or height % 2 or width % 2:
        return pixels
    total = sum(pixels[row::2, column::2].astype(np.uint16) for row in (0, 1) for column in (0, 1))
    return np.asarray((total + np.uint16(2)) >> np.uint16(2), dtype=np.uint8)
