"""A dressed clone as a result, and its cloth as a crowd moves it."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cloth.clothed import with_garment_shell, write_garments_as_result
from cloner.cloth.drafting.blocks import BLOCKS, draft_block
from cloner.cloth.dressing import DressedClone, dress_clone
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.placing import body_ring
from cloner.cloth.written import dress_file
from cloner.crowd.clones.cast import CrowdClone, make_crowd_clone, skin_vertices
from cloner.crowd.clones.flowing import decompose_skinning
from cloner.crowd.clones.glb import levels_glb
from cloner.crowd.clones.levels import BodyLevels, body_levels
from cloner.errors import ClonerError
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.pipeline import no_progress
from cloner.project.clone_file import load_clone, save_clone
from cloner.project.flow_file import FLOW_FILE, load_flow
from cloner.records.clones import Clone


@pytest.fixture(scope="module")
def eva() -> Clone:
    return clone_of_measures(BodySpecification("f", 1.68, {"waist_girth": 740.0}), 512)


@pytest.fixture(scope="module")
def walking(eva: Clone) -> DressedClone:
    clone = centre_joints(eva)
    pattern = draft_block(BLOCKS["skirt"], body_ring(clone, "natural_waist").girth_m, 0.5)
    return dress_clone(clone, pattern, "natural_waist", FABRICS["silk"], own_motions(clone)[0], cycles=4, step_m=0.04)


@pytest.fixture(scope="module")
def result(eva: Clone, walking: DressedClone, tmp_path_factory: pytest.TempPathFactory) -> Path:
    home = tmp_path_factory.mktemp("results")
    (home / "eva").mkdir()
    save_clone(eva, home / "eva" / "clone.npz")
    write_garments_as_result(walking, eva, home / "eva", home / "eva-skirt", ["skirt"], ("glb",), no_progress)
    return home / "eva-skirt"


@pytest.fixture(scope="module")
def cast(result: Path) -> tuple[CrowdClone, Clone, BodyLevels]:
    clone, body = load_clone(result / "clone.npz"), body_levels()
    flow = load_flow(result, clone)
    return make_crowd_clone("eva", centre_joints(clone), body, poses=16, flow=flow), clone, body


def test_the_result_wears_its_garment_and_keeps_how_it_flows(result: Path, walking: DressedClone) -> None:
    clone = load_clone(result / "clone.npz")
    (shell,) = [one for one in clone.shells if one.kind == "cloth"]
    flow = load_flow(result, clone)
    assert flow is not None
    assert flow.frames_m == pytest.approx(walking.loop.frames_m[:, walking.worn.cloth.vertex], abs=1e-6)
    assert shell.skin_weights.sum(axis=1) == pytest.approx(1.0)
    assert np.abs(shell.rgba[..., :3].reshape(-1, 3).mean(axis=0) - FABRICS["silk"].rgb).max() < 3.0
    assert 300 < flow.hidden.sum() < 3000
    told = json.loads((result / "report.json").read_text())
    assert told["kind"] == "dressed"
    assert told["stamp"]["options"] == {"garment": ["skirt"], "fabric": ["silk"], "motion": "walk"}
    assert (result / "clone.glb").is_file()


def test_broken_and_other_people_s_cloth_is_refused(result: Path, eva: Clone, tmp_path: Path) -> None:
    assert load_flow(tmp_path, eva) is None
    (tmp_path / FLOW_FILE).write_bytes((result / FLOW_FILE).read_bytes())
    with pytest.raises(ClonerError, match="another clone's"):
        load_flow(tmp_path, eva)
    (tmp_path / FLOW_FILE).write_bytes(b"PK nothing")
    with pytest.raises(ClonerError, match="no readable cloth"):
        load_flow(tmp_path, eva)


def test_nobody_is_replaced_by_themselves_dressed(result: Path) -> None:
    for source in (result, result / "clone.npz"):
        with pytest.raises(ClonerError, match="replaced by itself"):
            dress_file(source, result, garment="skirt", fabric="silk")


def test_photographed_cloth_gives_way_to_the_garment(eva: Clone, walking: DressedClone, result: Path) -> None:
    again, _ = with_garment_shell(walking, load_clone(result / "clone.npz"))
    assert [one.kind for one in again.shells].count("cloth") == 1


def test_two_rigid_halves_are_found_exactly() -> None:
    rng = np.random.default_rng(1)
    rest = np.concatenate([rng.normal(size=(60, 3)) * 0.1, rng.normal(size=(60, 3)) * 0.1 + [1.0, 0.0, 0.0]])
    frames = []
    for k in range(6):
        turns = Rotation.from_rotvec([[0.1 * k, 0.0, 0.0], [0.0, -0.2 * k, 0.0]]).as_matrix()
        frames.append(np.concatenate([rest[:60] @ turns[0].T, rest[60:] @ turns[1].T + [0.0, 0.01 * k, 0.0]]))
    bones, joints, weights = decompose_skinning(rest, np.array(frames))
    for k in range(6):
        assert skin_vertices(rest, joints, weights, bones[k]) == pytest.approx(frames[k], abs=1e-6)
    assert weights.sum(axis=1) == pytest.approx(1.0)
    assert weights.min() >= 0.0


def test_cloth_flows_in_a_crowd_as_it_was_simulated(
    cast: tuple[CrowdClone, Clone, BodyLevels], walking: DressedClone
) -> None:
    made, clone, _ = cast
    walk, loose = made.clips[0], made.loose
    flow = walking.loop.frames_m[:, walking.worn.cloth.vertex]
    cloth, errors, hung = loose.cloth, [], []
    (shell,) = [one for one in clone.shells if one.kind == "cloth"]
    for frame in range(0, len(walk.frames), 8):
        shown = skin_vertices(loose.vertices_m, loose.joints, loose.weights, walk.frames[frame])[cloth]
        at = frame * len(flow) / len(walk.frames)
        true = flow[int(at)] + (at % 1.0) * (flow[(int(at) + 1) % len(flow)] - flow[int(at)])
        errors.append(np.linalg.norm(shown - true, axis=1))
        plain = skin_vertices(
            shell.vertices_m, shell.skin_joints.astype(np.int64), shell.skin_weights, walk.frames[frame]
        )
        hung.append(np.linalg.norm(plain - true, axis=1))
    rms, usual = (float(np.sqrt(np.mean(np.square(each)))) for each in (errors, hung))
    assert rms < 0.02
    assert rms < 0.25 * usual, "the skeleton alone does not carry it"
    idle = next(clip for clip in made.clips if clip.name == "idle")
    still = skin_vertices(loose.vertices_m, loose.joints, loose.weights, idle.frames[0])[cloth]
    assert np.linalg.norm(still - loose.vertices_m[cloth], axis=1).max() < 0.06


def test_covered_skin_lies_deeper_and_the_garment_has_its_own_look(cast: tuple[CrowdClone, Clone, BodyLevels]) -> None:
    made, clone, body = cast
    moved = np.linalg.norm(made.vertices_m - centre_joints(clone).vertices_m[body.vertex], axis=1)
    assert moved.max() == pytest.approx(0.02, abs=1e-3)
    assert 0.02 < (moved > 0.01).mean() < 0.5
    assert made.hung == "bottom"
    assert np.abs(np.array(made.looks["bottom"].colour) - FABRICS["silk"].rgb).max() < 25.0


def test_the_file_of_levels_carries_the_cloth_s_bones(cast: tuple[CrowdClone, Clone, BodyLevels]) -> None:
    made, clone, body = cast
    data = levels_glb(made, clone, body)
    told = json.loads(data[20 : 20 + struct.unpack("<I", data[12:16])[0]])
    names = [node.get("name", "") for node in told["nodes"]]
    bones = [k for k, name in enumerate(names) if name.startswith("Cloth ")]
    assert len(bones) == made.clips[0].frames.shape[1] - len(clone.joints_m)
    assert told["skins"][0]["joints"][-len(bones) :] == bones
    walk = next(one for one in told["animations"] if one["name"] == "walk")
    aimed = [(channel["target"]["node"], channel["target"]["path"]) for channel in walk["channels"]]
    assert {(bone, path) for bone in bones for path in ("rotation", "translation")} <= set(aimed)
