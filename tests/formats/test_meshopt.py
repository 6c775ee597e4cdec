"""Packed number streams against the decoder that three.js ships, which others wrote."""

from __future__ import annotations

import json
import subprocess

import numpy as np
import pytest

from cloner.exporters.gltf import meshopt
from kit.readers import HAS_DECODER, NODE

pytestmark = pytest.mark.skipif(not HAS_DECODER, reason="needs node and three")

DECODE = """
import { pathToFileURL } from "node:url";
const [decoder, count, stride, mode, packed] = process.argv.slice(1);
const { MeshoptDecoder } = await import(pathToFileURL(decoder).href);
await MeshoptDecoder.ready;
const out = new Uint8Array(count * stride);
MeshoptDecoder.decodeGltfBuffer(out, +count, +stride, Buffer.from(packed, "hex"), mode, "NONE");
console.log(JSON.stringify(Array.from(out)));
"""


def decoded(packed: bytes, count: int, stride: int, mode: str) -> np.ndarray:
    decoder = NODE / "three/examples/jsm/libs/meshopt_decoder.module.js"
    command = ["node", "--input-type=module", "-e", DECODE, decoder, str(count), str(stride), mode, packed.hex()]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    return np.array(json.loads(done.stdout), np.uint8)


@pytest.mark.parametrize(("count", "stride"), [(1, 4), (17, 8), (300, 12), (1030, 64)])
def test_attributes_come_back(count: int, stride: int) -> None:
    rng = np.random.default_rng(count)
    values = (
        (rng.normal(size=(count, stride)) * rng.choice([0, 1, 3, 60], size=(1, stride))).astype(int).astype(np.uint8)
    )
    found = decoded(meshopt.attributes(values), count, stride, "ATTRIBUTES")
    np.testing.assert_array_equal(found.reshape(count, stride), values)


def test_what_hardly_changes_is_hardly_stored() -> None:
    values = np.repeat(np.arange(100, dtype=np.uint8), 40)[:, None].repeat(4, axis=1)
    assert len(meshopt.attributes(values)) < 0.2 * values.size


def test_index_sequences_come_back_and_take_a_byte_where_they_climb() -> None:
    values = np.concatenate([np.arange(0, 9000, 7), np.arange(3, 60000, 31)]).astype(np.uint32)
    packed = meshopt.sequence(values)
    np.testing.assert_array_equal(decoded(packed, len(values), 4, "INDICES").view(np.uint32), values)
    assert len(packed) < 1.02 * len(values)


@pytest.mark.parametrize("kind", ["grid", "random"])
def test_triangles_come_back_in_their_order_and_facing_as_before(kind: str) -> None:
    if kind == "grid":
        corner = (np.arange(29)[:, None] * 30 + np.arange(29)).reshape(-1)
        values = np.concatenate([np.stack([corner, corner + 1, corner + 30], 1),
                                 np.stack([corner + 1, corner + 31, corner + 30], 1)])  # fmt: skip
    else:
        values = np.random.default_rng(5).integers(0, 400, (500, 3))
    for ordered in (values, meshopt.order_by_adjacency(values)):
        found = decoded(meshopt.triangles(ordered), ordered.size, 4, "TRIANGLES").view(np.uint32).reshape(-1, 3)
        turned = [np.roll(ordered, -k, axis=1) for k in range(3)]
        assert np.any([(found == one).all(axis=1) for one in turned], axis=0).all()
    assert sorted(map(tuple, meshopt.order_by_adjacency(values).tolist())) == sorted(map(tuple, values.tolist()))


def test_index_sequences_keep_their_largest_steps() -> None:
    """By hand: steps doubled with the sign in the lowest bit, doubled again for the baseline, written by sevens."""
    assert meshopt.sequence(np.array([3, 1, 20_000])) == bytes([0xD1, 12, 6, 0xFC, 0xF0, 0x04]) + bytes(4)
