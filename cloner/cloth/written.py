"""A dressed clone as a file: a GLB whose garment moves by morph targets with the walk, or a film that repeats."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner.cloth.blocks import BLOCKS, Block, draft
from cloner.cloth.fabrics import FABRICS, Fabric
from cloner.cloth.loop import Loop, best_loop
from cloner.cloth.moving import Worn, put_on, simulate
from cloner.cloth.pattern import Pattern, read_pattern
from cloner.cloth.placing import body_ring
from cloner.cloth.wearer import FRAMES_PER_S
from cloner.errors import ClonerError
from cloner.exporters.files import write_bytes
from cloner.exporters.glb_file import glb_bytes
from cloner.exporters.gltf import build
from cloner.exporters.gltf_buffer import GltfBuffer
from cloner.generic.layers import Layer, clone_layers
from cloner.geometry.viewpoints import framing_camera
from cloner.geometry.wedges import vertex_normals
from cloner.motion.body import body_of
from cloner.motion.bvh import read_bvh
from cloner.motion.cycle import walk_cycle
from cloner.motion.own import own_motions
from cloner.motion.retarget import retarget
from cloner.motion.rig import centred
from cloner.picture import clone_of
from cloner.pipeline import Progress, quiet
from cloner.project.atomic import safe_output
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from cloner.render import draw
from cloner.vision.films import FORMATS as FILMS
from cloner.vision.films import write_film

Array = NDArray[np.float64]

WALK: Final = "walk"
GLB: Final = ".glb"
WAIST: Final = "natural_waist"
#: Cycles that are simulated to find a loop in, and the step of the cloth's triangles: about 5,000 vertices in a skirt.
CYCLES: Final = 8
STEP_M: Final = 0.0152
#: Lengths that a garment from a ring can have, metres.
LENGTHS_M: Final = (0.15, 1.2)
SIZE_PX: Final = (480, 720)
#: Material of cloth; taste.
ROUGHNESS: Final = 0.9


@dataclass(frozen=True, slots=True, eq=False)
class Dressed:
    """A clone and its garment in a closed loop."""

    clone: Clone
    motion: Motion
    worn: Worn
    loop: Loop
    fabric: Fabric


def dress_file(
    clone_path: Path,
    out: Path,
    *,
    garment: str,
    fabric: str,
    motion: str = WALK,
    length_cm: float | None = None,
    progress: Progress = quiet,
) -> tuple[str, ...]:
    """Put a garment on a clone, let it walk, and write the loop; return what to say of it.

    Parameters
    ----------
    clone_path : Path
    out : Path
        A .glb, or a film (.gif, .webp, .mp4).
    garment : str
        A block's name, or a file of a garment (.json).
    fabric : str
    motion : str
        "walk", or a capture of a walk (.bvh).
    length_cm : float or None
        Of a block.
    progress : callable
        May raise Cancelled: nothing was written then.

    Raises
    ------
    ClonerError
        If something named does not exist, or cannot be worn or written.
    """
    if out.suffix.lower() not in (GLB, *FILMS):
        hint = f"Give --out a name that ends with {', '.join((GLB, *FILMS))}"
        raise ClonerError(f"no dressed clone is written as {out.suffix or 'this'}", hint, out.name)
    safe_output(out)
    cloth = _fabric(fabric)
    clone = centred(clone_of(clone_path))
    pattern, ring_level = _pattern(clone, garment, length_cm)
    found = dressed(clone, pattern, ring_level, cloth, _motion(clone, motion), progress=progress)
    progress("export", 0.97)
    if out.suffix.lower() == GLB:
        write_bytes(out, glb(found))
    else:
        write_film(list(pictures(found)), FRAMES_PER_S, out)
    loop = found.loop
    return (
        f"loop of {len(loop.frames_m)} frames, {found.worn.cloth.count} vertices: gap {loop.gap_mm:.0f} mm "
        f"(median stretch {loop.median_mm:.0f}), closed by {loop.moved_mm:.0f} mm at most",
        str(out),
    )


def dressed(
    clone: Clone,
    pattern: Pattern,
    ring_level: str,
    fabric: Fabric,
    motion: Motion,
    *,
    cycles: int = CYCLES,
    step_m: float = STEP_M,
    progress: Progress = quiet,
) -> Dressed:
    """Return a clone with a garment that moves in a loop with a cyclic motion."""
    worn = put_on(clone, pattern, body_ring(clone, ring_level), fabric, motion, step_m)
    total, kept = cycles * len(worn.rotations), []
    for number, state in simulate(worn, cycles):
        if number >= 0:
            kept.append(state.places_m)
        progress("cloth", 0.9 * max(number, 0) / total)
    progress("loop", 0.9)
    return Dressed(clone, motion, worn, best_loop(worn, np.array(kept)), fabric)


def _fabric(name: str) -> Fabric:
    if name not in FABRICS:
        raise ClonerError(f"the fabric {name!r} is not known", f"The fabrics are {', '.join(FABRICS)}", "--fabric")
    return FABRICS[name]


def _pattern(clone: Clone, garment: str, length_cm: float | None) -> tuple[Pattern, str]:
    """Return the pieces and the level that they hang from."""
    if garment.endswith(".json"):
        return read_pattern(Path(garment)), WAIST
    if garment not in BLOCKS:
        hint = f"The garments are {', '.join(BLOCKS)}, or a .json file"
        raise ClonerError(f"the garment {garment!r} is not known", hint, "--garment")
    block: Block = BLOCKS[garment]
    ring = body_ring(clone, block.ring)
    high = float(ring.points_m[0, 1])
    length = block.share * high if length_cm is None else length_cm / 100.0
    if not LENGTHS_M[0] <= length <= min(LENGTHS_M[1], high - 0.03):  # neither nan
        hint = f"{100 * LENGTHS_M[0]:.0f} to {100 * min(LENGTHS_M[1], high - 0.03):.0f} cm hang clear of the floor"
        raise ClonerError(f"a {garment} of {100 * length:g} cm cannot be cut", hint, "--length")
    return draft(block, ring.girth_m, length), block.ring


def _motion(clone: Clone, motion: str) -> Motion:
    if motion == WALK:
        return own_motions(clone)[0]
    path = Path(motion)
    if path.suffix.lower() != ".bvh":
        raise ClonerError(f"the motion {motion!r} is not known", "Give walk, or a captured walk (.bvh)", "--motion")
    body = body_of(clone)
    return walk_cycle(body, retarget(read_bvh(path), body, name=path.stem))


class _Later(GltfBuffer):
    """A buffer that goes on where a finished file's ends."""

    def __init__(self, gltf: Any, before: bytes) -> None:
        super().__init__(gltf, np.zeros((2, 3)))
        self._chunks, self._length = [before], len(before)


def glb(found: Dressed) -> bytes:
    """Return the walking clone with its garment: a morph target a frame, shown in turn by the walk's own animation."""
    gltf = build(found.clone, moves=lambda _: (found.motion,))
    buffer, cloth, frames = _Later(gltf, gltf.binary_blob()), found.worn.cloth, found.loop.frames_m
    faces = cloth.faces.astype(np.int32)
    normals = np.array([vertex_normals(frame, faces) for frame in frames])
    points, turned = frames[:, cloth.vertex], normals[:, cloth.vertex]
    attributes = pygltflib.Attributes(
        POSITION=buffer.positions(points[0]), NORMAL=buffer.normals(turned[0]), TEXCOORD_0=buffer.uv(cloth.flat_m)
    )
    targets = [
        {
            "POSITION": buffer.positions(points[k] - points[0]),
            "NORMAL": buffer.attribute((turned[k] - turned[0]).astype(np.float32)),
        }
        for k in range(1, len(points))
    ]
    linear = [float((value / 255.0) ** 2.2) for value in found.fabric.rgb]
    look = pygltflib.PbrMetallicRoughness(baseColorFactor=[*linear, 1.0], metallicFactor=0.0, roughnessFactor=ROUGHNESS)
    gltf.materials.append(pygltflib.Material(name=found.fabric.name, pbrMetallicRoughness=look, doubleSided=True))
    primitive = pygltflib.Primitive(
        attributes=attributes, indices=buffer.indices(cloth.triangles.astype(np.int32)),
        material=len(gltf.materials) - 1, targets=targets,
    )  # fmt: skip
    gltf.meshes.append(pygltflib.Mesh(name="Garment", primitives=[primitive], weights=[0.0] * len(targets)))
    gltf.nodes.append(pygltflib.Node(name="Garment", mesh=len(gltf.meshes) - 1))
    gltf.scenes[0].nodes.append(len(gltf.nodes) - 1)
    _show_in_turn(gltf, buffer, len(points), float(found.motion.times_s[-1]), len(gltf.nodes) - 1)
    data = buffer.data()
    gltf.buffers[0].byteLength = len(data)
    gltf.set_binary_blob(data)
    return glb_bytes(gltf)


def _show_in_turn(gltf: Any, buffer: GltfBuffer, count: int, seconds: float, node: int) -> None:
    """Add to the first animation that one frame's target after the other is fully on; the first frame has none."""
    weights = np.zeros((count + 1, count - 1))
    weights[np.arange(1, count), np.arange(count - 1)] = 1.0
    times = buffer.values(np.arange(count + 1) / count * seconds, bounds=True)
    made = gltf.animations[0]
    output = buffer.values(weights.reshape(-1))
    made.samplers.append(pygltflib.AnimationSampler(input=times, output=output, interpolation="LINEAR"))
    target = pygltflib.AnimationChannelTarget(node=node, path="weights")
    made.channels.append(pygltflib.AnimationChannel(sampler=len(made.samplers) - 1, target=target))


def pictures(found: Dressed, turn_deg: float = 30.0) -> Iterator[NDArray[np.uint8]]:
    """Yield the loop's pictures."""
    camera = framing_camera(found.clone.vertices_m, turn_deg, *SIZE_PX)
    faces, colour = found.worn.cloth.faces.astype(np.int32), tuple(value / 255.0 for value in found.fabric.rgb)
    for frame, places in enumerate(found.loop.frames_m):
        shown = [
            replace(layer, vertices_m=layer.vertices_m + found.worn.root_m[frame])
            for layer in clone_layers(found.clone, found.worn.rotations[frame])
        ]
        normals = vertex_normals(places, faces)
        shown.append(Layer(places, normals, faces, colour=(colour[0], colour[1], colour[2]), two_sided=True))
        yield draw(shown, camera, shading="soft", background=(226, 228, 230))


__all__ = ["Dressed", "dress_file", "dressed", "glb", "pictures"]
