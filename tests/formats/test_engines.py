"""Skeletons that game engines know, through trimesh and Assimp, which others wrote."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pygltflib
import pytest
import trimesh

from cloner.exporters.avatars.engines import export_unity, export_unreal
from cloner.motion.limbs.rig import centre_joints
from kit import readers
from kit.clones import toy_clone

MODULES = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node"))
VALIDATOR = Path(__file__).with_name("validate_gltf.mjs")
#: The mandatory bones of Unity's humanoid, and the mannequin's chain, as the engines' own pages have them.
UNITY = ["Hips", "Spine", "Head"] + [
    side + bone for side in ("Left", "Right")
    for bone in ("UpperLeg", "LowerLeg", "Foot", "UpperArm", "LowerArm", "Hand")
]  # fmt: skip
UNREAL = {"pelvis": "spine_01", "spine_01": "spine_02", "spine_02": "spine_03", "spine_03": "clavicle_l",
          "clavicle_l": "upperarm_l", "upperarm_l": "lowerarm_l", "lowerarm_l": "hand_l", "hand_l": "middle_01_l",
          "thigh_r": "calf_r", "calf_r": "foot_r", "foot_r": "ball_r", "neck_01": "neck_02",
          "neck_02": "head"}  # fmt: skip


@pytest.fixture(scope="module")
def files(tmp_path_factory) -> dict[str, Path]:
    made, clone = tmp_path_factory.mktemp("engines"), toy_clone(1.64)
    return {"unity": export_unity(clone, made)[0], "unreal": export_unreal(clone, made)[0]}


def test_unity_finds_its_mandatory_bones_in_t_pose(files) -> None:
    graph = trimesh.load(files["unity"], force="scene").graph
    place = {name: graph[name][0][:3, 3] for name in UNITY}
    for side, out in (("Left", 1.0), ("Right", -1.0)):
        arm = place[f"{side}Hand"] - place[f"{side}UpperArm"]
        assert out * arm[0] > 0.4
        assert abs(arm[1]) < 0.03
        assert place[f"{side}Foot"][1] < 0.15 < place[f"{side}LowerLeg"][1]


def test_unreal_finds_its_mannequin_in_the_a_pose_of_the_photos(files) -> None:
    gltf = pygltflib.GLTF2().load_binary(str(files["unreal"]))
    below = {node.name: {gltf.nodes[child].name for child in node.children or []} for node in gltf.nodes}
    for above, bone in UNREAL.items():
        assert bone in below[above], f"{bone} hangs below {above}"
    graph = trimesh.load(files["unreal"], force="scene").graph
    clone = centre_joints(toy_clone(1.64))
    wrist = graph["hand_l"][0][:3, 3]
    assert np.linalg.norm(clone.joints_m - wrist, axis=1).min() < 1e-4, "joints stay where the clone has them"


@pytest.mark.skipif(not readers.HAS_ASSIMP, reason="assimp is not here; run: sudo apt-get install -y assimp-utils")
@pytest.mark.parametrize("engine", ["unity", "unreal"])
def test_assimp_reads_bones_and_motions(engine: str, files) -> None:
    told = readers.assimp(files[engine])
    assert told["animations"] == 2
    assert told["bones"] > 40


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here",
)
@pytest.mark.parametrize("engine", ["unity", "unreal"])
def test_the_khronos_validator_finds_nothing(engine: str, files) -> None:
    command = ["node", VALIDATOR, MODULES, files[engine]]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=120)
    issues = json.loads(done.stdout)["issues"]
    assert issues["numErrors"] == issues["numWarnings"] == 0
