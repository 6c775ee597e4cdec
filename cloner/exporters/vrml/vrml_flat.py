"""VRML97 without prototypes: one static figure for simple loaders.

Seamless, at rest; who wants joints and a walk takes ``wrl`` or ``x3d``. Metres, +Y up, facing +Z.

References
----------
ISO/IEC 14772-1:1997 (VRML97), 6.23 (IndexedFaceSet).
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from cloner import __version__
from cloner.exporters.shared.credits import GENERIC_CREDITS
from cloner.exporters.shared.files import write_bytes
from cloner.exporters.shared.pictures import write_pictures
from cloner.exporters.vrml.vrml_segments import appearance_text, face_rows, number_rows, quoted, skin_meshes
from cloner.exporters.vrml.vrml_views import viewpoints
from cloner.generic.load import load_generic
from cloner.records.clones import Clone


def export(clone: Clone, folder: Path, *, name: str = "clone") -> tuple[Path, ...]:
    """Write ``<name>_flat.wrl`` and its pictures in ``textures/``, and return all paths.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    pictures = write_pictures(clone, folder, name)
    scene = folder / f"{name}_flat.wrl"
    write_bytes(scene, "".join(_scene(clone, name)).encode())
    return (scene, *pictures)


def _scene(clone: Clone, name: str) -> Iterator[str]:
    yield f"#VRML V2.0 utf8\n# Written by Cloner {__version__}. {GENERIC_CREDITS}.\n"
    info = (GENERIC_CREDITS, "units=metre up=+Y front=+Z", f"stamp={clone.stamp}")
    yield f'WorldInfo {{ title "clone" info [ {" ".join(map(quoted, info))} ] }}\n'
    yield 'NavigationInfo { type [ "EXAMINE" "ANY" ] }\nBackground { skyColor 0.88 0.89 0.9 }\n'
    yield from viewpoints(clone)
    yield "Transform { children [\n"
    seen: set[str] = set()
    for mesh in skin_meshes(clone, load_generic(), name):
        uv = mesh.uv * [1.0, -1.0] + [0.0, 1.0]  # VRML counts t upwards
        yield f"Shape {{ {appearance_text(mesh, seen)}\ngeometry IndexedFaceSet {{\n"
        yield f"coord Coordinate {{ point [\n{number_rows(mesh.vertices_m)}] }}\n"
        yield f"normal Normal {{ vector [\n{number_rows(mesh.normals)}] }}\n"
        yield f"texCoord TextureCoordinate {{ point [\n{number_rows(uv)}] }}\n"
        yield f"solid {'FALSE' if mesh.two_sided else 'TRUE'} coordIndex [\n{face_rows(mesh.triangles)}] }} }}\n"
    yield "] }\n"
