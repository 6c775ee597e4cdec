"""X3D 4 with HAnim: one seamless skin with displacers, a walk, and an idle on click.

Every vertex stands once in the Coordinate that ``skinCoord`` and all shapes of the skin share: some readers bend a skin
only when it is the very same node. Metres, +Y up, facing +Z.

References
----------
ISO/IEC 19775-1:2023 (X3D 4), clause 26; ISO/IEC 19774-1:2019 (H-Anim 2).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cloner import __version__
from cloner.exporters.hanim.hanim_limits import Limits, limits_of
from cloner.exporters.hanim.hanim_names import identifier, joint_name_2, segment_name
from cloner.exporters.hanim.hanim_sites import name_2, standard_sites
from cloner.exporters.shared.credits import GENERIC_CREDITS
from cloner.exporters.shared.files import write_bytes
from cloner.exporters.shared.pictures import write_pictures
from cloner.exporters.vrml.vrml_motion import STILL
from cloner.exporters.vrml.vrml_segments import SMALLEST_OFFSET_M, SkinMesh, row_text, skin_meshes
from cloner.exporters.vrml.vrml_views import FIELD_OF_VIEW, placed_views
from cloner.exporters.vrml.x3d_motion import TOUCH, motions_text
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.morphs import wedge_offsets
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import Moves, own_motions
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

#: One of the face's targets, the vertices (K,) that it moves and by how much (K, 3), metres.
Moved = tuple[str, NDArray[np.int64], NDArray[np.float32]]


def export(clone: Clone, folder: Path, *, name: str = "clone", moves: Moves = own_motions) -> tuple[Path, ...]:
    """Write ``<name>.x3d`` and its pictures in ``textures/``, and return all paths.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    clone = centre_joints(clone)
    pictures = write_pictures(clone, folder, name)
    scene = folder / f"{name}.x3d"
    write_bytes(scene, "".join(_document(clone, name, moves(clone))).encode())
    return (scene, *pictures)


def _document(clone: Clone, name: str, motions: Sequence[Motion]) -> Iterator[str]:
    generic = load_generic()
    meshes = skin_meshes(clone, generic, name)
    joints = tuple(joint_name_2(joint) for joint in generic.joint_names)
    yield '<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 4.0//EN" "x3d-4.0.dtd">\n'
    yield '<X3D profile="Immersive" version="4.0">\n<head>\n<component name="HAnim" level="1"/>\n'
    yield f'<meta name="generator" content="Cloner {__version__}"/>\n'
    yield f'<meta name="license" content="{GENERIC_CREDITS}"/>\n'
    yield f'<meta name="stamp" content="{clone.stamp}"/>\n'
    yield '</head>\n<Scene>\n<Background skyColor="0.88 0.89 0.9"/>\n'
    yield '<NavigationInfo type="&quot;EXAMINE&quot; &quot;ANY&quot;"/>\n'
    yield from _viewpoints(clone)
    yield f'<Group>\n<TouchSensor DEF="{TOUCH}"/>\n'
    yield (
        '<HAnimHumanoid DEF="humanoid" name="humanoid" version="2.0" loa="3" skeletalConfiguration="BASIC" '
        f'info="&quot;authorName=Cloner {__version__}&quot; &quot;height={clone.stature_m:.4f}&quot;">\n'
    )
    yield f'<Coordinate DEF="skin_coord" containerField="skinCoord" point="{_rows([m.vertices_m for m in meshes])}"/>\n'
    yield f'<Normal DEF="skin_normal" containerField="skinNormal" vector="{_rows([m.normals for m in meshes])}"/>\n'
    root = int(np.flatnonzero(generic.joint_parents < 0)[0])
    moved = tuple(_moved(clone, meshes))
    yield from _joint(clone, generic, root, meshes, joints, limits_of(clone), moved)
    start = 0
    for number, mesh in enumerate(meshes):
        yield from _shape(mesh, start, meshes if number == 0 else ())
        start += len(mesh.vertices_m)
    yield from (f'<HAnimJoint USE="hanim_{joint}" containerField="joints"/>\n' for joint in joints)
    yield from (f'<HAnimSegment USE="hanim_{segment_name(joint)}" containerField="segments"/>\n'
                for joint in generic.joint_names)  # fmt: skip
    yield from (f'<HAnimSite USE="hanim_{name_2(site.name)}" containerField="sites"/>\n' for site in standard_sites())
    yield "</HAnimHumanoid>\n</Group>\n"
    yield from motions_text(motions, joints, [target for target, _, _ in moved])
    yield "</Scene>\n</X3D>\n"


def _viewpoints(clone: Clone) -> Iterator[str]:
    """Yield one viewpoint a named side, the front first."""
    for view in placed_views(clone):
        yield (
            f'<Viewpoint description="{view.side}" position="{row_text(view.place_m)}" '
            f'orientation="0 1 0 {view.angle_rad:.5f}" centerOfRotation="{row_text(view.middle_m)}" '
            f'fieldOfView="{FIELD_OF_VIEW}"/>\n'
        )


def _joint(
    clone: Clone,
    generic: GenericHuman,
    joint: int,
    meshes: tuple[SkinMesh, ...],
    names: tuple[str, ...],
    limits: Mapping[str, Limits],
    moved: Sequence[Moved],
) -> Iterator[str]:
    """Yield a joint with its share of the skin, its segment and sites, its displacers and every joint below it."""
    index, weight = _skin_of(joint, meshes)
    field = ' containerField="skeleton"' if generic.joint_parents[joint] < 0 else ""
    yield f'<HAnimJoint DEF="hanim_{names[joint]}" name="{names[joint]}"{field}'
    yield f' center="{row_text(clone.joints_m[joint])}"'
    if own := limits.get(generic.joint_names[joint]):
        yield f' llimit="{row_text(own.low)}" ulimit="{row_text(own.high)}"{_axes(own)}'
    yield f' skinCoordIndex="{_integers(index)}" skinCoordWeight="{_numbers(weight)}">\n' if len(index) else ">\n"
    segment = segment_name(generic.joint_names[joint])
    yield f'<HAnimSegment DEF="hanim_{segment}" name="{segment}">\n'
    for site in standard_sites():
        if site.joint == joint:
            name = name_2(site.name)
            place = row_text(clone.vertices_m[site.vertex])
            yield f'<HAnimSite DEF="hanim_{name}" name="{name}" translation="{place}"/>\n'
    yield "</HAnimSegment>\n"
    if generic.joint_names[joint] == "skullbase":
        yield from _displacers(moved)
    for child in np.flatnonzero(generic.joint_parents == joint):
        yield from _joint(clone, generic, int(child), meshes, names, limits, moved)
    yield "</HAnimJoint>\n"


def _axes(limits: Limits) -> str:
    """Return the attribute that turns the limits' axes, nothing where they are the model's."""
    angle = float(np.linalg.norm(limits.axes))
    return f' limitOrientation="{row_text(limits.axes / angle)} {angle:.5f}"' if angle > STILL else ""


def _skin_of(joint: int, meshes: tuple[SkinMesh, ...]) -> tuple[NDArray[np.int64], Array]:
    """Return which vertices a joint moves, counted over all meshes, and by what share."""
    indices, weights, start = [], [], 0
    for mesh in meshes:
        share = np.where(mesh.skin_joints == joint, mesh.skin_weights, 0.0).sum(axis=1)
        rows = np.flatnonzero(share > 0.0)
        total = mesh.skin_weights[rows].sum(axis=1)
        indices.append(rows + start)
        weights.append(share[rows] / total)
        start += len(mesh.vertices_m)
    return np.concatenate(indices), np.concatenate(weights).astype(np.float64)


def _moved(clone: Clone, meshes: tuple[SkinMesh, ...]) -> Iterator[Moved]:
    """Yield the face's targets that move anything, the vertices they move and by how much, metres."""
    vertex = np.concatenate([mesh.vertex for mesh in meshes])
    return (one for one in wedge_offsets(clone, vertex, SMALLEST_OFFSET_M) if len(one[1]))


def _displacers(moved: Sequence[Moved]) -> Iterator[str]:
    for target, rows, own in moved:
        yield (
            f'<HAnimDisplacer DEF="face_{identifier(target)}" name="{target}" containerField="displacers" '
            f'coordIndex="{_integers(rows)}" displacements="{_rows([own.astype(np.float64)])}"/>\n'
        )


def _shape(mesh: SkinMesh, start: int, all_meshes: tuple[SkinMesh, ...]) -> Iterator[str]:
    """Yield a shape of the skin; the first one defines the texture coordinates that all use."""
    yield '<Shape containerField="skin">\n<Appearance><Material diffuseColor="1 1 1" ambientIntensity="0.5" '
    yield f'specularColor="0.03 0.03 0.03" shininess="0.1"/><ImageTexture url="&quot;textures/{mesh.picture}&quot;"/>'
    corners = np.column_stack([mesh.triangles + start, np.full(len(mesh.triangles), -1)])
    solid = "false" if mesh.two_sided else "true"
    yield f'</Appearance>\n<IndexedFaceSet solid="{solid}" coordIndex="{_integers(corners)}">\n'
    yield '<Coordinate USE="skin_coord"/><Normal USE="skin_normal"/>'
    if all_meshes:
        uv = [one.uv * [1.0, -1.0] + [0.0, 1.0] for one in all_meshes]  # X3D counts t upwards
        yield f'<TextureCoordinate DEF="skin_uv" point="{_rows(uv)}"/>'
    else:
        yield '<TextureCoordinate USE="skin_uv"/>'
    yield "\n</IndexedFaceSet></Shape>\n"


def _rows(parts: list[Array]) -> str:
    values = np.concatenate(parts)
    line = " ".join(["%.5f"] * values.shape[1]) + ", "
    return (line * len(values)) % tuple(values.ravel().tolist())


def _numbers(values: Array) -> str:
    return ("%.4f " * len(values)) % tuple(values.tolist())


def _integers(values: NDArray[np.integer]) -> str:
    return " ".join(map(str, values.ravel().tolist()))
