"""One clone at five levels of detail in one glTF.

The file is the clone's own glTF, seen whole by every viewer. Coarser levels are nodes beside its scene, "Body_LOD1",
"Hair_LOD1" to "Body_LOD4": lists of triangles over the very vertices, weights, texture coordinates and targets of the
whole clone, so they cost a few bytes a triangle, and bend and speak alike. In the scene viewers would draw all levels
on top of each other; scenes of their own would share the armature, which three.js leaves to just one of them; and few
readers know MSFT_lod.

References
----------
Khronos Group 2021, glTF 2.0 specification, section 3.5.1 (a node need not be in a scene).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner.crowd.clones.levels import LEVELS, LOOSE, shell_levels, surface_levels
from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf import build
from cloner.exporters.shared.files import write_bytes
from cloner.generic.surfaces import load_surfaces
from cloner.motion.limbs.rig import centre_joints
from cloner.records.clones import Clone
from cloner.records.heads import SHELL_KINDS, Shell

Index = NDArray[np.int32]

CARDS: Final = "frizz"
SKIN: Final = 0  # the only skin of the clone's glTF


def export(clone: Clone, folder: Path, *, name: str = "clone") -> tuple[Path, ...]:
    """Write ``<name>_lods.glb`` and return its path.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    clone = centre_joints(clone)
    path = folder / f"{name}_lods.glb"
    write_bytes(path, glb_bytes(with_levels(build(clone), clone)))
    return (path,)


def with_levels(gltf: Any, clone: Clone) -> Any:
    """Add the coarser levels to a clone's ``pygltflib.GLTF2``, in place, and return it."""
    lists = _lists(clone)
    blob = bytearray(gltf.binary_blob())
    meshes = list(gltf.meshes)
    for level in range(LEVELS):
        for mesh, own in zip(meshes, lists, strict=True):
            if not own:
                continue
            primitives = [
                pygltflib.Primitive(
                    attributes=mesh.primitives[row].attributes,
                    material=mesh.primitives[row].material,
                    targets=mesh.primitives[row].targets,
                    indices=_indices(gltf, blob, levels[level]),
                )
                for row, levels in own.items()
            ]
            coarse = pygltflib.Mesh(name=f"{mesh.name}_LOD{level + 1}", primitives=primitives)
            coarse.extras, coarse.weights = mesh.extras, mesh.weights
            gltf.meshes.append(coarse)
            gltf.nodes.append(pygltflib.Node(name=coarse.name, mesh=len(gltf.meshes) - 1, skin=SKIN))
    gltf.buffers[0].byteLength = len(blob)
    gltf.set_binary_blob(bytes(blob))
    return gltf


def _lists(clone: Clone) -> list[dict[int, tuple[Index, ...]]]:
    """Return for every mesh of a clone's glTF its primitives with levels, by row, and their triangles.

    Frizz has none: from afar it is less than a pixel, and its cards, which hang together nowhere, cannot be made fewer.
    """
    shipped = surface_levels()
    surfaces = load_surfaces()
    body = {row: shipped[one.name] for row, one in enumerate(surfaces) if one.name in shipped}
    riding = [shell for shell in clone.shells if len(shell.rides)]
    body |= {len(surfaces) + row: _levels(clone, shell) for row, shell in enumerate(riding)}
    loose = [(kind, [one for one in clone.shells if one.kind == kind and not len(one.rides)]) for kind in SHELL_KINDS]
    return [
        body,
        *(
            {row: _levels(clone, shell) for row, shell in enumerate(shells)} if kind != CARDS else {}
            for kind, shells in loose
            if shells
        ),
    ]


def _levels(clone: Clone, shell: Shell) -> tuple[Index, ...]:
    return shell_levels(shell.vertices_m, shell.triangles, _budgets(clone, shell))


def _budgets(clone: Clone, shell: Shell) -> tuple[int, ...]:
    """Return a shell's triangle budget per level: its share of all shells' except the frizz's."""
    whole = sum(len(one.triangles) for one in clone.shells if one.kind != CARDS)
    return tuple(max(round(budget * len(shell.triangles) / whole), 1) for budget in LOOSE)


def _indices(gltf: Any, blob: bytearray, triangles: Index) -> int:
    """Append the corners of triangles and return their accessor."""
    flat = triangles.reshape(-1)
    flat = flat.astype(np.uint16 if flat.max(initial=0) < 65535 else np.uint32)
    blob += b"\0" * (-len(blob) % 4)
    view = pygltflib.BufferView(
        buffer=0, byteOffset=len(blob), byteLength=flat.nbytes, target=pygltflib.ELEMENT_ARRAY_BUFFER
    )
    blob += flat.tobytes()
    gltf.bufferViews.append(view)
    kind = pygltflib.UNSIGNED_SHORT if flat.itemsize == 2 else pygltflib.UNSIGNED_INT
    gltf.accessors.append(
        pygltflib.Accessor(
            bufferView=len(gltf.bufferViews) - 1, componentType=kind, count=len(flat), type=pygltflib.SCALAR
        )
    )
    return len(gltf.accessors) - 1
