"""Serialisation of binary glTF.

``pygltflib`` writes them too, but copies every part deeply on the way: a quarter of a file's whole time.

References
----------
Khronos Group 2021, glTF 2.0 specification, section 4 (GLB).
"""

from __future__ import annotations

import json
import struct
from dataclasses import fields, is_dataclass
from typing import Any, Final

from pygltflib import Attributes

#: The chunks' types by the glTF 2.0 specification: "JSON" and "BIN".
_JSON, _BIN = 0x4E4F534A, 0x004E4942
_HEADS: Final = 28  # the file's head and those of its two chunks, bytes


def glb_bytes(gltf: Any) -> bytes:
    """Return a ``pygltflib.GLTF2`` with its binary blob as a file, without bytes that no view of one buffer names."""
    blob = gltf.binary_blob()
    if len(gltf.buffers) == 1:
        blob = _packed(gltf, blob)
    text = json.dumps(_plain_values(gltf), separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    return b"".join([
        struct.pack("<4sIIII", b"glTF", 2, _HEADS + len(text) + len(blob), len(text), _JSON), text,
        struct.pack("<II", len(blob), _BIN), blob,
    ])  # fmt: skip


def _packed(gltf: Any, blob: bytes) -> bytes:
    """Return the bytes that views name, one behind the other on 4 bytes; views, buffer and blob are set to that."""
    parts: list[bytes] = []
    length = 0
    for view in gltf.bufferViews:
        start = view.byteOffset or 0
        data = blob[start : start + view.byteLength]
        view.byteOffset = length
        parts += [data, b"\0" * (-len(data) % 4)]
        length += len(data) + len(parts[-1])
    gltf.buffers[0].byteLength = length
    packed = b"".join(parts)
    gltf.set_binary_blob(packed)
    return packed


def _plain_values(value: Any) -> Any:
    """Return a part of the file as plain values, without what is empty; an extension's own parts may be."""
    if isinstance(value, Attributes):
        value = value.__dict__
    elif is_dataclass(value):
        value = {field.name: getattr(value, field.name) for field in fields(value)}
    if isinstance(value, dict):
        return {
            name: own if name == "extensions" else _plain_values(own)
            for name, own in value.items()
            if not _is_empty(own)
        }
    return [_plain_values(own) for own in value] if isinstance(value, (list, tuple)) else value


def _is_empty(value: Any) -> bool:
    return value is None or (hasattr(value, "__len__") and len(value) == 0)
