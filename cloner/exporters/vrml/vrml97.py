"""VRML97 without seams: one skin with interpolated points, beside its H-Anim joints.

VRML97 and H-Anim 1.1 know no skin; rigid pieces on joints gape when they bend (format ``hanim``). Here every picture of
a motion is the whole skin, bent by the joints as everywhere else, and the browser goes from one to the next. Joints,
segments and sites are plain nodes with H-Anim's names and turn with it: no prototype, which some readers visit again
and again. The clone walks as soon as the world is loaded; a click on it lets it stand, breathe and blink.

Lengths are whole quarters of a millimetre under one scale: half the text. Metres, +Y up, facing +Z.

References
----------
ISO/IEC 14772-1:1997 (VRML97), 6.13 (CoordinateInterpolator), 6.50 (TimeSensor), 6.51 (TouchSensor).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner import __version__
from cloner.exporters.hanim.hanim_names import node_name, segment_name
from cloner.exporters.shared.credits import GENERIC_CREDITS
from cloner.exporters.shared.files import write_bytes
from cloner.exporters.shared.pictures import write_pictures
from cloner.exporters.vrml.vrml_motion import motion_nodes, motion_routes
from cloner.exporters.vrml.vrml_segments import SkinMesh, appearance_text, quoted, row_text, site_texts, skin_meshes
from cloner.exporters.vrml.vrml_views import viewpoints
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.morphs import target_offsets
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.motion.flesh.rest import in_hanging_pose
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import Moves, own_motions
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

#: Pictures of the whole skin a second of a motion, and of one that hardly moves. Between two of them the straight ways
#: of the skin leave its arcs by 1.2 mm on average and 13 mm at most, on a swinging foot (with 12: 3.5 and 40).
PICTURES_PER_S: Final = 20.0
SLOW_PICTURES_PER_S: Final = 1.5
#: The unit of written lengths, metres: no number of a grown person has more than four digits.
UNIT_M: Final = 2.5e-4
#: A motion whose joints turn slower than this is slow, radians a second.
SLOW_RAD_S: Final = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class _Part:
    """One shape: a mesh whose wedges share their points; ``rows`` are the mesh's wedges that stand for the points."""

    mesh: SkinMesh
    rows: NDArray[np.int64]
    point: NDArray[np.int64]


def export(
    clone: Clone,
    folder: Path,
    *,
    name: str = "clone",
    moves: Moves = own_motions,
) -> tuple[Path, ...]:
    """Write ``<name>.wrl`` and its pictures in ``textures/``, and return all paths.

    Parameters
    ----------
    clone : Clone
    folder : Path
    name : str
    moves : callable
        Makes the motions of a clone in some rest pose; the first one plays at once, the second at a click.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    clone = centre_joints(clone)
    pictures = write_pictures(clone, folder, name)
    scene = folder / f"{name}.wrl"
    write_bytes(scene, "".join(_scene(clone, name, moves)).encode())
    return (scene, *pictures)


def _scene(clone: Clone, name: str, moves: Moves) -> Iterator[str]:
    """Yield the file's text; routes come last."""
    generic, hanging = load_generic(), in_hanging_pose(clone)
    yield f"#VRML V2.0 utf8\n# Written by Cloner {__version__}. {GENERIC_CREDITS}.\n\n"
    info = (GENERIC_CREDITS, "units=metre up=+Y front=+Z", f"height={clone.stature_m:.4f}", f"stamp={clone.stamp}")
    yield f'WorldInfo {{ title "clone" info [ {" ".join(map(quoted, info))} ] }}\n'
    yield 'NavigationInfo { type [ "EXAMINE" "ANY" ] }\nBackground { skyColor 0.88 0.89 0.9 }\n'
    yield from viewpoints(hanging)
    parts = [_part(mesh) for mesh in skin_meshes(clone, generic, name)]
    yield f"DEF hanim_humanoid Group {{ children [\nDEF touch TouchSensor {{ }}\nDEF skin Transform {{ scale {UNIT_M} "
    yield f"{UNIT_M} {UNIT_M} children [\n"
    at_rest = [mesh.vertices_m for mesh in skin_meshes(hanging, generic, name)]
    seen: set[str] = set()
    for number, (part, points) in enumerate(zip(parts, at_rest, strict=True)):
        yield from _shape(part, points, number, seen)
    yield "] }\n"
    root = int(np.flatnonzero(generic.joint_parents < 0)[0])
    yield from _joint(hanging, generic, root, site_texts(hanging, generic, "Transform"))
    yield "] }\n"
    played = [_thinned(own, turning) for own, turning in zip(moves(clone), moves(hanging), strict=True)][:2]
    for skinned, turning in played:
        yield from motion_nodes(turning, generic.joint_names, generic.joint_names[root], loop=turning is played[0][1])
        yield from _pictures(clone, generic, skinned, parts)
    for skinned, turning in played:
        yield from motion_routes(turning, generic.joint_names, generic.joint_names[root])
        for number in range(len(parts)):
            yield f"ROUTE {skinned.name}_clock.fraction_changed TO {skinned.name}_skin_{number}.set_fraction\n"
            yield f"ROUTE {skinned.name}_skin_{number}.value_changed TO skin_{number}.set_point\n"
    if len(played) > 1:
        yield f"ROUTE touch.touchTime TO {played[0][0].name}_clock.set_stopTime\n"
        yield f"ROUTE touch.touchTime TO {played[1][0].name}_clock.set_startTime\n"


def _part(mesh: SkinMesh) -> _Part:
    """Return a mesh with one point for all wedges of a vertex: their normals are then smooth across seams."""
    key = (
        mesh.vertex if (mesh.vertex >= 0).all() else np.unique(mesh.vertices_m, axis=0, return_inverse=True)[1].ravel()
    )
    _, rows, point = np.unique(key, return_index=True, return_inverse=True)
    return _Part(mesh, rows, point.ravel())


def _shape(part: _Part, points_m: Array, number: int, seen: set[str]) -> Iterator[str]:
    mesh = part.mesh
    uv = mesh.uv * [1.0, -1.0] + [0.0, 1.0]  # VRML counts t upwards
    yield f"Shape {{ {appearance_text(mesh, seen)}\ngeometry IndexedFaceSet {{ creaseAngle 3.2 "
    yield f"solid {'FALSE' if mesh.two_sided else 'TRUE'}\n"
    yield f"coord DEF skin_{number} Coordinate {{ point [\n{_whole(points_m[part.rows])}] }}\n"
    yield f"texCoord TextureCoordinate {{ point [\n{('%.4f %.4f,' * len(uv)) % tuple(uv.ravel().tolist())}] }}\n"
    yield f"coordIndex [\n{_corners(part.point[mesh.triangles])}]\n"
    yield f"texCoordIndex [\n{_corners(mesh.triangles)}] }} }}\n"


def _joint(clone: Clone, generic: GenericHuman, joint: int, sites: list[list[str]]) -> Iterator[str]:
    """Yield a joint with its segment, whose sites they are, and every joint below it."""
    name = generic.joint_names[joint]
    yield f"DEF hanim_{name} Transform {{ center {row_text(clone.joints_m[joint])} children [\n"
    yield f"DEF hanim_{segment_name(name)} Group {{ children [\n{''.join(sites[joint])}] }}\n"
    for child in np.flatnonzero(generic.joint_parents == joint):
        yield from _joint(clone, generic, int(child), sites)
    yield "] }\n"


def _thinned(*motions: Motion) -> tuple[Motion, ...]:
    """Return the same motion of two rest poses at the few moments whose pictures are kept."""
    rows = _kept(motions[0])
    return tuple(
        replace(
            motion,
            name=node_name(motion.name),
            times_s=motion.times_s[rows],
            root_m=motion.root_m[rows],
            rotations=motion.rotations[rows],
            weights={target: values[rows] for target, values in motion.weights.items()},
        )
        for motion in motions
    )


def _kept(motion: Motion) -> NDArray[np.int64]:
    """Return the frames of which pictures are kept: evenly, and wherever a target of the face turns back."""
    step = float(np.diff(motion.times_s).mean())
    fast = np.abs(np.diff(motion.rotations, axis=0)).max() / step > SLOW_RAD_S
    count = max(round(float(motion.times_s[-1]) * (PICTURES_PER_S if fast else SLOW_PICTURES_PER_S)), 1)
    rows = set(np.rint(np.linspace(0, len(motion.times_s) - 1, count + 1)).astype(int).tolist())
    for values in motion.weights.values():
        slope = np.sign(np.diff(values))
        rows |= set((1 + np.flatnonzero(np.diff(slope))).tolist())
    return np.array(sorted(rows))


def _pictures(clone: Clone, generic: GenericHuman, motion: Motion, parts: list[_Part]) -> Iterator[str]:
    """Yield the interpolators of a motion's skin, one a shape."""
    moved = {name: offsets.copy() for name, offsets in target_offsets(clone) if name in motion.weights}
    keys = " ".join(f"{time / motion.times_s[-1]:.4f}" for time in motion.times_s)
    frames = [joint_transforms(clone.joints_m, generic.joint_parents, turns) for turns in motion.rotations]
    for number, part in enumerate(parts):
        mesh, rows = part.mesh, part.rows
        joints, weights = mesh.skin_joints[rows].astype(np.int32), mesh.skin_weights[rows].astype(np.float64)
        texts = []
        for frame, transforms in enumerate(frames):
            points = mesh.vertices_m[rows].copy()
            for name, offsets in moved.items():
                points += float(motion.weights[name][frame]) * offsets[mesh.vertex[rows]]
            texts.append(_whole(linear_blend_skinning(points, transforms, joints, weights) + motion.root_m[frame]))
        yield f"DEF {motion.name}_skin_{number} CoordinateInterpolator {{ key [ {keys} ] keyValue [\n"
        yield "".join(texts)
        yield "] }\n"


def _whole(points_m: Array) -> str:
    """Return points in whole units, one line."""
    numbers = np.rint(points_m / UNIT_M).astype(np.int64)
    return ("%d %d %d," * len(numbers)) % tuple(numbers.ravel().tolist()) + "\n"


def _corners(triangles: NDArray[np.integer]) -> str:
    return ("%d %d %d -1 " * len(triangles)) % tuple(triangles.ravel().tolist()) + "\n"
