"""Rebuild ``cloner_models/nets`` from Google's published npm packages.

Fetch the packages with the ordinary client and unpack them side by side::

    npm pack @mediapipe/pose@0.5.1675469404            (and the three others)
    mkdir NAME && tar -xzf NAME.tgz -C NAME            (gives NAME/package)
    python generic_models/build/vendor_nets.py FOLDER

FOLDER holds ``mediapipe-<name>-<version>/package``. Every output is named, with its
package, version, sha256 and licence, in ``nets/PROVENANCE.json``.
``face_landmark_with_attention.tflite`` is left out: it needs the custom operator
Landmarks2TransformMatrix, which ai-edge-litert 2.3 does not have (measured).
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

import numpy as np

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
