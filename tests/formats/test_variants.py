"""The variants that other programs want: quantised, with Mixamo's bones, as USDZ, and VRML without prototypes."""

from __future__ import annotations

import io
import json
import re
import shutil
import subprocess
import sys
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pygltflib
import pytest
from PIL import Image

from cloner.errors import ClonerError
from cloner.exporters import usd
from cloner.exporters.avatars import mixamo
from cloner.exporters.gltf import gltf_small
from cloner.exporters.gltf.gltf import build
from cloner.exporters.vrml import vrml_flat
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.meshes.wedges import welded_normals
from cloner.motion.flesh.rest import in_t_pose
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.limbs.turns import joint_positions, world_from_local
from cloner.motion.moves.gait import idle, walk
from cloner.records.clones import Clone
from cloner.records.regions import REGIONS
from kit.clones import toy_clone
from kit.readers import HAS_DECODER, MODULES

VALIDATOR = Path(__file__).with_name("validate_gltf.mjs")
UNPACK = Path(__file__).with_name("unpack_glb.mjs")
THREE = pytest.mark.skipif(not HAS_DECODER, reason="needs node and three")
GENERIC = load_generic()
KINDS = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


@pytest.fixture(scope="module")
def clone() -> Clone:
    return centre_joints(toy_clone(1.64))


@pytest.fixture(scope="module")
def folder(clone, tmp_path_factory) -> Path:
    made = tmp_path_factory.mktemp("variants")
    for exporter in (gltf_small, mixamo, vrml_flat):
        exporter.export(clone, made)
    if HAS_DECODER:
        files = [made / "clone_small.glb", made / "clone_small_unpacked.glb"]
        subprocess.run(["node", UNPACK, MODULES, *files], check=True, timeout=120)
    return made


def rows(gltf, number: int) -> np.ndarray:
    """An accessor's values as floats: written from the specification, not from the exporter."""
    accessor = gltf.accessors[number]
    kind, width = np.dtype(KINDS[accessor.componentType]), WIDTHS[accessor.type]

    def packed(view: int, kind: np.dtype, count: int, width: int, offset: int | None = 0) -> np.ndarray:
        place = gltf.bufferViews[view]
        start = (place.byteOffset or 0) + (offset or 0)
        stride = place.byteStride or kind.itemsize * width
        data = np.frombuffer(gltf.binary_blob(), np.uint8, stride * count, start)
        return np.ascontiguousarray(data.reshape(count, stride)[:, : kind.itemsize * width]).view(kind)

    values = np.zeros((accessor.count, width), kind)
    if accessor.bufferView is not None:
        values = packed(accessor.bufferView, kind, accessor.count, width, accessor.byteOffset).copy()
    if accessor.sparse is not None:
        sparse = accessor.sparse
        at, new = sparse.indices, sparse.values
        index = packed(at.bufferView, np.dtype(KINDS[at.componentType]), sparse.count, 1, at.byteOffset)
        values[index[:, 0]] = packed(new.bufferView, kind, sparse.count, width, new.byteOffset)
    if not accessor.normalized:
        return values.astype(float)
    return np.maximum(values.astype(float) / np.iinfo(kind).max, -1.0)


def read(path: Path):
    return pygltflib.GLTF2().load_binary(str(path))


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here; run: npm install --prefix /tmp/cloner-node gltf-validator",
)
@pytest.mark.parametrize("name", ["clone_small.glb", "clone_small_unpacked.glb", "clone_mixamo.glb"])
def test_the_khronos_validator_finds_nothing(name: str, folder: Path) -> None:
    done = subprocess.run(
        ["node", VALIDATOR, MODULES, folder / name], capture_output=True, text=True, check=True, timeout=120
    )
    issues = json.loads(done.stdout)["issues"]
    unknown = {"UNSUPPORTED_EXTENSION"} if name == "clone_small.glb" else set()  # it knows no packed views
    assert {message["code"] for message in issues["messages"]} <= unknown
    assert issues["numErrors"] == issues["numWarnings"] == 0


@THREE
def test_the_small_file_is_a_quarter_as_large_and_the_same_person(folder: Path, clone: Clone) -> None:
    """Unpacked by three.js's decoder: with an arm bent and a smile vertices lie within half a millimetre."""
    small, full = read(folder / "clone_small_unpacked.glb"), build(clone)
    assert (folder / "clone_small.glb").stat().st_size < 0.3 * len(b"".join(full.save_to_bytes()))
    required = ["KHR_mesh_quantization", "EXT_texture_webp"]
    assert read(folder / "clone_small.glb").extensionsRequired == [*required, "EXT_meshopt_compression"]
    assert small.extensionsRequired == required
    assert {image.mimeType for image in small.images} == {"image/webp"}
    rotations = np.zeros((94, 3))
    rotations[GENERIC.joint("l_elbow")] = [0.0, 1.0, 0.2]
    found = []
    for gltf in (small, full):
        body = gltf.meshes[0].primitives[0]
        bind = rows(gltf, gltf.skins[0].inverseBindMatrices).reshape(-1, 4, 4).transpose(0, 2, 1)
        world = joint_transforms(clone.joints_m, GENERIC.joint_parents, rotations)
        rest = np.tile(np.eye(4), (94, 1, 1))
        rest[:, :3, 3] = clone.joints_m
        joints = rows(gltf, body.attributes.JOINTS_0).astype(int)
        weights = rows(gltf, body.attributes.WEIGHTS_0)
        assert weights.sum(axis=1) == pytest.approx(1.0, abs=1e-6)
        points = rows(gltf, body.attributes.POSITION)
        smile = gltf.meshes[0].extras["targetNames"].index("mouthSmileLeft")
        points = points + rows(gltf, body.targets[smile]["POSITION"])
        own = np.einsum("vk,vkab->vab", weights, (world @ rest @ bind)[joints])
        found.append(np.einsum("vab,vb->va", own, np.column_stack([points, np.ones(len(points))]))[:, :3])
    # weights of one byte move what hangs half on a bent arm by some tenths of a millimetre
    assert np.percentile(np.linalg.norm(found[0] - found[1], axis=1), 99) < 0.0005
    assert np.linalg.norm(found[0] - found[1], axis=1).max() < 0.002


def test_mixamo_bones_have_their_names_and_hierarchy_and_stand_in_t_pose(folder: Path) -> None:
    gltf = read(folder / "clone_mixamo.glb")
    bones = {gltf.nodes[number].name: gltf.nodes[number] for number in gltf.skins[0].joints}
    assert len(bones) == 54
    children = {name: {gltf.nodes[child].name for child in bone.children or []} for name, bone in bones.items()}
    for above, below in (
        ("Hips", "Spine"), ("Spine", "Spine1"), ("Spine1", "Spine2"), ("Spine2", "Neck"), ("Neck", "Head"),
        ("Spine2", "LeftShoulder"), ("LeftShoulder", "LeftArm"), ("LeftArm", "LeftForeArm"),
        ("LeftForeArm", "LeftHand"), ("LeftHand", "LeftHandIndex1"), ("Hips", "RightUpLeg"), ("RightLeg", "RightFoot"),
        ("RightFoot", "RightToeBase"), ("Head", "LeftEye"),
    ):  # fmt: skip
        assert f"mixamorig:{below}" in children[f"mixamorig:{above}"], below
    forearm = np.array(bones["mixamorig:LeftForeArm"].translation)
    assert forearm[0] > 0.2
    assert abs(forearm[1]) < 0.02, "arms level"


def test_mixamo_bones_carry_the_same_walk(clone: Clone) -> None:
    """Skin follows within centimetres of the 94 joints although 40 of them are left out."""
    posed, bones = in_t_pose(clone), mixamo.mixamo_bones()
    body = body_of(posed)
    motion = walk(body)
    few, weights = bones.carried(GENERIC.skin_joints, GENERIC.skin_weights)
    assert weights.sum(axis=1) == pytest.approx(1.0, abs=1e-6)
    assert weights.min() >= 0.0
    rotations, frame = bones.rotations(motion), 8
    world = world_from_local(rotations, bones.parents)
    where = joint_positions(world, posed.joints_m[bones.joints], bones.parents, motion.root_m)
    assert np.abs(where - body.places(motion)[:, bones.joints]).max() < 0.025
    all_joints = joint_transforms(posed.joints_m, GENERIC.joint_parents, motion.rotations[frame])
    wanted = linear_blend_skinning(
        posed.vertices_m, all_joints, GENERIC.skin_joints, GENERIC.skin_weights.astype(float)
    )
    moves = joint_transforms(posed.joints_m[bones.joints], bones.parents, rotations[frame])
    away = np.linalg.norm(linear_blend_skinning(posed.vertices_m, moves, few, weights) - wanted, axis=1)
    assert np.percentile(away, 95) < 0.02
    assert away.max() < 0.04


def test_flat_vrml_knows_only_shapes_and_shows_everything(folder: Path, clone: Clone) -> None:
    text = (folder / "clone_flat.wrl").read_text()
    assert not re.search(r"\b(PROTO|Joint|ROUTE|TimeSensor)\b", text)
    points = re.findall(r"coord Coordinate \{ point \[\n(.*?)\] \}", text, re.DOTALL)
    every = np.vstack([np.array(part.split(), dtype=float).reshape(-1, 3) for part in points])
    assert every[:, 1].min() == pytest.approx(0.0, abs=0.002)
    assert every[:, 1].max() == pytest.approx(max(shell.vertices_m[:, 1].max() for shell in clone.shells), abs=1e-4)
    for picture in re.findall(r'url "([^"]+)"', text):
        assert (folder / picture).is_file()


def test_usdz_is_a_stored_zip_with_every_file_on_64_bytes() -> None:
    data = usd.stored_zip({"clone.usdc": b"PXR-USDC" + bytes(57), "textures/a.jpg": b"jpeg"})
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        assert archive.testzip() is None
        entries = archive.infolist()
    assert [entry.filename for entry in entries] == ["clone.usdc", "textures/a.jpg"]
    for entry in entries:
        assert entry.compress_type == zipfile.ZIP_STORED
        name, extra = (int.from_bytes(data[entry.header_offset + at :][:2], "little") for at in (26, 28))
        assert (entry.header_offset + 30 + name + extra) % 64 == 0


def test_without_the_library_usdz_says_how_to_get_it(clone: Clone, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "pxr.Gf", None)
    with pytest.raises(ClonerError) as caught:
        usd.export(clone, tmp_path)
    assert "photo-cloner[usd]" in caught.value.hint
    assert not list(tmp_path.iterdir())


def test_usd_s_own_skinning_gives_our_pose_and_its_validators_find_nothing(clone: Clone, tmp_path: Path) -> None:
    pytest.importorskip("pxr", reason="usd-core is not here; run: pip install photo-cloner[usd]")
    from pxr import Usd, UsdGeom, UsdSkel, UsdValidation

    (path,) = usd.export(clone, tmp_path)
    stage = Usd.Stage.Open(str(path))
    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    assert [error.GetErrorAsString() for error in context.Validate(stage)] == []
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    root = UsdSkel.Root(stage.GetDefaultPrim())
    cache = UsdSkel.Cache()
    cache.Populate(root, Usd.PrimDefaultPredicate)
    frame, motion = 60, idle(body_of(clone))
    (binding,) = cache.ComputeSkelBindings(root, Usd.PrimDefaultPredicate)
    skeleton = cache.GetSkelQuery(binding.GetSkeleton())
    body = next(query for query in binding.GetSkinningTargets() if query.GetPrim().GetName() == "atlas_0")
    moved = np.array(UsdGeom.Mesh(body.GetPrim()).GetPointsAttr().Get())
    from pxr import Vt

    points = Vt.Vec3fArray.FromNumpy(moved)
    transforms = skeleton.ComputeSkinningTransforms(frame)
    assert body.ComputeSkinnedPoints(transforms, points, frame)
    ours = joint_transforms(clone.joints_m, GENERIC.joint_parents, motion.rotations[frame])
    wanted = (
        linear_blend_skinning(clone.vertices_m, ours, GENERIC.skin_joints, GENERIC.skin_weights.astype(float))
        + motion.root_m[frame]
    )
    from cloner.generic.surfaces import load_surfaces

    vertex = load_surfaces()[0].vertex
    assert np.abs(np.array(points) - wanted[vertex]).max() < 0.0005
    assert np.abs(np.array(points) - moved).max() > 0.1, "arms hang in the idle"


def test_collarbones_rise_under_level_arms(clone: Clone) -> None:
    """The shoulder goes up by the clavicle's length times the sine of its turn, and the arm is level all the same."""
    posed = in_t_pose(clone)
    for side, out in (("l", 1.0), ("r", -1.0)):
        joint = {name: GENERIC.joint(f"{side}_{name}") for name in ("sternoclavicular", "shoulder", "elbow", "wrist")}
        before, after = clone.joints_m, posed.joints_m
        bone, turned = (at[joint["shoulder"]] - at[joint["sternoclavicular"]] for at in (before, after))
        angles = [np.degrees(np.arctan2(one[1], out * one[0])) for one in (bone, turned)]
        assert angles[1] - angles[0] == pytest.approx(12.0, abs=0.5)
        arm = after[joint["wrist"]] - after[joint["shoulder"]]
        assert abs(arm[1]) < 0.03 * out * arm[0]


def test_a_smile_turns_normals_in_usd(clone: Clone, tmp_path: Path) -> None:
    pxr_usd = pytest.importorskip("pxr.Usd", reason="usd-core is not here; run: pip install photo-cloner[usd]")
    from pxr import UsdGeom, UsdSkel

    (path,) = usd.export(clone, tmp_path)
    stage = pxr_usd.Stage.Open(str(path))
    shape = next(UsdSkel.BlendShape(prim) for prim in stage.Traverse() if prim.GetName() == "mouthSmileLeft")
    mesh = UsdGeom.Mesh(shape.GetPrim().GetParent())
    points, normals = (np.array(attribute.Get(), float) for attribute in (mesh.GetPointsAttr(), mesh.GetNormalsAttr()))
    rows = np.array(shape.GetPointIndicesAttr().Get())
    moved, turned = points.copy(), normals.copy()
    moved[rows] += np.array(shape.GetOffsetsAttr().Get())
    turned[rows] += np.array(shape.GetNormalOffsetsAttr().Get())
    turned /= np.linalg.norm(turned, axis=1, keepdims=True)
    triangles = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3).astype(np.int32)
    truth = welded_normals(moved, triangles)
    lit = np.intersect1d(rows, np.flatnonzero((welded_normals(points, triangles) * normals).sum(axis=1) > 0.999))
    off, was = (np.degrees(np.arccos(np.clip(np.einsum("ij,ij->i", own[lit], truth[lit]), -1.0, 1.0)))
                for own in (turned, normals))  # fmt: skip
    assert was.max() > 10.0, "the smile turns normals"
    assert np.percentile(off, 99) < 4.0, "but where lips meet, whose vertices lie at one place"
    assert np.percentile(was, 99) > 2.0 * np.percentile(off, 99)


def test_usd_is_as_rough_as_its_regions(clone: Clone, tmp_path: Path) -> None:
    """Read by USD's own library: the skin's roughness comes from a picture's green, raw, whose lips shine most."""
    pxr_usd = pytest.importorskip("pxr.Usd", reason="usd-core is not here; run: pip install photo-cloner[usd]")
    triangles, _ = GENERIC.triangles()
    worn = replace(clone, triangle_regions=np.full(len(triangles), REGIONS.index("upper_clothes"), np.uint8))
    (path,) = usd.export(worn, tmp_path)
    stage = pxr_usd.Stage.Open(str(path))
    map_ = stage.GetPrimAtPath("/clone/looks/atlas/roughness")
    assert map_.GetAttribute("inputs:sourceColorSpace").Get() == "raw"
    file = map_.GetAttribute("inputs:file").Get().path
    surface = stage.GetPrimAtPath("/clone/looks/atlas/surface")
    assert surface.GetAttribute("inputs:roughness").GetConnections()[0].pathString.endswith("roughness.outputs:g")
    with zipfile.ZipFile(path) as archive, Image.open(io.BytesIO(archive.read(file))) as picture:
        green = np.asarray(picture)[..., 1] / 255.0
    assert np.median(green) == pytest.approx(0.9, abs=0.06), "cloth is dull"
    assert green.min() < 0.5
    from pxr import UsdValidation

    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    assert [error.GetErrorAsString() for error in context.Validate(stage)] == []
