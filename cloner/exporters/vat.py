"""Vertex animation textures in OpenVAT's layout: offsets of every vertex of one mesh, a frame a row.

``NAME.png`` (16 bits, RGB): frames below one another, a column a vertex; the upper half are offsets from the rest pose
in the box of ``NAME-remap_info.json``, the lower half normals. Axes are OpenVAT's (z up: a reader takes (x, z, -y)).

References
----------
OpenVAT (sharpen3d): layout of pictures and remap file, read off its documentation and readers.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, Final

import cv2
import numpy as np
import pygltflib

from cloner.errors import ClonerError
from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.records.arrays import Array

#: What one is in a picture of 16 bits.
FULL: Final = 65_535
#: Readers of the layout take no mesh with more vertices: a picture is as wide.
MOST_VERTICES: Final = 8192
#: What a picture's name ends with, and its remap file's instead.
PICTURE, REMAP = ".png", "-remap_info.json"


def check_count(count: int, name: str) -> None:
    """Refuse a mesh that has more vertices than readers take.

    Raises
    ------
    ClonerError
        If it has.
    """
    if count > MOST_VERTICES:
        message = f"{count} points are more than the {MOST_VERTICES} that readers of vertex animation textures take"
        raise ClonerError(message, "Give a shorter one with --length, or --out a name that ends with .pc2", name)


def vat_pictures(rest_m: Array, moved_m: Array, normals: Array, animations: Mapping[str, Any]) -> dict[str, bytes]:
    """Return a picture and its remap file by the ends of their names.

    Parameters
    ----------
    rest_m : (N, 3)
        The mesh at rest, model frame, metres.
    moved_m, normals : (F, N, 3)
        Its places and normals in every frame.
    animations : mapping
        What lies in which frames: name to ``startFrame``, ``endFrame``, ``framerate`` and ``looping``.
    """
    offsets = _engine_axes(moved_m - rest_m)
    low, high = offsets.min(axis=(0, 1)), offsets.max(axis=(0, 1))
    whole = np.round((offsets - low) / np.maximum(high - low, 1e-9) * FULL).astype(np.uint16)
    turned = np.round((_engine_axes(normals) + 1.0) / 2.0 * FULL).astype(np.uint16)
    remap = {
        "os-remap": {"Min": low.tolist(), "Max": high.tolist(), "Frames": len(moved_m)}, "animations": dict(animations),
    }  # fmt: skip
    done, data = cv2.imencode(PICTURE, np.concatenate([whole, turned])[..., ::-1])
    if not done:
        raise ValueError("a picture could not be encoded")
    return {PICTURE: data.tobytes(), REMAP: (json.dumps(remap, indent=1) + "\n").encode()}


def columns(count: int, frames: int) -> Array:
    """Return (N, 2) the second texture coordinates of a mesh: where each vertex's column begins."""
    return np.column_stack([(np.arange(count) + 0.5) / count, np.full(count, 1.0 - 0.5 / (2 * frames))])


def mesh_glb(gltf: Any, buffer: GltfBuffer, primitive: Any, name: str, scene: str) -> bytes:
    """Return the file of a mesh of one primitive, whose second texture coordinates are its `columns`."""
    gltf.meshes.append(pygltflib.Mesh(name=name, primitives=[primitive]))
    gltf.nodes.append(pygltflib.Node(name=name, mesh=0))
    gltf.scenes.append(pygltflib.Scene(name=scene, nodes=[0]))
    data = buffer.data()
    gltf.buffers.append(pygltflib.Buffer(byteLength=len(data)))
    gltf.set_binary_blob(data)
    return glb_bytes(gltf)


def _engine_axes(vectors: Array) -> Array:
    """Return (..., 3) vectors of the model frame (Y up) in the layout's axes (Z up)."""
    return np.stack([vectors[..., 0], -vectors[..., 2], vectors[..., 1]], axis=-1)
