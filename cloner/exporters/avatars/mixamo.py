"""glTF with Mixamo's skeleton: its names and hierarchy, in T-pose.

Mixamo's own files turn every bone's axes along the bone; glTF asks for no such axes and ours are the model's. Programs
that retarget by names and rest pose (Unity, Unreal, Blender's add-ons) need no more; copying raw rotations from a
Mixamo file does.

References
----------
reference/rig_names.csv of the project's brief (names; which vertebra is which spine bone is a choice).
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf import build
from cloner.exporters.shared.bones import Bones, kept_bones
from cloner.exporters.shared.files import write_bytes
from cloner.motion.flesh.rest import in_t_pose
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import Moves, own_motions
from cloner.records.clones import Clone

PREFIX: Final = "mixamorig:"
_TRUNK: Final = {
    "HumanoidRoot": "Hips", "vl5": "Spine", "vl1": "Spine1", "vt6": "Spine2", "vc4": "Neck", "skullbase": "Head",
}  # fmt: skip
_SIDED: Final = {
    "eyeball_joint": "Eye", "sternoclavicular": "Shoulder", "shoulder": "Arm", "elbow": "ForeArm", "wrist": "Hand",
    "hip": "UpLeg", "knee": "Leg", "ankle": "Foot", "metatarsal": "ToeBase",
}  # fmt: skip
_FINGERS: Final = ("thumb", "index", "middle", "ring", "pinky")


def mixamo_bones() -> Bones:
    """Return the skeleton of Mixamo's 54 bones, tips left out."""
    names = dict(_TRUNK)
    for letter, side in (("l", "Left"), ("r", "Right")):
        names |= {f"{letter}_{joint}": f"{side}{bone}" for joint, bone in _SIDED.items()}
        names |= {
            f"{letter}_{finger}{number}": f"{side}Hand{finger.capitalize()}{number}"
            for finger in _FINGERS
            for number in (1, 2, 3)
        }
    return kept_bones("Mixamo", {joint: PREFIX + bone for joint, bone in names.items()})


def export(clone: Clone, folder: Path, *, name: str = "clone", moves: Moves = own_motions) -> tuple[Path, ...]:
    """Write ``<name>_mixamo.glb`` and return its path.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    path = folder / f"{name}_mixamo.glb"
    made = build(in_t_pose(centre_joints(clone)), moves=moves, bones=mixamo_bones(), corrects=True, shades=True)
    write_bytes(path, glb_bytes(made))
    return (path,)
