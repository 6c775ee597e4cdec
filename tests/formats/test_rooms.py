"""Rooms as glTF: nothing for the Khronos validator to say, and readers of others see the same room."""

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

from cloner.scenes.building.charts import make_charts
from cloner.scenes.building.gltf import LIGHT_MAP, room_glb
from cloner.scenes.building.reading import SHIPPED, read_plan
from cloner.scenes.building.solids import build_room
from kit import readers

MODULES = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node"))
VALIDATOR = Path(__file__).with_name("validate_gltf.mjs")


@pytest.fixture(scope="module", params=[(name, lit) for name in SHIPPED for lit in (False, True)])
def made(request, tmp_path_factory) -> tuple[Path, str, bool]:
    name, lit = request.param
    room = build_room(read_plan(name)[0])
    wide, tall = make_charts(room)[1]
    path = tmp_path_factory.mktemp("rooms") / f"{name}.glb"
    path.write_bytes(room_glb(room, np.full((tall, wide, 3), 0.7, np.float32) if lit else None))
    return path, name, lit


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here",
)
def test_the_khronos_validator_finds_nothing(made) -> None:
    command = ["node", VALIDATOR, MODULES, made[0]]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=120)
    issues = json.loads(done.stdout)["issues"]
    assert issues["numErrors"] == issues["numWarnings"] == 0, issues["messages"]


def test_trimesh_reads_the_room_where_the_plan_has_it(made) -> None:
    path, name, _ = made
    low, high = trimesh.load(path, force="scene").bounds
    plan = read_plan(name)[0]
    floors = np.array([[one.low, one.high] for one in plan.floors])
    assert (low[0], -high[2]) == pytest.approx(tuple(floors[:, 0].min(axis=0)), abs=0.81)  # walls around
    assert (high[0], -low[2]) == pytest.approx(tuple(floors[:, 1].max(axis=0)), abs=0.81)  # walls around
    assert low[1] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.skipif(not readers.HAS_ASSIMP, reason="assimp is not here; run: sudo apt-get install -y assimp-utils")
def test_assimp_reads_it(made) -> None:
    assert readers.assimp(made[0])["meshes"] >= (1 if made[1] == "pit" else 5)  # the pit is all earth


def test_the_light_map_hangs_on_every_material_and_only_when_lit(made) -> None:
    path, _, lit = made
    gltf = pygltflib.GLTF2().load_binary(str(path))
    held = [LIGHT_MAP in (one.extensions or {}) for one in gltf.materials]
    assert held == [lit] * len(gltf.materials)
    assert all(one.attributes.TEXCOORD_1 is not None for one in gltf.meshes[0].primitives)
