"""OBJ meshes of others: read with texture coordinates, unwrapped where they have none, written with a texture."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.exporters.shared.files import png_bytes, write_bytes
from cloner.records.arrays import Array
from cloner.records.meshes import Mesh
from cloner.untrusted import read_untrusted_text

#: A larger file is no mesh to drag markers on.
LARGEST_BYTES: Final = 80_000_000
MOST_TRIANGLES: Final = 500_000
#: A wrapped texture goes on so far beyond a full turn, for triangles across the seam behind.
OVERLAP: Final = 0.1
_HINT: Final = "Save the mesh as plain OBJ with triangles or polygons"


def read_obj(path: Path) -> Mesh:
    """Return the mesh of an OBJ file; polygons are cut into fans, and one without texture coordinates is wrapped.

    Raises
    ------
    ClonerError
        If it cannot be read, or holds no surface that can be drawn.
    """
    places: list[list[float]] = []
    uv: list[list[float]] = []
    corners: list[tuple[int, int]] = []
    for row in read_untrusted_text(path, "the mesh", _HINT, LARGEST_BYTES, errors="replace").splitlines():
        word, _, rest = row.strip().partition(" ")
        try:
            if word == "v":
                places.append([float(each) for each in rest.split()[:3]])
            elif word == "vt":
                uv.append([float(each) for each in rest.split()[:2]])
            elif word == "f":
                face = [_corner(each, len(places), len(uv)) for each in rest.split()]
                for k in range(1, len(face) - 1):
                    corners += [face[0], face[k], face[k + 1]]
        except ValueError as error:
            raise ClonerError("the mesh holds a line that is none of OBJ's", _HINT, path.name) from error
        if len(corners) > 3 * MOST_TRIANGLES:
            raise ClonerError(f"the mesh has more than {MOST_TRIANGLES} triangles", "Simplify it", path.name)
    if not corners or any(len(each) != 3 for each in places) or any(len(each) != 2 for each in uv):
        raise ClonerError("the mesh holds no surface", _HINT, path.name)
    vertices, both = np.array(places, np.float64), np.array(corners, np.int64).reshape(-1, 3, 2)
    if not (np.isfinite(vertices).all() and np.isfinite(np.array(uv, np.float64)).all()):
        raise ClonerError("the mesh has places that are no numbers", _HINT, path.name)
    if both[..., 0].min() < 0 or both[..., 0].max() >= len(vertices) or both[..., 1].max() >= max(len(uv), 1):
        raise ClonerError("a triangle of the mesh has a corner that is not there", _HINT, path.name)
    if float(np.ptp(vertices, axis=0).min()) <= 0.0:
        raise ClonerError("the mesh is flat", "Give a solid one", path.name)
    triangles = both[..., 0].astype(np.int32)
    if not uv or both[..., 1].min() < 0:
        return Mesh(vertices, triangles, *wrapped(vertices, triangles))
    flat = np.array(uv, np.float64)
    flat[:, 1] = 1.0 - flat[:, 1]  # OBJ counts v upwards
    return Mesh(vertices, triangles, np.clip(flat, 0.0, 1.0), both[..., 1].astype(np.int32))


def _corner(text: str, places: int, uv: int) -> tuple[int, int]:
    """Return the rows of a corner's vertex and texture coordinate, -1 for none; negative numbers count from the end."""
    parts = text.split("/")
    vertex, flat = int(parts[0]), int(parts[1]) if len(parts) > 1 and parts[1] else 0
    if max(abs(vertex), abs(flat)) > LARGEST_BYTES:
        raise ValueError("no file has so many lines")
    return (vertex - 1 if vertex > 0 else places + vertex), (flat - 1 if flat >= 0 else uv + flat)


def wrapped(vertices_m: Array, triangles: NDArray[np.int32]) -> tuple[Array, NDArray[np.int32]]:
    """Return texture coordinates (U, 2) and triangles (T, 3) of a picture wrapped round, its seam behind (-Z)."""
    low, high = vertices_m.min(axis=0), vertices_m.max(axis=0)
    off = vertices_m - (low + high) / 2.0
    turn = np.arctan2(off[:, 0], off[:, 2]) / (2.0 * np.pi) + 0.5
    height = (high[1] - vertices_m[:, 1]) / (high[1] - low[1])
    across = np.ptp(turn[triangles], axis=1) > 0.5
    flat = triangles + np.where(across[:, None] & (turn[triangles] < 0.5), len(turn), 0)
    both = np.concatenate([turn, turn + 1.0])
    return np.stack([np.minimum(both / (1.0 + OVERLAP), 1.0), np.tile(height, 2)], axis=1), flat.astype(np.int32)


def write_obj(mesh: Mesh, vertices_m: Array, rgb: NDArray[np.uint8], folder: Path, name: str, note: str) -> None:
    """Write ``<name>.obj``, ``.mtl`` and ``.png`` of a mesh moved to (V, 3), with a texture (S, S, 3).

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    rows = [f"# {note}\nmtllib {name}.mtl\nusemtl {name}\n"]
    rows += [("v %.6f %.6f %.6f\n" * len(vertices_m)) % tuple(vertices_m.ravel().tolist())]
    upwards = mesh.uv * [1.0, -1.0] + [0.0, 1.0]
    rows += [("vt %.6f %.6f\n" * len(upwards)) % tuple(upwards.ravel().tolist())]
    both = np.stack([mesh.triangles, mesh.uv_triangles], axis=2) + 1
    rows += [("f %d/%d %d/%d %d/%d\n" * len(both)) % tuple(both.ravel().tolist())]
    write_bytes(folder / f"{name}.png", png_bytes(rgb))
    write_bytes(folder / f"{name}.mtl", f"newmtl {name}\nKd 1 1 1\nmap_Kd {name}.png\n".encode())
    write_bytes(folder / f"{name}.obj", "".join(rows).encode())
