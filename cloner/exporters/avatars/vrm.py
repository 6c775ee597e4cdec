"""VRM 1.0: a glTF in T-pose with humanoid bones, expressions, gaze and licence terms.

References
----------
VRM Consortium 2022, VRMC_vrm 1.0: humanoid, expressions, lookAt, meta.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

import pygltflib

from cloner.exporters.avatars.vrm_springs import EXTENSION as SPRINGS
from cloner.exporters.avatars.vrm_springs import add_spring_bones
from cloner.exporters.avatars.vrm_terms import vrm_meta
from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf import build
from cloner.exporters.shared.files import jpeg_bytes, write_bytes
from cloner.generic.framing import standard_camera
from cloner.generic.layers import clone_layers
from cloner.generic.load import load_generic
from cloner.generic.painter import downsample_samples, paint
from cloner.motion.flesh.rest import in_t_pose
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import Moves, own_motions
from cloner.records.clones import Clone

EXTENSION: Final = "VRMC_vrm"
_TRUNK: Final = {
    "hips": "HumanoidRoot", "spine": "vl5", "chest": "vl1", "upperChest": "vt6", "neck": "vc4", "head": "skullbase",
    "jaw": "temporomandibular",
}  # fmt: skip
_SIDED: Final = {
    "Eye": "eyeball_joint", "Shoulder": "sternoclavicular", "UpperArm": "shoulder", "LowerArm": "elbow",
    "Hand": "wrist", "UpperLeg": "hip", "LowerLeg": "knee", "Foot": "ankle", "Toes": "metatarsal",
    "ThumbMetacarpal": "thumb1", "ThumbProximal": "thumb2", "ThumbDistal": "thumb3",
}  # fmt: skip
_FINGERS: Final = {"Index": "index", "Middle": "middle", "Ring": "ring", "Little": "pinky"}
_KNUCKLES: Final = {"Proximal": "1", "Intermediate": "2", "Distal": "3"}
#: How far eyes turn when something stands so far aside of the head, degrees: eyes turn by 35 degrees at most, the head
#: does the rest; towards the nose and up a little less. At 45 degrees the gaze is then 15 to 22 degrees off.
GAZE_INPUT_DEG: Final = 60.0
GAZE_DEG: Final = {"HorizontalInner": 26.0, "HorizontalOuter": 30.0, "VerticalDown": 22.0, "VerticalUp": 20.0}
#: Side of the thumbnail, pixels (programs show 256), and what lies behind the head (taste).
THUMBNAIL_PX: Final = 256
_BACKDROP: Final = (226, 228, 230)
#: VRM's expressions as sums of the clone's targets.
EXPRESSIONS: Final[Mapping[str, Mapping[str, float]]] = MappingProxyType({
    "happy": {"mouthSmileLeft": 0.8, "mouthSmileRight": 0.8, "cheekSquintLeft": 0.5, "cheekSquintRight": 0.5},
    "angry": {"browDownLeft": 0.9, "browDownRight": 0.9, "noseSneerLeft": 0.5, "noseSneerRight": 0.5,
              "mouthFrownLeft": 0.4, "mouthFrownRight": 0.4},
    "sad": {"browInnerUp": 0.8, "mouthFrownLeft": 0.7, "mouthFrownRight": 0.7, "eyeSquintLeft": 0.2,
            "eyeSquintRight": 0.2},
    "relaxed": {"mouthSmileLeft": 0.35, "mouthSmileRight": 0.35, "eyeSquintLeft": 0.3, "eyeSquintRight": 0.3},
    "surprised": {"eyeWideLeft": 0.8, "eyeWideRight": 0.8, "browOuterUpLeft": 0.7, "browOuterUpRight": 0.7,
                  "browInnerUp": 0.6, "jawOpen": 0.3},
    "aa": {"viseme_aa": 1.0}, "ih": {"viseme_I": 1.0}, "ou": {"viseme_U": 1.0}, "ee": {"viseme_E": 1.0},
    "oh": {"viseme_O": 1.0},
    "blink": {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0}, "blinkLeft": {"eyeBlinkLeft": 1.0},
    "blinkRight": {"eyeBlinkRight": 1.0},
})  # fmt: skip


def export(clone: Clone, folder: Path, *, name: str = "clone", moves: Moves = own_motions) -> tuple[Path, ...]:
    """Write ``<name>.vrm`` and return its path.

    Without a recorded consent its terms let nobody but the person use it; with one, what its licence says.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    posed = in_t_pose(centre_joints(clone))
    gltf = build(posed, moves=moves, shades=True)
    gltf.extensionsUsed = [*gltf.extensionsUsed, EXTENSION]
    nodes = {node.name: number for number, node in enumerate(gltf.nodes)}
    gltf.extensions = {EXTENSION: _vrm(posed, nodes, name)}
    gltf.extensions[EXTENSION]["meta"]["thumbnailImage"] = _thumbnail(gltf, posed)
    springs = add_spring_bones(gltf, posed)
    if springs is not None:
        gltf.extensionsUsed = [*gltf.extensionsUsed, SPRINGS]
        gltf.extensions[SPRINGS] = springs
    path = folder / f"{name}.vrm"
    write_bytes(path, glb_bytes(gltf))
    return (path,)


def _thumbnail(gltf: Any, clone: Clone) -> int:
    """Add a picture of the head, which programs show in their lists, and return its number."""
    camera = standard_camera(clone, "face", 2 * THUMBNAIL_PX, 2 * THUMBNAIL_PX)
    picture = paint(clone_layers(clone), camera, background=_BACKDROP)
    data, blob = jpeg_bytes(downsample_samples(picture, 2)), gltf.binary_blob()
    gltf.bufferViews.append(pygltflib.BufferView(buffer=0, byteOffset=len(blob), byteLength=len(data)))
    gltf.images.append(pygltflib.Image(name="thumbnail", mimeType="image/jpeg", bufferView=len(gltf.bufferViews) - 1))
    blob += data + bytes(-len(data) % 4)
    gltf.set_binary_blob(blob)
    gltf.buffers[0].byteLength = len(blob)
    return len(gltf.images) - 1


def _vrm(clone: Clone, nodes: Mapping[str, int], name: str) -> dict[str, Any]:
    generic = load_generic()
    head = clone.joints_m[generic.joint("skullbase")]
    eyes = (clone.joints_m[generic.joint("l_eyeball_joint")] + clone.joints_m[generic.joint("r_eyeball_joint")]) / 2.0
    return {
        "specVersion": "1.0",
        "meta": vrm_meta(clone.terms, name),
        "humanoid": {"humanBones": {bone: {"node": nodes[joint]} for bone, joint in human_bones().items()}},
        "expressions": {"preset": _expressions(clone, nodes["Body"])},
        "lookAt": {
            "type": "bone",
            "offsetFromHeadBone": [round(float(x), 5) for x in eyes - head],
            **{
                f"rangeMap{way}": {"inputMaxValue": GAZE_INPUT_DEG, "outputScale": most}
                for way, most in GAZE_DEG.items()
            },
        },
    }


def human_bones() -> dict[str, str]:
    """Return the H-Anim joint of every VRM bone."""
    bones = dict(_TRUNK)
    for side, letter in (("left", "l"), ("right", "r")):
        bones |= {f"{side}{bone}": f"{letter}_{joint}" for bone, joint in _SIDED.items()}
        bones |= {
            f"{side}{finger}{knuckle}": f"{letter}_{joint}{number}"
            for finger, joint in _FINGERS.items()
            for knuckle, number in _KNUCKLES.items()
        }
    return bones


def _expressions(clone: Clone, node: int) -> dict[str, Any]:
    found = {}
    for name, weights in EXPRESSIONS.items():
        binds = [
            {"node": node, "index": clone.morph_names.index(target), "weight": weight}
            for target, weight in weights.items()
            if target in clone.morph_names
        ]
        if binds:
            found[name] = {"morphTargetBinds": binds, "isBinary": False}
    return found
