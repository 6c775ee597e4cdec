"""VRML97 with the H-Anim 1.1 prototypes: rigid pieces on joints, for H-Anim programs.

H-Anim 1.1 knows no skin: the body is cut into rigid pieces by the joint that
moves each triangle most, and the pieces hang on the joints' segments. Borders
repeat the same vertices and normals, so the resting body - arms hanging, as H-Anim
has it - shows no seam; bent joints gape a little (``wrl`` does not). The
face's morph targets become Displacers. It walks on the spot as soon as the
world is loaded. Metres, +Y up, facing +Z.

References
----------
ISO/IEC 14772-1:1997 (VRML97); Humanoid Animation Working Group 1999, H-Anim 1.1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from cloner import __version__
from cloner.exporters.hanim.hanim_limits import hanging_limits
from cloner.exporters.hanim.hanim_names import segment_name
from cloner.exporters.hanim.hanim_protos import PROTOS
from cloner.exporters.hanim.hanim_sites import placed_sites
from cloner.exporters.shared.credits import GENERIC_CREDITS
from cloner.exporters.shared.files import write_bytes
from cloner.exporters.shared.pictures import write_pictures
from cloner.exporters.vrml.vrml_motion import motion_text
from cloner.exporters.vrml.vrml_segments import quoted, row_text, segment_texts
from cloner.exporters.vrml.vrml_views import viewpoints
from cloner.generic.load import GenericHuman, load_generic
from cloner.motion.flesh.rest import in_hanging_pose
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.records.clones import Clone


def export(clone: Clone, folder: Path, *, name: str = "clone") -> tuple[Path, ...]:
    """Write ``<name>_hanim.wrl`` and its pictures in ``textures/``, and return all paths.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    clone = in_hanging_pose(centre_joints(clone))
    pictures = write_pictures(clone, folder, name)
    scene = folder / f"{name}_hanim.wrl"
    write_bytes(scene, "".join(_scene(clone, name)).encode())
    return (scene, *pictures)


def _scene(clone: Clone, name: str) -> Iterator[str]:
    """Yield the file's text."""
    generic = load_generic()
    yield f"#VRML V2.0 utf8\n# Written by Cloner {__version__}. {GENERIC_CREDITS}.\n\n{PROTOS}\n"
    info = (GENERIC_CREDITS, "units=metre up=+Y front=+Z", f"stamp={clone.stamp}")
    yield f'WorldInfo {{ title "clone" info [ {" ".join(map(quoted, info))} ] }}\n'
    yield 'NavigationInfo { type [ "EXAMINE" "ANY" ] }\nBackground { skyColor 0.88 0.89 0.9 }\n\n'
    yield 'DEF hanim_humanoid Humanoid {\nname "clone"\nversion "1.1"\n'
    yield f'info [ "humanoidVersion=1.1" "authorName=Cloner {__version__}" "height={clone.stature_m:.4f}" ]\n'
    yield "viewpoints [\n" + "".join(viewpoints(clone)) + "]\n"
    yield "humanoidBody [\n"
    root = int(np.flatnonzero(generic.joint_parents < 0)[0])
    yield from _joint(clone, generic, root, segment_texts(clone, generic, name))
    yield "]\n"
    yield _uses("joints", generic.joint_names)
    yield _uses("segments", [segment_name(joint) for joint in generic.joint_names])
    yield _uses("sites", [site for site, _, _ in placed_sites(clone)])
    yield "}\n"
    yield from motion_text(own_motions(clone)[0], generic.joint_names, generic.joint_names[root])  # routes come last


def _uses(field: str, names: Sequence[str]) -> str:
    return f"{field} [\n" + "".join(f"USE hanim_{name}\n" for name in names) + "]\n"


def _joint(clone: Clone, generic: GenericHuman, joint: int, segments: list[str]) -> Iterator[str]:
    """Yield a joint, its segment and every joint below it."""
    name = generic.joint_names[joint]
    yield f'DEF hanim_{name} Joint {{ name "{name}" center {row_text(clone.joints_m[joint])}\n'
    limits = hanging_limits(name)
    if limits is not None:
        yield f"llimit [ {row_text(limits.low)} ] ulimit [ {row_text(limits.high)} ]\n"
    yield "children [\n"
    yield segments[joint]
    for child in np.flatnonzero(generic.joint_parents == joint):
        yield from _joint(clone, generic, int(child), segments)
    yield "] }\n"
