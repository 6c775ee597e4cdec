"""OBJ and PLY of a clone at rest: no skeleton, no morph targets."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.exporters.shared.files import jpeg_bytes, png_bytes, write_bytes
from cloner.generic.surfaces import load_surfaces, surface_normals
from cloner.geometry.charts.atlas import colours_at
from cloner.geometry.meshes.wedges import welded_normals
from cloner.records.clones import Clone

#: Rows of a binary PLY file.
_PLY_VERTEX: Final = np.dtype([("place", "<f4", 3), ("normal", "<f4", 3), ("colour", "u1", 4)])
_PLY_FACE: Final = np.dtype([("count", "u1"), ("corners", "<i4", 3)])
_PLY_HEAD: Final = """\
ply
format binary_little_endian 1.0
comment {stamp}
element vertex {vertices}
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property uchar alpha
element face {faces}
property list uchar int vertex_indices
end_header
"""


def export_obj(clone: Clone, folder: Path, *, name: str = "clone") -> tuple[Path, ...]:
    """Write ``<name>.obj``, its ``.mtl`` and the pictures in ``textures/``, and return all paths.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    lines, looks = [f"# {clone.stamp}\nmtllib {name}.mtl\n"], {"atlas": f"textures/{name}_atlas.jpg"}
    files = {looks["atlas"]: jpeg_bytes(clone.atlas.rgb)}
    start = 1  # OBJ counts from one
    for look, points, normals, uv, triangles, rgba in _meshes(clone):
        if rgba is not None:
            looks[look] = f"textures/{name}_{look}.png"
            files[looks[look]] = png_bytes(rgba)
        upwards = uv * [1.0, -1.0] + [0.0, 1.0]  # OBJ counts v upwards
        lines += [_rows("v %.6f %.6f %.6f\n", points), _rows("vt %.6f %.6f\n", upwards)]
        lines += [_rows("vn %.4f %.4f %.4f\n", normals), f"usemtl {look}\n"]
        lines.append(_rows("f %d/%d/%d %d/%d/%d %d/%d/%d\n", np.repeat(triangles + start, 3, axis=1)))
        start += len(points)
    materials = "".join(_material(look, picture) for look, picture in looks.items())
    files |= {f"{name}.mtl": materials.encode(), f"{name}.obj": "".join(lines).encode()}
    for relative, data in files.items():
        write_bytes(folder / relative, data)
    return (folder / f"{name}.obj", *(folder / relative for relative in files if not relative.endswith(".obj")))


def _rows(line: str, values: NDArray[Any]) -> str:
    """Return one line a row; a third of the time of a loop."""
    return (line * len(values)) % tuple(values.ravel().tolist())


def export_ply(clone: Clone, folder: Path, *, name: str = "clone") -> tuple[Path, ...]:
    """Write ``<name>.ply`` with one colour a vertex, taken from the textures, and return its path.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    vertices, faces, start = [], [], 0
    for _, points, normals, uv, triangles, rgba in _meshes(clone):
        own = np.zeros(len(points), _PLY_VERTEX)
        own["place"], own["normal"] = points, normals
        own["colour"] = _sample(clone.atlas.rgb if rgba is None else rgba, uv)
        vertices.append(own)
        corners = np.full(len(triangles), 3, _PLY_FACE)
        corners["corners"] = triangles + start
        faces.append(corners)
        start += len(points)
    path = folder / f"{name}.ply"
    head = _PLY_HEAD.format(stamp=clone.stamp, vertices=start, faces=sum(map(len, faces)))
    write_bytes(path, b"".join([head.encode(), *(part.tobytes() for part in (*vertices, *faces))]))
    return (path,)


_Mesh = tuple[
    str, NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.int32], NDArray[np.uint8] | None
]


def _meshes(clone: Clone) -> list[_Mesh]:
    """Return look, points, normals, uv, triangles and own texture of every drawn mesh."""
    normals = surface_normals(clone.vertices_m)
    meshes: list[_Mesh] = []
    for surface in load_surfaces():
        own, look = surface.vertex, "atlas" if surface.rgba is None else surface.name
        meshes.append((look, clone.vertices_m[own], normals[own], surface.uv, surface.triangles, surface.rgba))
    for number, shell in enumerate(clone.shells):
        smooth = welded_normals(shell.vertices_m, shell.triangles)
        meshes.append((f"{shell.kind}_{number}", shell.vertices_m, smooth, shell.uv, shell.triangles, shell.rgba))
    return meshes


def _sample(texture: NDArray[np.uint8], uv: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return the (N, 4) nearest texels, opaque where the texture has no alpha."""
    found = colours_at(texture, uv)
    return found if found.shape[1] == 4 else np.column_stack([found, np.full(len(found), 255, np.uint8)])


def _material(look: str, picture: str) -> str:
    """Return one material of an MTL file."""
    alpha = f"map_d {picture}\n" if picture.endswith(".png") else ""
    return f"newmtl {look}\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd {picture}\n{alpha}\n"
