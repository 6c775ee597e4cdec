"""Contents of H-Anim segments as VRML97 text: pieces of skin, sites and displacers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.exporters.hanim.hanim_names import identifier, segment_name
from cloner.exporters.hanim.hanim_sites import placed_sites
from cloner.exporters.hanim.partition import Piece, partition
from cloner.generic.load import GenericHuman
from cloner.generic.morphs import target_offsets
from cloner.generic.surfaces import load_surfaces, surface_normals
from cloner.geometry.meshes.wedges import welded_normals
from cloner.records.arrays import Array
from cloner.records.clones import Clone

Targets = list[tuple[str, NDArray[np.int32], Array]]

#: Smaller offsets of a displacer are left out, metres; taste: keeps the text readable by old programs.
SMALLEST_OFFSET_M: Final = 1e-4
#: Rings of triangles that a piece repeats of the ones above. With two, shoulders grow flaps when the arms are lowered;
#: knees, elbows and ankles bend so far that they gape with fewer than three.
OVERLAP_RINGS: Final = 1
HINGE_RINGS: Final = 3
HINGES: Final = ("l_knee", "r_knee", "l_elbow", "r_elbow", "l_ankle", "r_ankle")


@dataclass(frozen=True, slots=True, eq=False)
class SkinMesh:
    """One textured mesh before it is cut: a surface of the body or a hair shell.

    Attributes
    ----------
    name, picture : str
        Name of its appearance, and of its texture file.
    two_sided : bool
    vertices_m, normals, uv, triangles, skin_joints, skin_weights
        As in :class:`cloner.records.heads.Shell`.
    vertex : (N,) int32
        The generic human's vertex of every vertex, -1 on shells.
    """

    name: str
    picture: str
    two_sided: bool
    vertices_m: Array
    normals: Array
    uv: Array
    triangles: NDArray[np.int32]
    skin_joints: NDArray[np.integer]
    skin_weights: NDArray[np.floating]
    vertex: NDArray[np.int32]


def skin_meshes(clone: Clone, generic: GenericHuman, name: str) -> tuple[SkinMesh, ...]:
    """Return everything of a clone that is drawn, in rest pose."""
    normals = surface_normals(clone.vertices_m)
    meshes = []
    for surface in load_surfaces():
        own, atlas = surface.vertex, surface.rgba is None
        meshes.append(
            SkinMesh(
                "atlas" if atlas else surface.name,
                f"{name}_atlas.jpg" if atlas else f"{name}_{surface.name}.png",
                not atlas,
                clone.vertices_m[own],
                normals[own],
                surface.uv,
                surface.triangles,
                generic.skin_joints[own],
                generic.skin_weights[own],
                own,
            )
        )
    for number, shell in enumerate(clone.shells):
        meshes.append(
            SkinMesh(
                f"{shell.kind}_{number}",
                f"{name}_{shell.kind}_{number}.png",
                True,
                shell.vertices_m,
                welded_normals(shell.vertices_m, shell.triangles),
                shell.uv,
                shell.triangles,
                shell.skin_joints,
                shell.skin_weights,
                shell.rides if len(shell.rides) else np.full(len(shell.vertices_m), -1, dtype=np.int32),
            )
        )
    return tuple(meshes)


def segment_texts(clone: Clone, generic: GenericHuman, name: str) -> list[str]:
    """Return the text of every joint's Segment node, in the order of the joints.

    One Coordinate, Normal and TextureCoordinate node a segment is shared by its
    shapes, so that displacers can move body, lashes and teeth together.
    """
    held: list[list[tuple[SkinMesh, Piece]]] = [[] for _ in generic.joint_names]
    rings = np.array([HINGE_RINGS if joint in HINGES else OVERLAP_RINGS for joint in generic.joint_names])
    for mesh in skin_meshes(clone, generic, name):
        parents = generic.joint_parents
        for piece in partition(mesh.triangles, mesh.skin_joints, mesh.skin_weights, parents, overlap=rings):
            held[piece.joint].append((mesh, piece))
    sites = site_texts(clone, generic, "Site")
    seen: set[str] = set()
    targets = _moving(clone)
    return [
        "".join(_segment(targets, segment_name(joint), held[row], sites[row], seen))
        for row, joint in enumerate(generic.joint_names)
    ]


def quoted(text: str) -> str:
    """Return a string as VRML writes it; the texts here hold no quotes."""
    return f'"{text}"'


def row_text(values: Array) -> str:
    """Return lengths to a hundredth of a millimetre."""
    return " ".join(f"{value:.5f}" for value in values)


def _segment(
    targets: Targets, name: str, pieces: list[tuple[SkinMesh, Piece]], sites: list[str], seen: set[str]
) -> Iterator[str]:
    """Yield one Segment node; ``seen`` holds the appearances that earlier segments defined."""
    yield f'DEF hanim_{name} Segment {{ name "{name}"\n'
    if pieces:
        points = np.concatenate([mesh.vertices_m[piece.vertex] for mesh, piece in pieces])
        yield f"coord DEF {name}_coord Coordinate {{ point [\n{number_rows(points)}] }}\n"
    if pieces or sites:
        yield "children [\n"
        start = 0
        for number, (mesh, piece) in enumerate(pieces):
            yield f"Shape {{ {appearance_text(mesh, seen)}\ngeometry IndexedFaceSet {{ coord USE {name}_coord\n"
            yield _shared(name, pieces) if number == 0 else f"normal USE {name}_normal texCoord USE {name}_uv\n"
            solid = "FALSE" if mesh.two_sided else "TRUE"
            yield f"solid {solid} coordIndex [\n{face_rows(piece.triangles + start)}] }} }}\n"
            start += len(piece.vertex)
        yield from sites
        yield "]\n"
    if pieces:
        vertex = np.concatenate([mesh.vertex[piece.vertex] for mesh, piece in pieces])
        displacers = "".join(_displacers(targets, name, vertex))
        yield f"displacers [\n{displacers}]\n" if displacers else ""
    yield "}\n"


def _shared(name: str, pieces: list[tuple[SkinMesh, Piece]]) -> str:
    """Return the normals and texture coordinates of all pieces; VRML counts t upwards."""
    normals = np.concatenate([mesh.normals[piece.vertex] for mesh, piece in pieces])
    uv = np.concatenate([mesh.uv[piece.vertex] for mesh, piece in pieces]) * [1.0, -1.0] + [0.0, 1.0]
    return (
        f"normal DEF {name}_normal Normal {{ vector [\n{number_rows(normals)}] }}\n"
        f"texCoord DEF {name}_uv TextureCoordinate {{ point [\n{number_rows(uv)}] }}\n"
    )


def appearance_text(mesh: SkinMesh, seen: set[str]) -> str:
    """Return the appearance of a mesh, defined the first time and used afterwards."""
    if mesh.name in seen:
        return f"appearance USE look_{mesh.name}"
    seen.add(mesh.name)
    return (
        f"appearance DEF look_{mesh.name} Appearance {{ material Material {{ diffuseColor 1 1 1 "
        f"ambientIntensity 0.5 specularColor 0.03 0.03 0.03 shininess 0.1 }}\n"
        f'texture ImageTexture {{ url "textures/{mesh.picture}" }} }}'
    )


def _moving(clone: Clone) -> Targets:
    """Return every target's name, (V + 1,) row of each vertex among those it moves, -1 elsewhere, and its offsets."""
    found = []
    for target, offsets in target_offsets(clone):
        moved = np.flatnonzero(np.abs(offsets).max(axis=1) > SMALLEST_OFFSET_M)
        row = np.full(len(offsets), -1, dtype=np.int32)
        row[moved] = np.arange(len(moved))
        found.append((target, row, offsets[moved].astype(np.float64)))
    return found


def _displacers(targets: Targets, name: str, vertex: NDArray[np.int32]) -> Iterator[str]:
    """Yield one Displacer for every morph target that moves this segment."""
    for target, row, offsets in targets:
        own = row[vertex]
        moved = np.flatnonzero(own >= 0)
        if len(moved):
            index = " ".join(map(str, moved.tolist()))
            yield (
                f'DEF hanim_{name}_{identifier(target)} Displacer {{ name "{target}" coordIndex [ {index} ]\n'
                f"displacements [\n{number_rows(offsets[own[moved]])}] }}\n"
            )


def site_texts(clone: Clone, generic: GenericHuman, node: str) -> list[list[str]]:
    """Return the sites of every joint, "Site" or "Transform" nodes."""
    texts: list[list[str]] = [[] for _ in generic.joint_names]
    for site, joint, point in placed_sites(clone):
        own = f'name "{site}" ' if node == "Site" else ""
        texts[joint].append(f"DEF hanim_{site} {node} {{ {own}translation {row_text(point)} }}\n")
    return texts


def number_rows(values: Array) -> str:
    """Return one line a row, to a hundredth of a millimetre."""
    line = " ".join(["%.5f"] * values.shape[1]) + "\n"
    return (line * len(values)) % tuple(values.ravel().tolist())  # a tenth of the time of a loop over rows


def face_rows(triangles: NDArray[np.int32]) -> str:
    """Return one line a triangle, as VRML ends them."""
    return ("%d %d %d -1\n" * len(triangles)) % tuple(triangles.ravel().tolist())
