"""clone.vrma as a VRM animation: bones by the format's names, the clone's own turns, expressions as weights."""

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

from cloner.exporters.avatars import vrma
from cloner.motion.limbs.body import body_of
from cloner.motion.moves.gait import idle, walk
from kit.clones import toy_clone

MODULES = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node"))
VALIDATOR = Path(__file__).with_name("validate_gltf.mjs")
BONES = ("hips", "spine", "head", "leftUpperLeg", "rightLowerLeg", "leftFoot", "leftUpperArm", "rightHand")


def blinking(posed):
    """The walk, one eye shut from the first frame to the last."""
    motion = walk(body_of(posed))
    shut = np.linspace(0.0, 1.0, len(motion.times_s))
    return (replace(motion, weights={"eyeBlinkLeft": shut}), idle(body_of(posed)))


@pytest.fixture(scope="module")
def path(tmp_path_factory) -> Path:
    return vrma.export(toy_clone(1.64), tmp_path_factory.mktemp("vrma"), moves=blinking)[0]


def numbers(gltf, accessor: int, width: int) -> np.ndarray:
    found = gltf.accessors[accessor]
    start = (gltf.bufferViews[found.bufferView].byteOffset or 0) + (found.byteOffset or 0)
    return np.frombuffer(gltf.binary_blob(), np.float32, found.count * width, start).reshape(-1, width)


def test_every_bone_has_its_name_and_eyes_are_left_to_the_gaze(path: Path) -> None:
    gltf = pygltflib.GLTF2().load_binary(str(path))
    told = gltf.extensions["VRMC_vrm_animation"]
    assert told["specVersion"] == "1.0"
    bones = told["humanoid"]["humanBones"]
    assert set(BONES) <= set(bones)
    assert "leftEye" not in bones, "the format leaves them out"
    moved = {channel.target.node for channel in gltf.animations[0].channels}
    assert bones["leftUpperLeg"]["node"] in moved
    assert len(gltf.animations) == 1
    assert not gltf.meshes


def test_a_hip_swings_as_far_as_in_a_walk_and_a_blink_is_a_way_along_x(path: Path) -> None:
    gltf = pygltflib.GLTF2().load_binary(str(path))
    told, made = gltf.extensions["VRMC_vrm_animation"], gltf.animations[0]
    track = {(channel.target.node, channel.target.path): made.samplers[channel.sampler] for channel in made.channels}
    hip = numbers(gltf, track[told["humanoid"]["humanBones"]["leftUpperLeg"]["node"], "rotation"].output, 4)
    np.testing.assert_allclose(np.linalg.norm(hip, axis=1), 1.0, atol=1e-5)
    swing = np.degrees(2.0 * np.arccos(np.clip(np.abs(hip @ hip[0]), 0.0, 1.0)).max())
    assert 25.0 < swing < 70.0, "people swing a thigh by 40 degrees in a walk"
    blink = numbers(gltf, track[told["expressions"]["preset"]["blinkLeft"]["node"], "translation"].output, 3)
    np.testing.assert_allclose(blink[[0, -1]], [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]], atol=1e-6)


def test_trimesh_reads_its_bones(path: Path) -> None:
    scene = trimesh.load(path, file_type="glb", force="scene")
    assert "l_hip" in scene.graph.nodes


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here",
)
def test_the_khronos_validator_finds_no_error(path: Path) -> None:
    done = subprocess.run(["node", VALIDATOR, MODULES, path], capture_output=True, text=True, check=True, timeout=120)
    issues = json.loads(done.stdout)["issues"]
    assert issues["numErrors"] == issues["numWarnings"] == 0
