"""clone_lods.glb: the clone as it is, and coarser levels over the same vertices beside its scene."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pygltflib
import pytest

from cloner.crowd.clones import lods
from cloner.crowd.clones.levels import LOOSE
from cloner.exporters.gltf import gltf
from kit import readers
from kit.beards import bearded_clone
from kit.clones import toy_clone
from kit.compare_clones import snapshot

VALIDATOR = Path(__file__).with_name("validate_gltf.mjs")
MODULES = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node"))
STATURE_M = 1.64


@pytest.fixture(scope="module")
def path(tmp_path_factory) -> Path:
    clone = toy_clone(STATURE_M)
    before = snapshot(clone)
    (made,) = lods.export(clone, tmp_path_factory.mktemp("lods"))
    assert snapshot(clone) == before
    return made


@pytest.fixture(scope="module")
def file(path: Path):
    return pygltflib.GLTF2().load_binary(str(path))


def drawn(file, level: int = 0) -> dict[str, list]:
    """The primitives of what the scene draws, or of a coarser level, by their meshes' names."""
    shown = [file.nodes[node] for node in file.scenes[file.scene].nodes]
    nodes = shown if level == 0 else [node for node in file.nodes if (node.name or "").endswith(f"_LOD{level}")]
    return {node.name: file.meshes[node.mesh].primitives for node in nodes if node.mesh is not None}


def triangles(file, primitives: list) -> int:
    return sum(file.accessors[one.indices].count // 3 for one in primitives)


def test_the_scene_that_is_shown_is_the_whole_clone_and_nothing_else(file, tmp_path: Path) -> None:
    assert [scene.name for scene in file.scenes] == ["clone"]
    whole = gltf.build(lods.centre_joints(toy_clone(STATURE_M)))
    assert list(drawn(file)) == [mesh.name for mesh in whole.meshes]
    sizes = [triangles(file, primitives) for primitives in drawn(file).values()]
    assert sizes == [triangles(whole, mesh.primitives) for mesh in whole.meshes]


def test_levels_are_named_and_fewer_and_share_vertices_targets_and_skin(file) -> None:
    whole, sizes = drawn(file), []
    for level in range(1, 5):
        found = drawn(file, level)
        assert list(found) == [f"{name}_LOD{level}" for name in whole]
        for name, primitives in found.items():
            full = whole[name.removesuffix(f"_LOD{level}")]
            for own, same in zip(primitives, full, strict=False):
                assert vars(own.attributes) == vars(same.attributes)
                assert own.targets == same.targets
                assert own.material == same.material
                corners = file.accessors[own.indices]
                view = file.bufferViews[corners.bufferView]
                kind = {5123: np.uint16, 5125: np.uint32}[corners.componentType]
                index = np.frombuffer(file.binary_blob(), kind, corners.count, view.byteOffset)
                assert index.max() < file.accessors[own.attributes.POSITION].count
        sizes.append(sum(triangles(file, primitives) for primitives in found.values()))
    assert all(finer > coarser for finer, coarser in pairwise(sizes))
    assert sizes[-1] < 0.12 * sum(triangles(file, primitives) for primitives in whole.values())
    assert sizes[-1] <= 1_500 + LOOSE[-1], "the crowd's own bar for the coarsest"


def test_four_levels_cost_few_bytes(path: Path, file) -> None:
    whole = len(lods.glb_bytes(gltf.build(lods.centre_joints(toy_clone(STATURE_M)))))
    assert path.stat().st_size - whole < 220_000


def test_a_beard_has_levels_too(tmp_path: Path) -> None:
    (made,) = lods.export(bearded_clone(), tmp_path)
    file = pygltflib.GLTF2().load_binary(str(made))
    assert len(drawn(file, 1)["Body_LOD1"]) == 3, "body, eyes and beard"


def test_frizz_is_whole_in_the_clone_and_in_no_coarser_level(tmp_path: Path) -> None:
    """Its cards hang together nowhere: a simplifier that was asked for fewer of them looked for them for ever."""
    clone = toy_clone(STATURE_M)
    (hair,) = [shell for shell in clone.shells if shell.kind == "hair"]
    alone = hair.triangles.reshape(-1)
    cards = replace(
        hair,
        kind="frizz",
        vertices_m=hair.vertices_m[alone] + np.arange(len(alone))[:, None] * 1e-5,
        triangles=np.arange(len(alone), dtype=np.int32).reshape(-1, 3),
        uv=hair.uv[alone],
        skin_joints=hair.skin_joints[alone],
        skin_weights=hair.skin_weights[alone],
    )
    (made,) = lods.export(replace(clone, shells=(*clone.shells, cards)), tmp_path)
    file = pygltflib.GLTF2().load_binary(str(made))
    assert "Frizz" in drawn(file)
    for level in range(1, 5):
        assert list(drawn(file, level)) == [f"{name}_LOD{level}" for name in drawn(file) if name != "Frizz"]


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here; run: npm install --prefix /tmp/cloner-node gltf-validator",
)
def test_the_khronos_validator_finds_only_that_levels_wait_beside_the_scene(path: Path, file) -> None:
    done = subprocess.run(["node", VALIDATOR, MODULES, path], capture_output=True, text=True, check=True, timeout=120)
    issues = json.loads(done.stdout)["issues"]
    assert issues["numErrors"] == issues["numWarnings"] == issues["numHints"] == 0
    waiting = [f"/nodes/{row}" for row, node in enumerate(file.nodes) if "_LOD" in (node.name or "")]
    assert [(one["code"], one["pointer"]) for one in issues["messages"]] == [("UNUSED_OBJECT", row) for row in waiting]


@pytest.mark.skipif(not readers.HAS_ASSIMP, reason="assimp is not here; run: sudo apt-get install -y assimp-utils")
def test_a_foreign_reader_sees_the_clone_once(path: Path) -> None:
    assert readers.assimp(path)["meshes"] == 5


@pytest.mark.slow
@pytest.mark.skipif(
    not readers.HAS_THREE, reason="three, esbuild or Chromium is not here; run: npm install three esbuild"
)
def test_three_shows_the_whole_clone_walking(path: Path) -> None:
    """An armature that several scenes share would hang in one of them only there."""
    _, told = readers.three(path)
    assert told.get("error") is None
    assert told["meshes"] > 4
    assert told["moved_m"] > 0.05
