"""Run in a Python of its own: opens one file with one reader and tells, as JSON, how much of it is there.

Lengths are in metres where the file has metres; what a reader does not know is left out.
"""

import json
import sys

program, path = sys.argv[1:]


def with_open3d():
    import open3d

    parts = [part.mesh for part in open3d.io.read_triangle_model(path).meshes]
    parts = parts or [open3d.io.read_triangle_mesh(path)]  # plain surfaces are no models there
    low, high = min(part.get_min_bound()[1] for part in parts), max(part.get_max_bound()[1] for part in parts)
    return {"meshes": len(parts), "vertices": sum(len(part.vertices) for part in parts), "height_m": high - low}


def with_assimp_py():
    import assimp_py

    parts = assimp_py.import_file(path, assimp_py.Process_Triangulate).meshes
    ups = [list(part.vertices)[1::3] for part in parts]
    height = max(map(max, ups)) - min(map(min, ups))
    return {"meshes": len(ups), "vertices": sum(map(len, ups)), "height_m": height}


def with_trimesh():
    import trimesh

    scene = trimesh.load(path, force="scene", process=False)
    meshes = list(scene.geometry.values())
    return {"meshes": len(meshes), "vertices": sum(len(mesh.vertices) for mesh in meshes),
            "height_m": float(scene.extents[1])}  # fmt: skip


def with_pygltflib():
    import pygltflib

    gltf = pygltflib.GLTF2().load(path) if path.endswith(".gltf") else pygltflib.GLTF2().load_binary(path)
    targets = max((len(part.targets or []) for mesh in gltf.meshes for part in mesh.primitives), default=0)
    joints = max((len(skin.joints) for skin in gltf.skins), default=0)
    return {"meshes": sum(len(mesh.primitives) for mesh in gltf.meshes), "joints": joints,
            "clips": len(gltf.animations), "targets": targets}  # fmt: skip


def with_pxr():
    from pxr import Usd, UsdGeom, UsdSkel

    stage = Usd.Stage.Open(path)
    prims = list(stage.Traverse())
    box = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default", "render"]).ComputeWorldBound(stage.GetPseudoRoot())
    size = box.ComputeAlignedRange().GetSize()
    unit = UsdGeom.GetStageMetersPerUnit(stage)
    joints = [len(UsdSkel.Skeleton(one).GetJointsAttr().Get()) for one in prims if one.IsA(UsdSkel.Skeleton)]
    return {
        "meshes": sum(one.IsA(UsdGeom.Mesh) for one in prims),
        "joints": max(joints, default=0),
        "clips": sum(one.IsA(UsdSkel.Animation) for one in prims),
        "targets": len({one.GetName() for one in prims if one.IsA(UsdSkel.BlendShape)}),
        "height_m": size[1 if UsdGeom.GetStageUpAxis(stage) == "Y" else 2] * unit,
    }


readers = {"open3d": with_open3d, "assimp_py": with_assimp_py, "trimesh": with_trimesh, "pygltflib": with_pygltflib,
           "pxr": with_pxr}  # fmt: skip
sys.stdout.write(f"SEEN {json.dumps(readers[program]())}\n")
