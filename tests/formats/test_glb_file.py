"""The binary file is what another library would have written, and what it reads back."""

from __future__ import annotations

import json

import numpy as np
import pygltflib

from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf import build
from kit.clones import toy_clone


def test_it_is_the_file_that_pygltflib_writes() -> None:
    gltf = build(toy_clone())
    assert glb_bytes(gltf) == b"".join(gltf.save_to_bytes())


def test_bytes_without_a_view_are_left_out_and_empty_extensions_kept() -> None:
    gltf = pygltflib.GLTF2(asset=pygltflib.Asset(version="2.0"), extensions={"VENDOR_mark": {}})
    gltf.set_binary_blob(b"gone" + bytes(range(8)))
    gltf.buffers.append(pygltflib.Buffer(byteLength=12))
    gltf.bufferViews.append(pygltflib.BufferView(buffer=0, byteOffset=4, byteLength=5))
    data = glb_bytes(gltf)
    again = pygltflib.GLTF2.load_from_bytes(data)
    assert again.binary_blob() == bytes([0, 1, 2, 3, 4, 0, 0, 0])
    assert again.bufferViews[0].byteOffset == 0
    size, kind = np.frombuffer(data[12:20], "<u4")
    told = json.loads(data[20 : 20 + size])
    assert kind == 0x4E4F534A
    assert told["extensions"] == {"VENDOR_mark": {}}
    assert "images" not in told
    assert len(data) == int.from_bytes(data[8:12], "little")
