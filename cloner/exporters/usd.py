"""USDZ: skeleton, skin, face targets and an idle in one file for AR on iPhones and iPads.

Phones take only binary layers, which the maintained library writes; it is an extra (``pip install photo-cloner[usd]``).
Metres, +Y up, facing +Z.

References
----------
OpenUSD, UsdSkel (skeletons, blend shapes), UsdPreviewSurface; usdz file format specification 1.3 (stored zip, every
file on 64 bytes).
"""

from __future__ import annotations

import importlib
import io
import tempfile
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np

from cloner.errors import ClonerError
from cloner.exporters.gltf.gltf_motion import quaternions
from cloner.exporters.gltf.gltf_targets import turned_normals
from cloner.exporters.hanim.hanim_names import identifier, node_name
from cloner.exporters.shared.credits import CREDITS
from cloner.exporters.shared.files import png_bytes, write_bytes
from cloner.exporters.shared.pictures import picture_bytes
from cloner.exporters.shared.roughness import roughness_map, shell_shine
from cloner.exporters.vrml.vrml_segments import SMALLEST_OFFSET_M, SkinMesh, skin_meshes
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.morphs import wedge_offsets
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import Moves, own_motions
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

#: Bytes at whose multiples a USDZ's files begin (its specification).
ALIGNMENT: Final = 64
_EPOCH: Final = (1980, 1, 1, 0, 0, 0)  # the oldest date that a zip can tell: the same clone gives the same bytes
_ATLAS, _ROUGH = "_atlas.jpg", "_roughness.png"
_ROOT, _SKELETON = "/clone", "/clone/skeleton"


def idle_first(clone: Clone) -> Sequence[Motion]:
    """Return the clone's own motions, the idle before the walk: what stands in a room does not walk on the spot."""
    walk, idle = own_motions(clone)
    return idle, walk


def export(clone: Clone, folder: Path, *, name: str = "clone", moves: Moves = idle_first) -> tuple[Path, ...]:
    """Write ``<name>.usdz`` and return its path.

    Raises
    ------
    ClonerError
        If the library is not installed or the folder cannot be written to.
    """
    pxr = usd_library()
    pictures = picture_bytes(clone, name)
    atlas = f"textures/{name}{_ATLAS}"
    pictures[atlas] = jpeg_with_comment(pictures[atlas], clone.stamp)  # layers are compressed: here anybody can read it
    if len(clone.triangle_regions):
        pictures[f"textures/{name}{_ROUGH}"] = png_bytes(roughness_map(clone))
    with tempfile.TemporaryDirectory() as scratch:
        layer = Path(scratch) / f"{name}.usdc"
        _stage(pxr, centre_joints(clone), name, layer, moves)
        content = layer.read_bytes()
    path = folder / f"{name}.usdz"
    write_bytes(path, stored_zip({layer.name: content, **pictures}))
    return (path,)


def jpeg_with_comment(jpeg: bytes, text: str) -> bytes:
    """Return a JPEG with a comment segment at its beginning."""
    comment = text.encode()
    return jpeg[:2] + b"\xff\xfe" + (len(comment) + 2).to_bytes(2, "big") + comment + jpeg[2:]


def usd_library() -> Any:
    """Return the USD library.

    Raises
    ------
    ClonerError
        If it is not installed.
    """
    try:
        parts = ("Gf", "Sdf", "Usd", "UsdGeom", "UsdShade", "UsdSkel", "Vt")
        return type("Pxr", (), {part: importlib.import_module(f"pxr.{part}") for part in parts})
    except ImportError as error:
        hint = "Install it with: pip install 'photo-cloner[usd]'"
        raise ClonerError("USD needs a library that is not here", hint, "usd-core") from error


def stored_zip(files: Mapping[str, bytes]) -> bytes:
    """Return a zip of stored files, each aligned to 64 bytes, the first file first."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_STORED) as archive:
        for file, content in files.items():
            entry = zipfile.ZipInfo(file, _EPOCH)
            head = stream.tell() + 30 + len(file.encode()) + 4  # a local header, the name, an extra field's own head
            entry.extra = b"\x86\x19" + (gap := -head % ALIGNMENT).to_bytes(2, "little") + bytes(gap)
            archive.writestr(entry, content)
    return stream.getvalue()


def _stage(pxr: Any, clone: Clone, name: str, path: Path, moves: Moves) -> None:
    """Write the layer with everything but the pictures."""
    generic, motion = load_generic(), moves(clone)[0]
    motion = replace(motion, name=node_name(motion.name))
    stage = pxr.Usd.Stage.CreateNew(str(path))
    pxr.UsdGeom.SetStageUpAxis(stage, pxr.UsdGeom.Tokens.y)
    pxr.UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    stage.SetTimeCodesPerSecond(round(1.0 / float(np.diff(motion.times_s).mean()), 3))
    stage.SetStartTimeCode(0.0)
    stage.SetEndTimeCode(len(motion.times_s) - 1.0)
    stage.GetRootLayer().comment = f"{CREDITS} {clone.stamp}"
    stage.SetDefaultPrim(pxr.UsdSkel.Root.Define(stage, _ROOT).GetPrim())
    paths = _joint_paths(generic)
    _skeleton(pxr, stage, clone, paths, motion.name)
    _animation(pxr, stage, clone, motion, paths)
    for number, mesh in enumerate(skin_meshes(clone, generic, name)):
        _mesh(pxr, stage, clone, mesh, f"{mesh.name}_{number}")
    stage.GetRootLayer().Save()


def _joint_paths(generic: GenericHuman) -> list[str]:
    """Return every joint's name behind those of all joints above it."""
    paths: list[str] = []
    for joint, parent in zip(generic.joint_names, generic.joint_parents, strict=True):
        paths.append(f"{paths[parent]}/{joint}" if parent >= 0 else joint)
    return paths


def _skeleton(pxr: Any, stage: Any, clone: Clone, paths: list[str], plays: str) -> None:
    skeleton = pxr.UsdSkel.Skeleton.Define(stage, _SKELETON)
    parents = load_generic().joint_parents
    origin = np.where((parents >= 0)[:, None], clone.joints_m[parents], 0.0)
    skeleton.CreateJointsAttr(paths)
    skeleton.CreateBindTransformsAttr(_moves(pxr, clone.joints_m))
    skeleton.CreateRestTransformsAttr(_moves(pxr, clone.joints_m - origin))
    binding = pxr.UsdSkel.BindingAPI.Apply(skeleton.GetPrim())
    binding.CreateAnimationSourceRel().SetTargets([pxr.Sdf.Path(f"{_SKELETON}/{plays}")])


def _moves(pxr: Any, places_m: Array) -> Any:
    """Return translations as matrices; rows are vectors there."""
    return pxr.Vt.Matrix4dArray(
        [pxr.Gf.Matrix4d(1.0).SetTranslate(pxr.Gf.Vec3d(*place.tolist())) for place in places_m]
    )


def _animation(pxr: Any, stage: Any, clone: Clone, motion: Motion, paths: list[str]) -> None:
    made = pxr.UsdSkel.Animation.Define(stage, f"{_SKELETON}/{motion.name}")
    parents = load_generic().joint_parents
    offsets = clone.joints_m - np.where((parents >= 0)[:, None], clone.joints_m[parents], 0.0)
    root = int(np.flatnonzero(parents < 0)[0])
    made.CreateJointsAttr(paths)
    made.CreateScalesAttr(pxr.Vt.Vec3hArray(len(paths), pxr.Gf.Vec3h(1.0, 1.0, 1.0)))
    made.CreateBlendShapesAttr(list(motion.weights))
    turns, moves, shapes = made.CreateRotationsAttr(), made.CreateTranslationsAttr(), made.CreateBlendShapeWeightsAttr()
    values = np.stack([quaternions(motion.rotations[:, joint]) for joint in range(len(paths))], axis=1)
    for frame, quats in enumerate(values):
        own = offsets.copy()
        own[root] += motion.root_m[frame]
        turns.Set(pxr.Vt.QuatfArray([pxr.Gf.Quatf(w, x, y, z) for x, y, z, w in quats.tolist()]), frame)
        moves.Set(pxr.Vt.Vec3fArray.FromNumpy(own.astype(np.float32)), frame)
        shapes.Set([float(weights[frame]) for weights in motion.weights.values()], frame)


def _mesh(pxr: Any, stage: Any, clone: Clone, mesh: SkinMesh, name: str) -> None:
    """Define one mesh with its skin, its material and the targets that move it."""
    made = pxr.UsdGeom.Mesh.Define(stage, f"{_ROOT}/{name}")
    vec3 = pxr.Vt.Vec3fArray.FromNumpy
    points = mesh.vertices_m.astype(np.float32)
    made.CreatePointsAttr(vec3(points))
    made.CreateExtentAttr(vec3(np.array([points.min(axis=0), points.max(axis=0)])))
    made.CreateFaceVertexCountsAttr(pxr.Vt.IntArray(len(mesh.triangles), 3))
    made.CreateFaceVertexIndicesAttr(pxr.Vt.IntArray.FromNumpy(mesh.triangles.reshape(-1).astype(np.int32)))
    made.CreateNormalsAttr(vec3(mesh.normals.astype(np.float32)))
    made.SetNormalsInterpolation(pxr.UsdGeom.Tokens.vertex)
    made.CreateSubdivisionSchemeAttr(pxr.UsdGeom.Tokens.none)
    made.CreateDoubleSidedAttr(mesh.two_sided)
    uv = (mesh.uv * [1.0, -1.0] + [0.0, 1.0]).astype(np.float32)  # USD counts t upwards
    primvars = pxr.UsdGeom.PrimvarsAPI(made)
    st = primvars.CreatePrimvar("st", pxr.Sdf.ValueTypeNames.TexCoord2fArray, pxr.UsdGeom.Tokens.vertex)
    st.Set(pxr.Vt.Vec2fArray.FromNumpy(uv))
    binding = pxr.UsdSkel.BindingAPI.Apply(made.GetPrim())
    binding.CreateSkeletonRel().SetTargets([pxr.Sdf.Path(_SKELETON)])
    width = mesh.skin_joints.shape[1]
    share = mesh.skin_weights.astype(np.float64)
    share = (share / share.sum(axis=1, keepdims=True)).astype(np.float32)
    joints = mesh.skin_joints.astype(np.int32).reshape(-1)
    binding.CreateJointIndicesPrimvar(False, width).Set(pxr.Vt.IntArray.FromNumpy(joints))
    binding.CreateJointWeightsPrimvar(False, width).Set(pxr.Vt.FloatArray.FromNumpy(share.reshape(-1)))
    binding.CreateGeomBindTransformAttr(pxr.Gf.Matrix4d(1.0))
    _targets(pxr, stage, clone, mesh, name, binding)
    pxr.UsdShade.MaterialBindingAPI.Apply(made.GetPrim()).Bind(_material(pxr, stage, clone, mesh))


def _targets(pxr: Any, stage: Any, clone: Clone, mesh: SkinMesh, name: str, binding: Any) -> None:
    """Define the targets that move a mesh and turn its normals."""
    names, paths, vec3 = [], [], pxr.Vt.Vec3fArray.FromNumpy
    for (target, moved, offsets_m), (turned, differences) in zip(
        wedge_offsets(clone, mesh.vertex, SMALLEST_OFFSET_M), turned_normals(clone, mesh.vertex), strict=True
    ):
        if len(moved):
            path = f"{_ROOT}/{name}/{identifier(target)}"
            shape, rows = pxr.UsdSkel.BlendShape.Define(stage, path), np.union1d(moved, turned)
            for create, at, values in (
                (shape.CreateOffsetsAttr, moved, offsets_m),
                (shape.CreateNormalOffsetsAttr, turned, differences),
            ):
                laid = np.zeros((len(rows), 3), np.float32)
                laid[np.searchsorted(rows, at)] = values
                create(vec3(laid))
            shape.CreatePointIndicesAttr(pxr.Vt.IntArray.FromNumpy(rows.astype(np.int32)))
            names.append(target)
            paths.append(pxr.Sdf.Path(path))
    if names:
        binding.CreateBlendShapesAttr(names)
        binding.CreateBlendShapeTargetsRel().SetTargets(paths)


def _material(pxr: Any, stage: Any, clone: Clone, mesh: SkinMesh) -> Any:
    """Define a material with the mesh's picture, cut out where that is clear, as rough as its regions are."""
    place = f"{_ROOT}/looks/{mesh.name}"
    kinds = pxr.Sdf.ValueTypeNames
    material = pxr.UsdShade.Material.Define(stage, place)
    surface, picture, reader = (
        pxr.UsdShade.Shader.Define(stage, f"{place}/{part}") for part in ("surface", "picture", "reader")
    )
    reader.CreateIdAttr("UsdPrimvarReader_float2")
    reader.CreateInput("varname", kinds.String).Set("st")
    st = reader.CreateOutput("result", kinds.Float2)
    _picture(pxr, picture, mesh.picture, "sRGB", st)
    surface.CreateIdAttr("UsdPreviewSurface")
    rough, metal = surface.CreateInput("roughness", kinds.Float), surface.CreateInput("metallic", kinds.Float)
    if mesh.picture.endswith(_ATLAS) and len(clone.triangle_regions):
        map_ = pxr.UsdShade.Shader.Define(stage, f"{place}/roughness")
        _picture(pxr, map_, mesh.picture.removesuffix(_ATLAS) + _ROUGH, "raw", st)
        rough.ConnectToSource(map_.CreateOutput("g", kinds.Float))
        if clone.atlas.shine.size:
            metal.ConnectToSource(map_.CreateOutput("b", kinds.Float))
        else:
            metal.Set(0.0)
            dark = surface.CreateInput("occlusion", kinds.Float)
            dark.ConnectToSource(map_.CreateOutput("r", kinds.Float))
    else:
        for value, shine in zip((rough, metal), shell_shine(clone, 0.85), strict=True):
            value.Set(shine)
    surface.CreateInput("diffuseColor", kinds.Color3f).ConnectToSource(picture.CreateOutput("rgb", kinds.Float3))
    if mesh.two_sided:
        surface.CreateInput("opacity", kinds.Float).ConnectToSource(picture.CreateOutput("a", kinds.Float))
        surface.CreateInput("opacityThreshold", kinds.Float).Set(0.4)
    material.CreateSurfaceOutput().ConnectToSource(surface.ConnectableAPI(), "surface")
    return material


def _picture(pxr: Any, shader: Any, file: str, space: str, st: Any) -> None:
    """Make a shader read a picture of the file at the mesh's texture coordinates."""
    kinds = pxr.Sdf.ValueTypeNames
    shader.CreateIdAttr("UsdUVTexture")
    shader.CreateInput("file", kinds.Asset).Set(pxr.Sdf.AssetPath(f"textures/{file}"))
    shader.CreateInput("sourceColorSpace", kinds.Token).Set(space)
    shader.CreateInput("st", kinds.Float2).ConnectToSource(st)
