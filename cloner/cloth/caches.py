"""Point caches of a simulated garment: PC2 with OBJ, USD with a time sample per frame, and VAT.

References
----------
PC2: the point cache of 3ds Max and Blender, read off Blender's documentation of its Mesh Cache modifier: a head of
32 bytes (name, version 1, points, first frame, frames a sample, samples), then 32-bit floats.
"""

from __future__ import annotations

import struct
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner import __version__
from cloner.cloth.dressing import DressedClone
from cloner.cloth.glb import ROUGHNESS
from cloner.cloth.simulation.wearer import FRAMES_PER_S
from cloner.exporters.gltf.gltf_buffer import GltfBuffer
from cloner.exporters.shared.credits import CREDITS
from cloner.exporters.usd import usd_library
from cloner.exporters.vat import columns, mesh_glb, vat_pictures
from cloner.geometry.meshes.wedges import vertex_normals


def _closed_frames_m(found: DressedClone) -> NDArray[np.float64]:
    """Return (F + 1, N, 3) the loop's frames and the first again, metres."""
    return np.concatenate([found.loop.frames_m, found.loop.frames_m[:1]])


def pc2(found: DressedClone) -> bytes:
    """Return the outermost garment's vertices in every frame of the loop; the last repeats the first."""
    frames = _closed_frames_m(found).astype("<f4")
    return struct.pack("<12siiffi", b"POINTCACHE2\0", 1, frames.shape[1], 0.0, 1.0, len(frames)) + frames.tobytes()


def obj(found: DressedClone) -> bytes:
    """Return the garment's mesh in the first frame: the cache's order of vertices, flat pieces' metres as texture."""
    cloth = found.worn.cloth
    lines = [f"# {found.fabric.name}, metres, Y up", "o Garment"]
    lines += [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in found.loop.frames_m[0]]
    lines += [f"vt {u:.6f} {v:.6f}" for u, v in cloth.flat_m]
    own = cloth.faces + 1
    lines += [
        "f " + " ".join(f"{vertex}/{place}" for vertex, place in zip(face, flat, strict=True))
        for face, flat in zip(own.tolist(), (cloth.triangles + 1).tolist(), strict=True)
    ]
    return ("\n".join(lines) + "\n").encode()


def vat(found: DressedClone) -> dict[str, bytes]:
    """Return the outermost garment as a vertex animation texture: picture, remap file and mesh by their names' ends."""
    cloth, frames = found.worn.cloth, found.loop.frames_m
    faces = cloth.faces.astype(np.int32)
    points = frames[:, cloth.vertex]
    normals = np.array([vertex_normals(frame, faces) for frame in frames])[:, cloth.vertex]
    walk = {"startFrame": 0, "endFrame": len(frames) - 1, "framerate": FRAMES_PER_S, "looping": True}
    files = vat_pictures(points[0], points, normals, {found.motion.name: walk})
    gltf = pygltflib.GLTF2(
        asset=pygltflib.Asset(version="2.0", generator=f"Cloner {__version__}", copyright=CREDITS), scene=0
    )
    buffer = GltfBuffer(gltf, np.zeros((2, 3)))
    look = pygltflib.PbrMetallicRoughness(
        baseColorFactor=[*found.fabric.linear_rgb(), 1.0], metallicFactor=0.0, roughnessFactor=ROUGHNESS
    )
    gltf.materials.append(pygltflib.Material(name=found.fabric.name, pbrMetallicRoughness=look, doubleSided=True))
    attributes = pygltflib.Attributes(
        POSITION=buffer.positions(points[0]), NORMAL=buffer.normals(normals[0]), TEXCOORD_0=buffer.uv(cloth.flat_m),
        TEXCOORD_1=buffer.uv(columns(points.shape[1], len(points))),
    )  # fmt: skip
    triangles = buffer.indices(cloth.triangles.astype(np.int32))
    primitive = pygltflib.Primitive(attributes=attributes, indices=triangles, material=0)
    return files | {".glb": mesh_glb(gltf, buffer, primitive, "Garment", "Garment")}


def usd(found: DressedClone) -> bytes:
    """Return a USD file (binary) of all garments: a mesh each, with points at every frame.

    Raises
    ------
    ClonerError
        If the USD library is not installed.
    """
    pxr = usd_library()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "garment.usdc"
        stage = pxr.Usd.Stage.CreateNew(str(path))
        pxr.UsdGeom.SetStageUpAxis(stage, pxr.UsdGeom.Tokens.y)
        pxr.UsdGeom.SetStageMetersPerUnit(stage, 1.0)
        stage.SetStartTimeCode(0.0)
        stage.SetEndTimeCode(float(len(found.loop.frames_m)))
        stage.SetTimeCodesPerSecond(float(FRAMES_PER_S))
        for number, one in enumerate(found.layers, start=1):
            _add_mesh(pxr, stage, one, "Garment" if number == 1 else f"Garment_{number}")
        stage.SetDefaultPrim(stage.GetPrimAtPath("/Garment"))
        stage.GetRootLayer().Save()
        del stage
        return path.read_bytes()


def _add_mesh(pxr: Any, stage: Any, one: DressedClone, name: str) -> None:
    """Add a garment's mesh with its points in every frame."""
    cloth, frames = one.worn.cloth, _closed_frames_m(one)
    mesh = pxr.UsdGeom.Mesh.Define(stage, f"/{name}")
    mesh.CreateSubdivisionSchemeAttr(pxr.UsdGeom.Tokens.none)
    mesh.CreateDoubleSidedAttr(True)
    mesh.CreateFaceVertexCountsAttr(pxr.Vt.IntArray.FromNumpy(np.full(len(cloth.faces), 3, np.int32)))
    mesh.CreateFaceVertexIndicesAttr(pxr.Vt.IntArray.FromNumpy(cloth.faces.ravel().astype(np.int32)))
    places = pxr.UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
        "st", pxr.Sdf.ValueTypeNames.TexCoord2fArray, pxr.UsdGeom.Tokens.faceVarying
    )
    places.Set(pxr.Vt.Vec2fArray.FromNumpy(cloth.flat_m[cloth.triangles.ravel()].astype(np.float32)))
    mesh.CreateDisplayColorAttr([pxr.Gf.Vec3f(*one.fabric.linear_rgb())])
    points, box = mesh.CreatePointsAttr(), mesh.CreateExtentAttr()
    for number, frame in enumerate(frames.astype(np.float32)):
        points.Set(pxr.Vt.Vec3fArray.FromNumpy(frame), float(number))
        box.Set([pxr.Gf.Vec3f(*map(float, end)) for end in (frame.min(axis=0), frame.max(axis=0))], float(number))
