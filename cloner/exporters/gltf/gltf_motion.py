"""Motions as glTF animations.

References
----------
Khronos Group 2021, glTF 2.0 specification, section 3.11 (animations).
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.exporters.shared.bones import Bones
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

#: Smaller turns of a joint in a whole motion are left out, radians; taste.
STILL: Final = 1e-4


def animation(buffer: GltfBuffer, clone: Clone, motion: Motion, bones: Bones, mesh: int) -> Any:
    """Return a motion as a ``pygltflib.Animation``.

    Parameters
    ----------
    buffer
        Of the file being built.
    clone : Clone
    motion : Motion
    bones : Bones
        The file's skeleton; its bones are the nodes from 1 on.
    mesh : int
        Node of the mesh with the morph targets.
    """
    times = buffer.values(motion.times_s, bounds=True)
    made = pygltflib.Animation(
        name=motion.name, extras={"cyclic": motion.cyclic, "speed_m_s": round(motion.speed_m_s, 4)}
    )

    for bone, rotations in enumerate(bones.rotations(motion).transpose(1, 0, 2)):
        if np.abs(rotations).max() > STILL:
            _move(made, times, 1 + bone, "rotation", buffer.turns(quaternions(rotations)))
    root = int(np.flatnonzero(bones.parents < 0)[0])
    if np.abs(motion.root_m).max() > 0.0:
        _move(made, times, 1 + root, "translation", buffer.values(clone.joints_m[bones.joints[root]] + motion.root_m))
    if set(motion.weights) & set(clone.morph_names):
        still = np.zeros(len(motion.times_s))
        rows = [motion.weights.get(name, still) for name in clone.morph_names]
        _move(made, times, mesh, "weights", buffer.values(np.column_stack(rows).reshape(-1)))
    return made


def add_free(buffer: GltfBuffer, made: Any, node: int, moved: Array, times_s: Array) -> None:
    """Add the motion of free bones, nodes from ``node`` on, to an animation.

    Parameters
    ----------
    buffer
    made
        The ``pygltflib.Animation``.
    node : int
    moved : (F, K, 3, 4)
        Rigid transforms of each bone, metres.
    times_s : (F,)
    """
    times = buffer.values(times_s, bounds=True)
    for bone, rigid in enumerate(moved.transpose(1, 0, 2, 3)):
        turned = quaternions(Rotation.from_matrix(rigid[:, :, :3]).as_rotvec())
        for path, output in (("rotation", buffer.turns(turned)), ("translation", buffer.values(rigid[:, :, 3]))):
            _move(made, times, node + bone, path, output)


def _move(made: Any, times: int, node: int, path: str, output: int) -> None:
    """Add to an animation that a node's path takes the values of an accessor at the times of another."""
    made.samplers.append(pygltflib.AnimationSampler(input=times, output=output, interpolation="LINEAR"))
    target = pygltflib.AnimationChannelTarget(node=node, path=path)
    made.channels.append(pygltflib.AnimationChannel(sampler=len(made.samplers) - 1, target=target))


def quaternions(rotations: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (F, 4) unit quaternions x, y, z, w of (F, 3) rotation vectors, neighbours never on opposite sides."""
    found = Rotation.from_rotvec(np.array(rotations)).as_quat()
    flips = np.where(np.einsum("fa,fa->f", found[1:], found[:-1]) < 0.0, -1.0, 1.0)
    found[1:] *= np.cumprod(flips)[:, None]
    return np.asarray(found)
