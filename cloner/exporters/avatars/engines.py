"""glTF with engine skeletons: Unity's humanoid in T-pose, Unreal's mannequin in A-pose.

Bones keep the model's axes: both engines retarget by names and rest pose. Metres; the engines' importers scale.

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

_UNITY_TRUNK: Final = {
    "HumanoidRoot": "Hips", "vl5": "Spine", "vl1": "Chest", "vt6": "UpperChest", "vc4": "Neck", "skullbase": "Head",
    "temporomandibular": "Jaw",
}  # fmt: skip
_UNITY_SIDED: Final = {
    "eyeball_joint": "Eye", "sternoclavicular": "Shoulder", "shoulder": "UpperArm", "elbow": "LowerArm",
    "wrist": "Hand", "hip": "UpperLeg", "knee": "LowerLeg", "ankle": "Foot", "metatarsal": "Toes",
}  # fmt: skip
_UNREAL_TRUNK: Final = {
    "HumanoidRoot": "pelvis", "vl5": "spine_01", "vl1": "spine_02", "vt6": "spine_03", "vc4": "neck_01",
    "vc2": "neck_02", "skullbase": "head",
}  # fmt: skip
_UNREAL_SIDED: Final = {
    "sternoclavicular": "clavicle", "shoulder": "upperarm", "elbow": "lowerarm", "wrist": "hand", "hip": "thigh",
    "knee": "calf", "ankle": "foot", "metatarsal": "ball",
}  # fmt: skip
_KNUCKLES: Final = ("Proximal", "Intermediate", "Distal")
_FINGERS: Final = {"thumb": "Thumb", "index": "Index", "middle": "Middle", "ring": "Ring", "pinky": "Little"}
_SIDES: Final = {"l": "Left", "r": "Right"}


def unity_bones() -> Bones:
    """Return the skeleton of Unity's HumanBodyBones."""
    names: dict[str, str] = dict(_UNITY_TRUNK)
    for letter, side in _SIDES.items():
        names |= {f"{letter}_{joint}": side + bone for joint, bone in _UNITY_SIDED.items()}
        for finger, own in _FINGERS.items():
            names |= {f"{letter}_{finger}{k + 1}": side + own + part for k, part in enumerate(_KNUCKLES)}
    return kept_bones("Unity", names)


def unreal_bones() -> Bones:
    """Return the skeleton of Unreal's mannequin, without its twist and metacarpal bones."""
    names: dict[str, str] = dict(_UNREAL_TRUNK)
    for letter in _SIDES:
        names |= {f"{letter}_{joint}": f"{bone}_{letter}" for joint, bone in _UNREAL_SIDED.items()}
        names |= {f"{letter}_{finger}{k}": f"{finger}_0{k}_{letter}" for finger in _FINGERS for k in (1, 2, 3)}
    return kept_bones("Unreal", names)


def export_unity(clone: Clone, folder: Path, *, name: str = "clone", moves: Moves = own_motions) -> tuple[Path, ...]:
    """Write ``<name>_unity.glb``, in T-pose, and return its path.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    return _written(in_t_pose(centre_joints(clone)), folder / f"{name}_unity.glb", unity_bones(), moves)


def export_unreal(clone: Clone, folder: Path, *, name: str = "clone", moves: Moves = own_motions) -> tuple[Path, ...]:
    """Write ``<name>_unreal.glb``, in the photos' A-pose, and return its path.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    return _written(centre_joints(clone), folder / f"{name}_unreal.glb", unreal_bones(), moves)


def _written(clone: Clone, path: Path, bones: Bones, moves: Moves) -> tuple[Path, ...]:
    write_bytes(path, glb_bytes(build(clone, moves=moves, bones=bones, corrects=True, shades=True)))
    return (path,)
