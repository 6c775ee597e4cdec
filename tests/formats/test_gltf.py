"""clone.glb through foreign eyes: the Khronos validator, trimesh, and a plain reading of the bytes."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pygltflib
import pytest
import trimesh
from scipy.spatial.transform import Rotation

from cloner.errors import ClonerError
from cloner.exporters.gltf.gltf import export
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.motion.flesh.bending import flesh
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.records.clones import Clone
from kit.clones import RED_LEFT_HAND, toy_clone
from kit.compare_clones import snapshot

VALIDATOR = Path(__file__).with_name("validate_gltf.mjs")
#: A folder in which `npm install gltf-validator` was run.
MODULES = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node"))


@pytest.fixture(scope="module")
def clone() -> Clone:
    return toy_clone(1.64)


@pytest.fixture(scope="module")
def glb(clone, tmp_path_factory) -> Path:
    (path,) = export(clone, tmp_path_factory.mktemp("glb"))
    return path


@pytest.fixture(scope="module")
def gltf(glb):
    return pygltflib.GLTF2().load_binary(str(glb))


def _read(gltf, accessor: int) -> np.ndarray:
    """An accessor's rows, sparse ones filled with zeros: written from the specification, not from the exporter."""
    row = gltf.accessors[accessor]
    kinds = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[row.type]
    blob = gltf.binary_blob()

    def rows(view: int, kind: int, count: int, wide: int) -> np.ndarray:
        start = gltf.bufferViews[view].byteOffset or 0
        return np.frombuffer(blob, kinds[kind], count * wide, start).reshape(count, wide)

    filled = np.zeros((row.count, width), kinds[row.componentType])
    if row.bufferView is not None:
        filled = rows(row.bufferView, row.componentType, row.count, width).copy()
    if row.sparse is not None:
        index = rows(row.sparse.indices.bufferView, row.sparse.indices.componentType, row.sparse.count, 1)[:, 0]
        filled[index] = rows(row.sparse.values.bufferView, row.componentType, row.sparse.count, width)
    return filled


def _primitives(gltf):
    return [primitive for mesh in gltf.meshes for primitive in mesh.primitives]


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here; run: npm install --prefix /tmp/cloner-node gltf-validator",
)
@pytest.mark.parametrize("kind", ["full", "bald", "without morphs"])
def test_the_khronos_validator_finds_nothing(kind, clone, tmp_path):
    if kind == "bald":
        clone = toy_clone(hair=False)
    if kind == "without morphs":
        empty = np.zeros(0, np.int32)
        clone = replace(clone, morph_names=(), morph_index=empty, morph_delta_m=np.zeros((0, 3)), morph_start=[0])
    (path,) = export(clone, tmp_path)
    done = subprocess.run(["node", VALIDATOR, MODULES, path], capture_output=True, text=True, check=True, timeout=120)
    issues = json.loads(done.stdout)["issues"]
    assert issues["messages"] == []
    assert issues["numErrors"] == issues["numWarnings"] == 0


def test_a_foreign_reader_sees_the_person_in_metres_standing_and_facing_plus_z(glb, clone):
    scene = trimesh.load(glb)
    low, high = scene.bounds
    assert low[1] == pytest.approx(0.0, abs=0.002), "soles on the floor"
    assert high[1] == pytest.approx(clone.shells[0].vertices_m[:, 1].max(), abs=1e-4)
    body = scene.geometry["Body"].vertices
    assert np.ptp(body[:, 1]) == pytest.approx(1.64, abs=0.003)
    nose = clone.features_m["nose_tip"]
    assert nose[2] > 0.05
    assert np.linalg.norm(body - nose, axis=1).min() < 1e-4, "the nose tip is on the surface, in front"


def test_a_foreign_reader_sees_the_red_left_hand_at_plus_x(glb, clone):
    body = trimesh.load(glb).geometry["Body"]
    picture = np.asarray(body.visual.material.baseColorTexture.convert("RGB"))
    height, width = picture.shape[:2]
    hand = np.linalg.norm(body.vertices - clone.features_m["fingertip_left"], axis=1).argmin()
    u, v = body.visual.uv[hand]  # trimesh counts v upwards
    colour = picture[int((1 - v) * height) % height, int(u * width) % width].astype(int)
    assert body.vertices[hand, 0] > 0.3
    assert np.abs(colour - RED_LEFT_HAND).max() < 30


def test_the_skeleton_is_h_anim(gltf, clone):
    generic = load_generic()
    joints = [gltf.nodes[joint] for joint in gltf.skins[0].joints]
    assert [joint.name for joint in joints] == list(generic.joint_names)
    assert len(joints) == 94
    assert {"HumanoidRoot", "sacroiliac", "l_shoulder", "r_knee", "skullbase"} <= {joint.name for joint in joints}
    assert gltf.nodes[gltf.skins[0].skeleton].name == "Armature"
    world = {}

    def walk(node: int, origin: np.ndarray) -> None:
        place = origin + np.array(gltf.nodes[node].translation or [0, 0, 0])
        world[gltf.nodes[node].name] = place
        for child in gltf.nodes[node].children or []:
            walk(child, place)

    walk(gltf.scenes[0].nodes[0], np.zeros(3))
    found = np.array([world[name] for name in generic.joint_names])
    assert np.abs(found - centre_joints(clone).joints_m).max() < 1e-6
    # stored by columns: the last row holds the offset
    inverse = _read(gltf, gltf.skins[0].inverseBindMatrices).reshape(-1, 4, 4)
    assert np.abs(inverse[:, 3, :3] + centre_joints(clone).joints_m).max() < 1e-6


def test_at_most_four_influences_that_sum_to_one(gltf):
    for primitive in _primitives(gltf):
        weights = _read(gltf, primitive.attributes.WEIGHTS_0)
        joints = _read(gltf, primitive.attributes.JOINTS_0)
        assert getattr(primitive.attributes, "WEIGHTS_1", None) is None
        assert weights.sum(axis=1) == pytest.approx(1.0, abs=1e-6)
        assert weights.min() >= 0.0
        assert joints.max() < 94
        assert (joints[weights == 0.0] == 0).all()


def test_skinning_the_file_gives_the_same_pose_as_our_own(gltf, clone):
    """Linear blend skinning from the file's numbers alone, against geometry.skinning."""
    generic = load_generic()
    rotations = np.zeros((94, 3))
    rotations[generic.joint("l_elbow")] = [0.0, 1.0, 0.2]
    rotations[generic.joint("vl1")] = [0.3, 0.0, 0.0]
    transforms = joint_transforms(centre_joints(clone).joints_m, generic.joint_parents, rotations)
    wanted = linear_blend_skinning(clone.vertices_m, transforms, generic.skin_joints, generic.skin_weights)
    body = gltf.meshes[0].primitives[0].attributes
    inverse = _read(gltf, gltf.skins[0].inverseBindMatrices).reshape(-1, 4, 4).transpose(0, 2, 1)
    bind = transforms @ np.linalg.inv(inverse)  # world matrix of every joint node
    matrix = np.einsum("vk,vkab->vab", _read(gltf, body.WEIGHTS_0), (bind @ inverse)[_read(gltf, body.JOINTS_0)])
    rest = _read(gltf, body.POSITION)
    posed = np.einsum("vab,vb->va", matrix, np.column_stack([rest, np.ones(len(rest))]))[:, :3]
    assert np.linalg.norm(posed - rest, axis=1).max() > 0.1, "the pose moves the skin"
    vertex = np.array([np.linalg.norm(clone.vertices_m - point, axis=1).argmin() for point in rest[::97]])
    assert np.abs(posed[::97] - wanted[vertex]).max() < 1e-3


def test_morph_targets_carry_the_arkit_and_viseme_names(gltf, clone):
    body = gltf.meshes[0]
    names = body.extras["targetNames"]
    generic = load_generic()
    assert names[:67] == [*generic.arkit_names, *generic.viseme_names]
    assert all(name.startswith("corrective_") for name in names[67:])
    assert len(generic.arkit_names) == 52
    assert {"jawOpen", "eyeBlinkLeft", "mouthSmileRight", "viseme_sil", "viseme_aa"} <= set(names)
    assert all(len(primitive.targets) == len(names) for primitive in body.primitives)
    jaw = _read(gltf, body.primitives[0].targets[names.index("jawOpen")]["POSITION"])
    rest = _read(gltf, body.primitives[0].attributes.POSITION)
    chin = np.linalg.norm(rest - clone.features_m["chin_front"], axis=1).argmin()
    crown = np.linalg.norm(rest - clone.features_m["head_top"], axis=1).argmin()
    assert jaw[chin, 1] < -0.005, "opening the jaw lowers the chin"
    assert np.abs(jaw[crown]).max() == 0.0


def test_the_scene_tells_stature_features_and_credits(gltf, clone):
    facts = gltf.scenes[0].extras
    assert facts["stature_m"] == pytest.approx(1.64)
    assert facts["units"] == "metre"
    assert facts["features_m"]["nose_tip"] == pytest.approx(clone.features_m["nose_tip"], abs=1e-5)
    assert "CC0" in facts["credits"]
    assert "Cloner" in gltf.asset.generator


def test_materials_are_not_metal_and_hair_is_cut_out(gltf):
    assert all(material.pbrMetallicRoughness.metallicFactor == 0.0 for material in gltf.materials)
    looks = {material.name: material for material in gltf.materials}
    assert looks["hair"].alphaMode == "MASK"
    assert looks["hair"].doubleSided
    assert looks["lashes"].alphaMode == "BLEND"
    assert looks["body"].alphaMode == "OPAQUE"
    assert not looks["body"].doubleSided


def test_exporting_changes_neither_the_clone_nor_leaves_other_files(clone, tmp_path):
    before = snapshot(clone)
    export(clone, tmp_path, name="person")
    assert snapshot(clone) == before
    assert [path.name for path in tmp_path.iterdir()] == ["person.glb"]


def test_a_folder_that_is_a_file_is_an_operator_s_error(clone, tmp_path):
    blocked = tmp_path / "taken"
    blocked.write_text("")
    with pytest.raises(ClonerError) as caught:
        export(clone, blocked)
    assert caught.value.where == "clone.glb"
    assert "folder" in caught.value.hint


def test_walk_and_idle_are_inside_and_close(gltf, clone):
    """Every channel's values are those of its own times, unit quaternions that end where they began."""
    names = {animation.name: animation for animation in gltf.animations}
    assert set(names) == {"walk", "idle"}
    for animation in names.values():
        times = _read(gltf, animation.samplers[0].input)[:, 0]
        assert (np.diff(times) > 0).all()
        for channel in animation.channels:
            values = _read(gltf, animation.samplers[channel.sampler].output)
            values = values.reshape(len(times), -1)
            assert np.abs(values[0] - values[-1]).max() < 1e-5
            if channel.target.path == "rotation":
                assert np.linalg.norm(values, axis=1) == pytest.approx(1.0, abs=1e-5)
                assert (np.einsum("fa,fa->f", values[1:], values[:-1]) > 0).all()
    assert 0.8 < names["walk"].extras["speed_m_s"] < 2.2
    moved = {gltf.nodes[channel.target.node].name for channel in names["walk"].channels}
    assert {"HumanoidRoot", "l_hip", "r_knee", "l_shoulder"} <= moved


def test_the_idle_blinks_through_the_morph_targets(gltf, clone):
    idle = next(animation for animation in gltf.animations if animation.name == "idle")
    (channel,) = [one for one in idle.channels if one.target.path == "weights"]
    assert gltf.nodes[channel.target.node].name == "Body"
    sampler = idle.samplers[channel.sampler]
    weights = _read(gltf, sampler.output).reshape(len(_read(gltf, sampler.input)), -1)
    assert weights[:, clone.morph_names.index("eyeBlinkLeft")].max() > 0.8
    assert weights[:, clone.morph_names.index("jawOpen")].max() == 0.0


def test_the_file_s_own_walk_keeps_the_flesh_of_the_knee(gltf, clone):
    """Skinned as the specification says, targets first: the knee holds what it holds at rest, 9 % less without them."""
    walk = next(animation for animation in gltf.animations if animation.name == "walk")
    (channel,) = [one for one in walk.channels if one.target.path == "weights"]
    names = gltf.meshes[0].extras["targetNames"]
    weights = _read(gltf, walk.samplers[channel.sampler].output).reshape(-1, len(names))
    frame = int(weights[:, names.index("corrective_l_knee_bent_50")].argmax())
    body, primitive = body_of(centre_joints(clone)), gltf.meshes[0].primitives[0]
    world = np.tile(np.eye(4), (len(body.names), 1, 1))
    for joint, (name, parent) in enumerate(zip(body.names, body.parents, strict=True)):
        node = next(number for number, node in enumerate(gltf.nodes) if node.name == name)
        turns = [one for one in walk.channels if one.target.path == "rotation" and one.target.node == node]
        if turns:
            turn = _read(gltf, walk.samplers[turns[0].sampler].output)[frame]
            world[joint, :3, :3] = Rotation.from_quat(turn.astype(float)).as_matrix()
        world[joint, :3, 3] = gltf.nodes[node].translation
        if parent >= 0:
            world[joint] = world[parent] @ world[joint]
    moves = world @ _read(gltf, gltf.skins[0].inverseBindMatrices).reshape(-1, 4, 4).transpose(0, 2, 1)
    rest = _read(gltf, primitive.attributes.POSITION).astype(float)
    joints, shares = (_read(gltf, own) for own in (primitive.attributes.JOINTS_0, primitive.attributes.WEIGHTS_0))
    around = flesh("l", "knee")
    wedge = np.array([np.linalg.norm(rest - clone.vertices_m[row], axis=1).argmin() for row in around.rows])

    def held(targets: np.ndarray) -> float:
        points = rest.copy()
        for number in np.flatnonzero(targets):
            points += targets[number] * _read(gltf, primitive.targets[number]["POSITION"])
        posed = np.einsum(
            "nk,nkab,nb->na", shares, moves[joints][..., :3, :], np.column_stack([points, np.ones(len(rest))])
        )
        return around.volume(posed[wedge]) / around.volume(rest[wedge])

    assert held(weights[frame]) == pytest.approx(1.0, abs=0.03)
    assert held(0.0 * weights[frame]) < 0.97


def test_drivers_are_told_with_the_bones_that_they_follow(gltf):
    told = gltf.scenes[0].extras["correctives"]
    names = gltf.meshes[0].extras["targetNames"]
    assert {driver["joint"] for driver in told} == {
        f"{side}_{joint}" for side in "lr" for joint in ("shoulder", "elbow", "hip", "knee")
    }
    assert {name for driver in told for name in driver["targets"] if name} == set(names[67:])


def test_the_scene_tells_measures_consent_credits_and_stamp(clone, tmp_path):
    told = replace(clone, measures_mm={"chest_girth": 941.5}, consent=True, stamp="Cloner 0.1, seed 0")
    (path,) = export(told, tmp_path)
    extras = pygltflib.GLTF2().load_binary(str(path)).scenes[0].extras
    assert extras["measures_mm"] == {"chest_girth": 941.5}
    assert extras["consent"] == "recorded"
    assert "MakeHuman" in extras["credits"]
    assert extras["stamp"] == "Cloner 0.1, seed 0"
    (path,) = export(clone, tmp_path)
    assert pygltflib.GLTF2().load_binary(str(path)).scenes[0].extras["consent"] == "not recorded"
