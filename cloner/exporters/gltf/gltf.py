"""A clone as one binary glTF 2.0 file: skinned, with morph targets, textures, and animations.

Metres, +Y up, facing +Z. Scene: the node "Armature" holds the 94 H-Anim
joints; the skinned nodes "Body", "Hair" and "Cloth" stand beside it, because glTF
ignores the parents of skinned meshes and the validator warns of any. A beard is a primitive of the body: what
moves the face moves it too.

References
----------
Khronos Group 2021, glTF 2.0 specification, sections 3.6 (accessors), 3.7
(meshes, skins, morph targets) and 3.9 (materials).
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner import __version__
from cloner.exporters.gltf.glb_file import glb_bytes
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.exporters.gltf.gltf_eyes import eyes_with_depth
from cloner.exporters.gltf.gltf_motion import animation
from cloner.exporters.gltf.gltf_targets import targets_of
from cloner.exporters.shared.bones import Bones, hanim_bones
from cloner.exporters.shared.credits import CREDITS
from cloner.exporters.shared.files import jpeg_bytes, png_bytes, write_bytes
from cloner.exporters.shared.roughness import roughness_map, shell_shine
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces, surface_normals
from cloner.geometry.meshes.wedges import welded_normals
from cloner.motion.flesh.correctives import Driver, drive_correctives, with_correctives
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import Moves, own_motions
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.heads import SHELL_KINDS, Shell

_ROUGHNESS: Final = {"body": 0.85, "eyes": 0.15, "mouth": 0.45, "lashes": 0.9}  # taste; wet things shine
_LOOSE: Final = 0.9  # roughness of hair and loose cloth; taste
_HAIR_CUTOFF: Final = 0.4  # taste: strands stay closed when seen from afar
_REPEAT, _LINEAR, _TRILINEAR = 10497, 9729, 9987  # the numbers GL gives them


def export(clone: Clone, folder: Path, *, name: str = "clone", moves: Moves = own_motions) -> tuple[Path, ...]:
    """Write ``<name>.glb`` with its motions, and return its path.

    Parameters
    ----------
    clone : Clone
    folder : Path
    name : str
    moves : callable
        Makes the file's motions for the clone with the joints and rest pose that it leaves with, the first one first.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    path = folder / f"{name}.glb"
    write_bytes(path, glb_bytes(build(centre_joints(clone), moves=moves, corrects=True, shades=True)))
    return (path,)


def build(
    clone: Clone,
    *,
    moves: Moves = own_motions,
    bones: Bones | None = None,
    corrects: bool = False,
    shades: bool = False,
    buffer_type: Callable[[Any, Array], GltfBuffer] = GltfBuffer,
) -> Any:
    """Return the clone as a ``pygltflib.GLTF2`` with its binary blob set.

    Parameters
    ----------
    clone : Clone
        With the joints it is to leave with.
    moves : callable
        Makes the motions of this clone; walk and idle unless told otherwise.
    bones : Bones or None
        The file's skeleton; None takes all H-Anim joints.
    corrects : bool
        Add corrective targets, which keep the flesh around bent joints, and let the motions drive them.
    shades : bool
        Let normals turn with the face's targets, so that the light follows.
    buffer_type : callable
        Makes the buffer of a file and its box (2, 3): how numbers are stored.
    """
    bones, motions = bones or hanim_bones(), moves(clone)
    drivers: tuple[Driver, ...] = ()
    if corrects:
        clone, drivers = with_correctives(clone)
    gltf = pygltflib.GLTF2(
        asset=pygltflib.Asset(version="2.0", generator=f"Cloner {__version__}", copyright=CREDITS),
        scene=0,
    )
    gltf.extensionsUsed = []
    buffer = buffer_type(gltf, _box(clone))
    skin = add_skeleton(gltf, buffer, clone, bones)
    roots = [0]
    gltf.samplers.append(pygltflib.Sampler(magFilter=_LINEAR, minFilter=_TRILINEAR, wrapS=_REPEAT, wrapT=_REPEAT))
    for mesh in (
        _body(gltf, buffer, clone, bones, shades=shades),
        *(_loose(gltf, buffer, clone, bones, kind) for kind in SHELL_KINDS),
    ):
        if mesh is not None:
            gltf.meshes.append(mesh)
            gltf.nodes.append(pygltflib.Node(name=mesh.name, mesh=len(gltf.meshes) - 1, skin=skin))
            roots.append(len(gltf.nodes) - 1)
    body = next(number for number, node in enumerate(gltf.nodes) if node.mesh == 0)
    for motion in motions:
        gltf.animations.append(animation(buffer, clone, drive_correctives(motion, drivers), bones, body))
    facts = _facts(clone, bones)
    if drivers:
        facts["correctives"] = [driver.told(bones.name_of(driver.joint)) for driver in drivers]
    gltf.scenes.append(pygltflib.Scene(name="clone", nodes=roots, extras=facts))
    data = buffer.data()
    gltf.buffers.append(pygltflib.Buffer(byteLength=len(data)))
    gltf.set_binary_blob(data)
    return gltf


def _facts(clone: Clone, bones: Bones) -> dict[str, Any]:
    """Return what a reader should know and glTF has no field for."""
    return {
        "generator": f"Cloner {__version__}",
        "stamp": clone.stamp,
        "units": "metre",
        "up": "+Y",
        "front": "+Z",
        "stature_m": round(clone.stature_m, 5),
        "sole_m": round(clone.sole_m, 5),
        "skeleton": f"{bones.title}, {len(bones.names)} joints",
        "features_m": {key: [round(float(x), 5) for x in point] for key, point in clone.features_m.items()},
        "measures_mm": dict(clone.measures_mm),
        "consent": "recorded" if clone.consent else "not recorded",
        "licence": clone.terms.licence or "none",
        "credits": CREDITS,
    }


def _box(clone: Clone) -> Array:
    """Return (2, 3) the lowest and the highest corner of all vertices, metres."""
    points = np.vstack([clone.vertices_m, *(shell.vertices_m for shell in clone.shells)])
    return np.array([points.min(axis=0), points.max(axis=0)])


def add_skeleton(gltf: Any, buffer: GltfBuffer, clone: Clone, bones: Bones, free: int = 0) -> int:
    """Add "Armature" as node 0 of an empty file with the bones below it, and return the skin.

    After the skeleton's come so many ``free`` bones, at the origin at rest, which hang on none.
    """
    parents, places = bones.parents, clone.joints_m[bones.joints]
    gltf.nodes.append(pygltflib.Node(name="Armature", children=[1 + int(np.flatnonzero(parents < 0)[0])]))
    for bone, (name, parent) in enumerate(zip(bones.names, parents, strict=True)):
        origin = places[parent] if parent >= 0 else np.zeros(3)
        children = [1 + int(child) for child in np.flatnonzero(parents == bone)]
        gltf.nodes.append(pygltflib.Node(name=name, translation=(places[bone] - origin).tolist(), children=children))
    for number in range(free):
        gltf.nodes.append(pygltflib.Node(name=f"Cloth {number + 1}"))
        gltf.nodes[0].children.append(len(gltf.nodes) - 1)
    inverse = np.tile(np.eye(4), (len(parents) + free, 1, 1))
    inverse[: len(parents), :3, 3] = -places
    joints = list(range(1, 1 + len(parents) + free))
    gltf.skins.append(
        pygltflib.Skin(name=bones.title, skeleton=0, joints=joints, inverseBindMatrices=buffer.bind(inverse))
    )
    return len(gltf.skins) - 1


def _body(gltf: Any, buffer: GltfBuffer, clone: Clone, bones: Bones, *, shades: bool) -> Any:
    """Return the body's mesh: one primitive a surface, the same morph targets on all; ``shades`` turns normals."""
    generic = load_generic()
    atlas = add_texture(gltf, buffer, jpeg_bytes(clone.atlas.rgb), "image/jpeg", "atlas")
    normals = surface_normals(clone.vertices_m)
    primitives = []
    of_stone = bool(clone.atlas.shine.size)
    for surface in load_surfaces():
        texture, mode, shape, lit = atlas, "OPAQUE", clone, normals[surface.vertex]
        if surface.name == "eyes" and not of_stone:  # a statue's pupils are drilled
            surface, shape, lit = eyes_with_depth(clone, normals)
        if surface.rgba is not None:
            texture, mode = add_texture(gltf, buffer, png_bytes(surface.rgba), "image/png", surface.name), "BLEND"
        attributes = _attributes(
            buffer,
            shape.vertices_m[surface.vertex],
            lit,
            surface.uv,
            bones.carried(generic.skin_joints[surface.vertex], generic.skin_weights[surface.vertex]),
        )
        primitives.append(
            pygltflib.Primitive(
                attributes=attributes,
                indices=buffer.indices(surface.triangles),
                material=_material(gltf, surface.name, texture, mode, _ROUGHNESS[surface.name]),
                targets=targets_of(buffer, shape, surface.vertex, turns_of=clone if shades else None),
            )
        )
    for number, shell in enumerate(shell for shell in clone.shells if len(shell.rides)):
        primitives.append(_shell(gltf, buffer, bones, shell, number, shell_shine(clone, _LOOSE)))
        primitives[-1].targets = targets_of(buffer, clone, shell.rides)
    if len(clone.triangle_regions):
        # The skin's own material, the first: skin, cloth and shoes shine each in their way. A statue is all of a piece.
        rough = add_texture(gltf, buffer, png_bytes(roughness_map(clone)), "image/png", "roughness")
        # What no photo shows, the mouth, stands in its own dark; without it every reader's sky shines in there.
        for surface, primitive in zip(load_surfaces(), primitives, strict=False):
            if surface.name == "body" or (of_stone and surface.rgba is None):
                look = gltf.materials[primitive.material].pbrMetallicRoughness
                look.metallicRoughnessTexture, look.roughnessFactor = pygltflib.TextureInfo(index=rough), 1.0
                look.metallicFactor = 1.0 if of_stone else 0.0
            if surface.name in ("body", "mouth") and not of_stone:
                gltf.materials[primitive.material].occlusionTexture = pygltflib.OcclusionTextureInfo(index=rough)
    mesh = pygltflib.Mesh(name="Body", primitives=primitives)
    if clone.morph_names:
        mesh.extras = {"targetNames": list(clone.morph_names)}
        mesh.weights = [0.0] * len(clone.morph_names)
    return mesh


def _loose(gltf: Any, buffer: GltfBuffer, clone: Clone, bones: Bones, kind: str) -> Any:
    """Return the mesh of all shells of a kind that do not ride on the body, or None for a person without any."""
    shells = [shell for shell in clone.shells if shell.kind == kind and not len(shell.rides)]
    if not shells:
        return None
    return pygltflib.Mesh(
        name=kind.capitalize(),
        primitives=[
            _shell(gltf, buffer, bones, shell, k, shell_shine(clone, _LOOSE)) for k, shell in enumerate(shells)
        ],
    )


def _shell(gltf: Any, buffer: GltfBuffer, bones: Bones, shell: Shell, number: int, shine: tuple[float, float]) -> Any:
    name = shell.kind if number == 0 else f"{shell.kind}_{number}"
    texture = add_texture(gltf, buffer, png_bytes(shell.rgba), "image/png", name)
    normals = welded_normals(shell.vertices_m, shell.triangles)
    carried = bones.carried(shell.skin_joints, shell.skin_weights)
    attributes = _attributes(buffer, shell.vertices_m, normals, shell.uv, carried)
    return pygltflib.Primitive(
        attributes=attributes,
        indices=buffer.indices(shell.triangles),
        material=_material(gltf, name, texture, "MASK", *shine),
    )


def _attributes(
    buffer: GltfBuffer,
    vertices_m: Array,
    normals: Array,
    uv: Array,
    carried: tuple[NDArray[np.int64], Array],
) -> Any:
    """Return the vertex attributes of one primitive; at most four influences a vertex."""
    joints, weights = buffer.skin(*carried)
    return pygltflib.Attributes(
        POSITION=buffer.positions(vertices_m),
        NORMAL=buffer.normals(normals / np.linalg.norm(normals, axis=1, keepdims=True)),
        TEXCOORD_0=buffer.uv(uv),
        JOINTS_0=joints,
        WEIGHTS_0=weights,
    )


def add_texture(gltf: Any, buffer: GltfBuffer, data: bytes, kind: str, name: str) -> int:
    """Add a picture to a glTF document and return its texture's number."""
    gltf.images.append(pygltflib.Image(name=name, mimeType=kind, bufferView=buffer.view(data)))
    gltf.textures.append(pygltflib.Texture(sampler=0, source=len(gltf.images) - 1, name=name))
    return len(gltf.textures) - 1


def _material(gltf: Any, name: str, texture: int, mode: str, roughness: float, metal: float = 0.0) -> int:
    material = pygltflib.Material(
        name=name,
        pbrMetallicRoughness=pygltflib.PbrMetallicRoughness(
            baseColorTexture=pygltflib.TextureInfo(index=texture), metallicFactor=metal, roughnessFactor=roughness
        ),
        alphaMode=mode,
        doubleSided=mode != "OPAQUE",
    )
    material.alphaCutoff = _HAIR_CUTOFF if mode == "MASK" else None
    gltf.materials.append(material)
    return len(gltf.materials) - 1
