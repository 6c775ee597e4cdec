"""Compression of glTF buffer views by EXT_meshopt_compression, in place.

References
----------
Khronos Group 2022, EXT_meshopt_compression: packed views lie in the file's own buffer; the buffer they stand for has a
length and no bytes ("fallback").
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any, Final

import numpy as np
import pygltflib

from cloner.exporters.gltf import meshopt

EXTENSION: Final = "EXT_meshopt_compression"
#: Shorter views stay as they are, bytes; taste: the extension's own text is 150.
SHORTEST: Final = 256
#: Widest element that can be packed, bytes.
WIDEST: Final = 256
_BYTES: Final = {pygltflib.UNSIGNED_BYTE: 1, pygltflib.BYTE: 1, pygltflib.SHORT: 2, pygltflib.UNSIGNED_SHORT: 2,
                 pygltflib.UNSIGNED_INT: 4, pygltflib.FLOAT: 4}  # fmt: skip
_WIDTH: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
_INDEX: Final = {pygltflib.UNSIGNED_SHORT: np.uint16, pygltflib.UNSIGNED_INT: np.uint32}


Packed = tuple[bytes, dict[str, Any]]


def pack(gltf: Any) -> None:
    """Pack every view of numbers that gets smaller by it, in place; pictures stay."""
    blob = gltf.binary_blob()
    pictures = {image.bufferView for image in gltf.images}
    ways, strides = _ways(gltf), _strides(gltf)
    chunks: list[bytes] = []
    own = elsewhere = 0
    for number, view in enumerate(gltf.bufferViews):
        data = blob[view.byteOffset or 0 :][: view.byteLength]
        packed = None
        if number not in pictures and len(data) >= SHORTEST:
            way = ways[number] if number in ways else _attributes(strides[number])
            packed = way(data)
        if packed is not None and len(packed[0]) < len(data):
            stored, properties = packed
            view.extensions = {EXTENSION: {"buffer": 0, "byteOffset": own, "byteLength": len(stored), **properties}}
            view.buffer, view.byteOffset = 1, elsewhere
            view.byteLength = properties["byteStride"] * properties["count"]
            elsewhere += -(-view.byteLength // 4) * 4
        else:
            stored, view.byteOffset = data, own
        chunks.append(stored + bytes(-len(stored) % 4))
        own += len(chunks[-1])
    gltf.buffers = [
        pygltflib.Buffer(byteLength=own),
        pygltflib.Buffer(byteLength=elsewhere, extensions={EXTENSION: {"fallback": True}}),
    ]
    gltf.extensionsUsed = [*gltf.extensionsUsed, EXTENSION]
    gltf.extensionsRequired = [*gltf.extensionsRequired, EXTENSION]
    gltf.set_binary_blob(b"".join(chunks))


def _ways(gltf: Any) -> dict[int, Callable[[bytes], Packed]]:
    """Return how views of indices are packed; all others hold attributes."""
    found: dict[int, Callable[[bytes], Packed]] = {}
    for mesh in gltf.meshes:
        for primitive in mesh.primitives:
            accessor = gltf.accessors[primitive.indices]
            found[accessor.bufferView] = _indices(_INDEX[accessor.componentType], "TRIANGLES")
    for accessor in gltf.accessors:
        if accessor.sparse is not None:
            rows = accessor.sparse.indices
            found[rows.bufferView] = _indices(_INDEX[rows.componentType], "INDICES")
    return found


def _indices(kind: Any, mode: str) -> Callable[[bytes], Packed]:
    def packed(data: bytes) -> Packed:
        values = np.frombuffer(data, kind)
        if mode == "INDICES":
            stored = meshopt.sequence(values)
        else:
            stored = _packed_triangles(data, np.dtype(kind).str)
        return stored, {"byteStride": values.itemsize, "count": len(values), "mode": mode}

    return packed


@lru_cache(maxsize=8)  # those of the generic human are everybody's
def _packed_triangles(data: bytes, kind: str) -> bytes:
    return meshopt.triangles(meshopt.order_by_adjacency(np.frombuffer(data, kind).reshape(-1, 3)))


def _strides(gltf: Any) -> dict[int, int]:
    """Return the bytes of one element of every view; others than multiples of 4 go in pairs, or by fours."""
    found = {}
    for accessor in gltf.accessors:
        row = _BYTES[accessor.componentType] * _WIDTH[accessor.type]
        view = accessor.bufferView if accessor.sparse is None else accessor.sparse.values.bufferView
        stride = gltf.bufferViews[view].byteStride or (row if row % 4 == 0 else 2 * row)
        found[view] = stride if stride % 4 == 0 and stride <= WIDEST else 4
    return found


def _attributes(stride: int) -> Callable[[bytes], Packed]:
    def packed(data: bytes) -> Packed:
        rows = np.frombuffer(data + bytes(-len(data) % stride), np.uint8).reshape(-1, stride)
        return meshopt.attributes(rows), {"byteStride": stride, "count": len(rows), "mode": "ATTRIBUTES"}

    return packed
