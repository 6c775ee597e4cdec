"""A body that puts on a skirt and walks in it, in a loop."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import cv2
import numpy as np
import pygltflib
import pytest
from scipy.spatial import cKDTree

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cloth.caches import obj, pc2, usd, vat
from cloner.cloth.drafting.blocks import BLOCKS, draft_block
from cloner.cloth.dressing import DressedClone, dress_clone
from cloner.cloth.glb import MASKED, glb
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.placing import body_ring
from cloner.cloth.simulation.solver import strains
from cloner.cloth.written import dress_file
from cloner.errors import Cancelled, ClonerError
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.project.clone_file import save_clone
from cloner.records.clones import Clone


@pytest.fixture(scope="module")
def eva() -> Clone:
    return centre_joints(clone_of_measures(BodySpecification("f", 1.68, {"waist_girth": 740.0}), 512))


@pytest.fixture(scope="module")
def walking(eva: Clone) -> DressedClone:
    ring = body_ring(eva, "natural_waist")
    pattern = draft_block(BLOCKS["skirt"], ring.girth_m, 0.5)
    return dress_clone(eva, pattern, "natural_waist", FABRICS["cotton"], own_motions(eva)[0], cycles=4, step_m=0.04)


def test_the_ring_is_the_waist_s_tape_and_what_the_cloth_stands_off(eva: Clone) -> None:
    ring = body_ring(eva, "natural_waist")
    assert 1e3 * ring.girth_m == pytest.approx(740.0 + 2e3 * np.pi * 0.006, abs=3.0)
    front = ring.at(np.array([0.0, 0.25]))
    assert front[0, 2] > front[1, 2]
    assert front[1, 0] > 0.1  # on from the front to the person's left


def test_the_loop_is_closed_and_clear_of_the_skin(walking: DressedClone) -> None:
    frames, worn = walking.loop.frames_m, walking.worn
    assert len(frames) == len(worn.rotations)
    assert np.isfinite(frames).all()
    for number in range(0, len(frames), 5):
        skin = worn.body.posed(worn.root_m[number], worn.rotations[number])
        corner = skin[worn.body.triangles]
        normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
        _, near = cKDTree(corner.mean(axis=1)).query(frames[number])
        deep = np.einsum("ij,ij->i", frames[number] - corner.mean(axis=1)[near], normal[near])
        assert (deep < -0.003).mean() < 0.01
    frames = np.roll(frames, -walking.loop.seam, axis=0)
    jolts = np.linalg.norm(np.diff(np.concatenate([frames, frames[:2]]), 2, axis=0), axis=2).max(axis=1)
    assert jolts[-2:].max() < 1.25 * np.median(jolts)  # the seam is felt no more than other frames
    assert walking.loop.gap_mm < 0.25 * walking.loop.median_mm, "it nears a cycle of its own"
    longer = [np.quantile(strains(worn.sheet, frame), 0.99) for frame in frames]
    assert max(longer) < 0.25  # spread over folds without being drawn together again, threads were half too long


def test_the_skirt_hangs_where_a_skirt_hangs(walking: DressedClone) -> None:
    frames = walking.loop.frames_m
    generic, clone = load_generic(), walking.clone
    waist = float(clone.vertices_m[generic.feature("waist_front"), 1])
    assert frames[..., 1].max() == pytest.approx(waist, abs=0.12)
    assert 0.3 < frames[..., 1].max() - frames[..., 1].min() < 0.62


def test_every_frame_is_a_target_that_the_walk_turns_on(walking: DressedClone) -> None:
    gltf = pygltflib.GLTF2.load_from_bytes(glb(walking))
    node = next(node for node in gltf.nodes if node.name == "Garment")
    primitive = gltf.meshes[node.mesh].primitives[0]
    frames, blob = walking.loop.frames_m, gltf.binary_blob()

    def values(number: int) -> np.ndarray:
        accessor = gltf.accessors[number]
        view = gltf.bufferViews[accessor.bufferView]
        width = {"SCALAR": 1, "VEC3": 3}[accessor.type]
        return np.frombuffer(blob, np.float32, accessor.count * width, view.byteOffset).reshape(-1, width)

    base = values(primitive.attributes.POSITION)
    assert base == pytest.approx(frames[0][walking.worn.cloth.vertex], abs=1e-6)
    shown = base + values(primitive.targets[6]["POSITION"])
    assert shown == pytest.approx(frames[7][walking.worn.cloth.vertex], abs=1e-6)
    channel = next(
        each
        for each in gltf.animations[0].channels
        if each.target.path == "weights" and gltf.nodes[each.target.node].name == "Garment"
    )
    sampler = gltf.animations[0].samplers[channel.sampler]
    weights = values(sampler.output).reshape(len(frames) + 1, len(frames) - 1)
    assert weights.sum(axis=1).tolist() == [0.0, *[1.0] * (len(frames) - 1), 0.0]
    assert values(sampler.input)[-1, 0] == pytest.approx(walking.motion.times_s[-1])


def test_skin_under_the_skirt_is_masked_and_none_is_lost(walking: DressedClone) -> None:
    gltf = pygltflib.GLTF2.load_from_bytes(glb(walking))
    blob = gltf.binary_blob()
    body = next(mesh for mesh in gltf.meshes if mesh.name == "Body")
    hidden = next(each for each in body.primitives if gltf.materials[each.material].name == MASKED)
    assert gltf.materials[hidden.material].alphaMode == "MASK"
    assert hidden.attributes.POSITION == body.primitives[0].attributes.POSITION

    def rows(primitive: pygltflib.Primitive) -> np.ndarray:
        accessor = gltf.accessors[primitive.indices]
        view = gltf.bufferViews[accessor.bufferView]
        kind = np.uint16 if accessor.componentType == pygltflib.UNSIGNED_SHORT else np.uint32
        return np.frombuffer(blob, kind, accessor.count, view.byteOffset + accessor.byteOffset).reshape(-1, 3)

    both = np.concatenate([rows(body.primitives[0]), rows(hidden)])
    whole = load_surfaces()[0].triangles
    assert sorted(map(tuple, both.tolist())) == sorted(map(tuple, whole.tolist()))
    own = load_generic().vertex_segment[load_surfaces()[0].vertex[rows(hidden)]]
    names = {load_generic().segment_names[row] for row in np.unique(own)}
    assert names
    assert names <= {"torso", "pelvis", "left_thigh", "right_thigh"}  # a skirt of 50 cm ends above the calves


def test_caches_hold_every_frame(walking: DressedClone) -> None:
    data, frames = pc2(walking), walking.loop.frames_m
    assert data[:12] == b"POINTCACHE2\0"
    version, count, first, rate, samples = struct.unpack("<iiffi", data[12:32])
    assert (version, count, first, rate, samples) == (1, frames.shape[1], 0.0, 1.0, len(frames) + 1)
    points = np.frombuffer(data, "<f4", offset=32).reshape(samples, count, 3)
    assert points[:-1] == pytest.approx(frames, abs=1e-6)
    assert points[-1].tolist() == points[0].tolist()
    lines = obj(walking).decode().splitlines()
    assert sum(line.startswith("v ") for line in lines) == count
    assert [float(x) for x in next(line for line in lines if line.startswith("v ")).split()[1:]] == pytest.approx(
        frames[0, 0], abs=1e-6
    )
    assert sum(line.startswith("f ") for line in lines) == len(walking.worn.cloth.faces)


def test_a_vertex_animation_texture_decodes_to_the_loop(walking: DressedClone) -> None:
    """Read as the layout's documentation says, by nothing of ours: at most 1 mm off."""
    files, frames = vat(walking), walking.loop.frames_m[:, walking.worn.cloth.vertex]
    image = cv2.imdecode(np.frombuffer(files[".png"], np.uint8), cv2.IMREAD_UNCHANGED)[..., ::-1] / 65535.0
    told = json.loads(files["-remap_info.json"])
    gltf = pygltflib.GLTF2.load_from_bytes(files[".glb"])
    accessor = gltf.accessors[gltf.meshes[0].primitives[0].attributes.POSITION]
    view = gltf.bufferViews[accessor.bufferView]
    rest = np.frombuffer(gltf.binary_blob(), np.float32, 3 * accessor.count, view.byteOffset).reshape(-1, 3)
    assert image.shape[:2] == (2 * len(frames), len(rest))
    assert told["animations"]["walk"]["endFrame"] == len(frames) - 1
    low, high = np.array(told["os-remap"]["Min"]), np.array(told["os-remap"]["Max"])
    for row in range(0, len(frames), 7):
        off = low + image[row] * (high - low)
        moved = rest + np.column_stack([off[:, 0], off[:, 2], -off[:, 1]])
        assert np.linalg.norm(moved - frames[row], axis=1).max() < 1e-3


def test_a_garment_of_too_many_points_is_refused_before_it_is_simulated(eva: Clone, tmp_path: Path) -> None:
    path = tmp_path / "clone.npz"
    save_clone(eva, path)
    with pytest.raises(ClonerError, match="readers of vertex animation textures") as caught:
        dress_file(path, tmp_path / "skirt.png", garment="circle-skirt", fabric="silk", length_cm=95.0)
    assert "--length" in caught.value.hint
    assert [path.name for path in tmp_path.iterdir()] == ["clone.npz"]


def test_usd_moves_the_points(walking: DressedClone, tmp_path: Path) -> None:
    pxr = pytest.importorskip("pxr.Usd"), pytest.importorskip("pxr.UsdGeom")
    path = tmp_path / "skirt.usdc"
    path.write_bytes(usd(walking))
    stage = pxr[0].Stage.Open(str(path))
    mesh = pxr[1].Mesh(stage.GetDefaultPrim())
    assert stage.GetTimeCodesPerSecond() == 30.0
    assert np.array(mesh.GetPointsAttr().Get(7.0)) == pytest.approx(walking.loop.frames_m[7], abs=1e-6)
    assert len(mesh.GetFaceVertexCountsAttr().Get()) == len(walking.worn.cloth.faces)


def test_wrong_words_and_a_stop_leave_no_file(eva: Clone, tmp_path: Path) -> None:
    save_clone(eva, tmp_path / "clone.npz")
    for words, names in (
        ({"garment": "tutu", "fabric": "silk"}, "tutu"),
        ({"garment": "skirt", "fabric": "steel"}, "steel"),
        ({"garment": "skirt", "fabric": "silk", "length_cm": 500.0}, "500 cm"),
        ({"garment": "skirt", "fabric": "silk", "length_cm": float("nan")}, "nan cm"),
        ({"garment": "skirt", "fabric": "silk", "motion": "swim"}, "swim"),
        ({"garment": "trousers", "fabric": "silk", "length_cm": 12.0}, "12 cm"),
    ):
        with pytest.raises(ClonerError, match=names):
            dress_file(tmp_path, tmp_path / "out.glb", **words)  # type: ignore[arg-type]
    with pytest.raises(ClonerError, match="no dressed clone"):
        dress_file(tmp_path, tmp_path / "out.fbx", garment="skirt", fabric="silk")

    def stop(step: str, fraction: float) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        dress_file(tmp_path, tmp_path / "out.glb", garment="skirt", fabric="silk", progress=stop)
    assert not (tmp_path / "out.glb").exists()
