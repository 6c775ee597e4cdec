"""VRM animations: a clone's motion for any VRM avatar.

References
----------
VRM Consortium 2024, VRMC_vrm_animation 1.0: the humanoid's bones are plain nodes, an expression is a node whose
translation along x is its weight.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

import numpy as np
import pygltflib

from cloner import __version__
from cloner.exporters.avatars.vrm import human_bones
from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf import add_skeleton
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.exporters.gltf.gltf_motion import animation
from cloner.exporters.shared.bones import hanim_bones
from cloner.exporters.shared.credits import CREDITS
from cloner.exporters.shared.files import write_bytes
from cloner.motion.flesh.rest import in_t_pose
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import Moves, own_motions
from cloner.records.clones import Clone
from cloner.records.motions import Motion

EXTENSION: Final = "VRMC_vrm_animation"
#: The format's expressions that one target alone makes; a motion's other targets have no name there.
PRESETS: Final[Mapping[str, str]] = MappingProxyType({
    "aa": "viseme_aa", "ih": "viseme_I", "ou": "viseme_U", "ee": "viseme_E", "oh": "viseme_O",
    "blinkLeft": "eyeBlinkLeft", "blinkRight": "eyeBlinkRight",
})  # fmt: skip


def export(clone: Clone, folder: Path, *, name: str = "clone", moves: Moves = own_motions) -> tuple[Path, ...]:
    """Write ``<name>.vrma`` with the first motion, and return its path.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    posed = in_t_pose(centre_joints(clone))
    path = folder / f"{name}.vrma"
    write_bytes(path, glb_bytes(_file(posed, moves(posed)[0])))
    return (path,)


def _file(clone: Clone, motion: Motion) -> Any:
    bones = hanim_bones()
    gltf = pygltflib.GLTF2(
        asset=pygltflib.Asset(version="2.0", generator=f"Cloner {__version__}", copyright=CREDITS),
        scene=0,
        extras={"stamp": clone.stamp},
    )
    buffer = GltfBuffer(gltf, np.zeros((2, 3)))
    add_skeleton(gltf, buffer, clone, bones)
    gltf.skins = []  # nothing hangs on the bones
    nodes = {node.name: number for number, node in enumerate(gltf.nodes)}
    made = animation(buffer, clone, motion, bones, 0)
    made.channels = [channel for channel in made.channels if channel.target.path != "weights"]
    made.samplers = made.samplers[: len(made.channels)]  # the weights come last
    gltf.animations.append(made)
    gltf.extensionsUsed = [EXTENSION]
    gltf.extensions = {EXTENSION: {
        "specVersion": "1.0",
        "humanoid": {"humanBones": {bone: {"node": nodes[joint]} for bone, joint in human_bones().items()
                                    if not bone.endswith("Eye")}},
        "expressions": {"preset": _expressions(gltf, buffer, motion)},
    }}  # fmt: skip
    gltf.scenes.append(pygltflib.Scene(nodes=[0, *range(len(nodes), len(gltf.nodes))]))
    data = buffer.data()
    gltf.buffers.append(pygltflib.Buffer(byteLength=len(data)))
    gltf.set_binary_blob(data)
    return gltf


def _expressions(gltf: Any, buffer: GltfBuffer, motion: Motion) -> dict[str, Any]:
    """Add a node and a track for every expression that the motion plays, and return them."""
    made, found = gltf.animations[0], {}
    for expression, target in PRESETS.items():
        weights = motion.weights.get(target)
        if weights is None or not np.any(weights):
            continue
        gltf.nodes.append(pygltflib.Node(name=f"expression_{expression}"))
        places = np.column_stack([np.clip(weights, 0.0, 1.0), np.zeros((len(weights), 2))])
        made.samplers.append(
            pygltflib.AnimationSampler(
                input=made.samplers[0].input, output=buffer.values(places), interpolation="LINEAR"
            )
        )
        target_node = pygltflib.AnimationChannelTarget(node=len(gltf.nodes) - 1, path="translation")
        made.channels.append(pygltflib.AnimationChannel(sampler=len(made.samplers) - 1, target=target_node))
        found[expression] = {"node": len(gltf.nodes) - 1}
    return found
