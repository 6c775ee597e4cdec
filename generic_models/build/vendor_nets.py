"""Rebuild ``cloner_models/nets`` from Google's published npm packages.

Fetch the packages with the ordinary client and unpack them side by side::

    npm pack @mediapipe/pose@0.5.1675469404            (and the three others)
    mkdir NAME && tar -xzf NAME.tgz -C NAME            (gives NAME/package)
    python generic_models/build/vendor_nets.py FOLDER

FOLDER holds ``mediapipe-<name>-<version>/package``. Every output is named, with its
package, version, sha256 and licence, in ``nets/PROVENANCE.json``.
``face_landmark_with_attention.tflite`` needs custom operators that ai-edge-litert 2.3
does not have (measured), so it is cut into the part before and the part after them;
``cloner/detectors/nets/face_regions.py`` does what lay between.
"""

from __future__ import annotations

import argparse
import hashlib
import io
import json
import re
import struct
import zipfile
from collections.abc import Iterator
from pathlib import Path

import flatbuffers
import numpy as np
from ai_edge_litert import schema_py_generated as schema

NETS = Path(__file__).resolve().parents[1] / "cloner_models" / "nets"
VERSIONS = {
    "pose": "0.5.1675469404",
    "face_detection": "0.4.1657300184",
    "face_mesh": "0.4.1657299874",
    "selfie_segmentation": "0.1.1675465747",
}
# (npm package, file in it or in its packed assets)
WANTED = (
    ("pose", "pose_detection.tflite"),
    ("pose", "pose_landmark_heavy.tflite"),
    ("face_detection", "face_detection_short_range.tflite"),
    ("face_detection", "face_detection_full_range.tflite"),
    ("face_mesh", "face_landmark.tflite"),
    ("selfie_segmentation", "selfie_segmentation.tflite"),
)
ATTENTION = "face_landmark_with_attention.tflite"
# tensors of the attention net: image; mesh, features, face flag; three sampled grids; lips, then eye and iris twice
WHOLE = ((0,), (719, 35, 710))
PARTS = ((199, 200, 201), (697, 700, 703, 704, 707))
CUTS = {"face_attention_mesh.tflite": WHOLE, "face_attention_regions.tflite": PARTS}
# operators Landmarks2TransformMatrix, whose options hold each region's mesh points, and how many those are
REGIONS = {"lips": (192, 80), "eye_right": (193, 71), "eye_left": (194, 71)}
GEOMETRY = "geometry_pipeline_metadata_landmarks.binarypb"


def packed_files(package: Path) -> dict[str, bytes]:
    """Cut the packed assets of one npm package by the offsets in its loader script."""
    found: dict[str, bytes] = {}
    for loader in package.glob("*_packed_assets_loader.js"):
        data = (package / loader.name.replace("_loader.js", ".data")).read_bytes()
        rows = re.findall(r'"filename": "([^"]+)", "start": (\d+), "end": (\d+)', loader.read_text())
        for name, start, end in rows:
            found[name.rsplit("/", 1)[-1]] = data[int(start) : int(end)]
    return found


def read_asset(package: Path, name: str) -> bytes:
    """Return one asset of an unpacked npm package, loose or packed."""
    loose = package / name
    return loose.read_bytes() if loose.exists() else packed_files(package)[name]


def varint(data: bytes, at: int) -> tuple[int, int]:
    """Read one protobuf varint; return its value and the place after it."""
    value = shift = 0
    while True:
        byte = data[at]
        value |= (byte & 127) << shift
        at, shift = at + 1, shift + 7
        if byte < 128:
            return value, at


def fields(data: bytes) -> Iterator[tuple[int, int | bytes]]:
    """Yield (field number, raw value) of one protobuf message."""
    at = 0
    while at < len(data):
        key, at = varint(data, at)
        wire = key & 7
        if wire == 0:
            number, at = varint(data, at)
            yield key >> 3, number
            continue
        size, at = (8, at) if wire == 1 else (4, at) if wire == 5 else varint(data, at)
        yield key >> 3, data[at : at + size]
        at += size


def canonical_face(message: bytes) -> dict[str, np.ndarray]:
    """Read the face mesh out of a GeometryPipelineMetadata message.

    Returns ``vertices_cm`` (468, 3) float32 (x to the person's left, y up, z to the
    front, the net's own metric space), ``uv`` (468, 2) float32, ``faces`` (898, 3) int32.
    """
    for _, mesh in fields(message):
        if not isinstance(mesh, bytes):
            continue
        buffers: dict[int, list[bytes]] = {3: [], 4: []}
        numbers: list[int] = []
        for number, value in fields(mesh):
            if number in buffers and isinstance(value, bytes):
                buffers[number].append(value)
            elif number == 4 and isinstance(value, int):
                numbers.append(value)
        floats = b"".join(buffers[3])
        if len(floats) != 468 * 5 * 4:
            continue
        packed = b"".join(buffers[4])
        at = 0
        while at < len(packed):
            value, at = varint(packed, at)
            numbers.append(value)
        table = np.array(struct.unpack(f"<{len(floats) // 4}f", floats), np.float32)
        table = table.reshape(468, 5)
        faces = np.array(numbers, np.int32).reshape(-1, 3)
        return {"vertices_cm": table[:, :3], "uv": table[:, 3:], "faces": faces}
    raise ValueError("no mesh of 468 vertices in the geometry metadata")


def write_npz(path: Path, arrays: dict[str, np.ndarray]) -> None:
    """Write an npz whose bytes do not depend on the clock."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, array in arrays.items():
            buffer = io.BytesIO()
            np.save(buffer, np.ascontiguousarray(array))
            entry = zipfile.ZipInfo(f"{name}.npy", (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, buffer.getvalue())


def cut_net(model: bytes, inputs: tuple[int, ...], outputs: tuple[int, ...]) -> bytes:
    """Return the net that leads from some tensors of another to some others."""
    net = schema.ModelT.InitFromPackedBuf(model, 0)
    graph = net.subgraphs[0]
    maker = {int(t): n for n, operator in enumerate(graph.operators) for t in operator.outputs}
    kept: set[int] = set()
    used, left = {*inputs, *outputs}, list(outputs)
    while left:
        tensor = left.pop()
        if tensor in inputs or tensor not in maker or maker[tensor] in kept:
            continue
        operator = graph.operators[maker[tensor]]
        kept.add(maker[tensor])
        used |= {int(t) for t in (*operator.inputs, *operator.outputs) if t >= 0}
        left += [int(t) for t in operator.inputs if t >= 0]
    row = {tensor: k for k, tensor in enumerate(sorted(used))}
    graph.operators = [graph.operators[k] for k in sorted(kept)]
    graph.tensors = [graph.tensors[k] for k in sorted(used)]
    codes = sorted({operator.opcodeIndex for operator in graph.operators})
    for operator in graph.operators:
        operator.inputs = [row[int(t)] if t >= 0 else -1 for t in operator.inputs]
        operator.outputs = [row[int(t)] for t in operator.outputs]
        operator.opcodeIndex = codes.index(operator.opcodeIndex)
    net.operatorCodes = [net.operatorCodes[k] for k in codes]
    graph.inputs, graph.outputs = [row[t] for t in inputs], [row[t] for t in outputs]
    buffers = [schema.BufferT()]
    for tensor in graph.tensors:
        data = net.buffers[tensor.buffer]
        tensor.buffer = 0 if data.data is None else len(buffers)
        buffers += [] if data.data is None else [data]
    net.buffers, net.metadata, net.metadataBuffer, net.signatureDefs = buffers, None, None, None
    builder = flatbuffers.Builder(len(model))
    builder.Finish(net.Pack(builder), b"TFL3")
    return bytes(builder.Output())


def region_points(model: bytes, operator: int, count: int) -> np.ndarray:
    """Return the mesh points (count,) of one region, out of the options of its operator."""
    options = bytes(schema.ModelT.InitFromPackedBuf(model, 0).subgraphs[0].operators[operator].customOptions)
    at = options.index(b"subset_idxs\0") + len(b"subset_idxs\0")
    while struct.unpack_from("<H", options, at)[0] != count:  # the vector is aligned and begins with its length
        at += 1
    return np.frombuffer(options, "<u2", count, at + 2).astype(np.int32)


def build(source: Path) -> None:
    """Write all nets, the canonical face and their provenance."""
    NETS.mkdir(parents=True, exist_ok=True)
    packages = {k: source / f"mediapipe-{k}-{v}" / "package" for k, v in VERSIONS.items()}
    rows = []
    for package, name in WANTED:
        (NETS / name).write_bytes(read_asset(packages[package], name))
        rows.append((package, name, name))
    face = canonical_face(read_asset(packages["face_mesh"], GEOMETRY))
    write_npz(NETS / "canonical_face.npz", face)
    rows.append(("face_mesh", "canonical_face.npz", GEOMETRY))
    attention = read_asset(packages["face_mesh"], ATTENTION)
    for name, (inputs, outputs) in CUTS.items():
        (NETS / name).write_bytes(cut_net(attention, inputs, outputs))
    write_npz(NETS / "face_regions.npz", {name: region_points(attention, *at) for name, at in REGIONS.items()})
    rows += [("face_mesh", name, ATTENTION) for name in (*CUTS, "face_regions.npz")]
    table = [
        {
            "file": name,
            "source": asset,
            "package": f"@mediapipe/{package}",
            "version": VERSIONS[package],
            "sha256": hashlib.sha256((NETS / name).read_bytes()).hexdigest(),
            "licence": "Apache-2.0",
        }
        for package, name, asset in rows
    ]
    (NETS / "PROVENANCE.json").write_text(json.dumps(table, indent=1) + "\n")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=Path, help="folder with the unpacked npm packages")
    build(parser.parse_args().source)
