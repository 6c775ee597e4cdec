"""A statue in formats that know metal: glTF by the Khronos validator, USDZ by Pixar's library."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from cloner.exporters.gltf.gltf import export
from cloner.exporters.usd import export as export_usd
from cloner.records.clones import Clone
from cloner.statues.carved import statue_of
from kit.crowds import dressed_toy

VALIDATOR = Path(__file__).with_name("validate_gltf.mjs")
MODULES = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node"))


@pytest.fixture(scope="module")
def bronze() -> Clone:
    return statue_of(dressed_toy(), "bronze")


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here; run: npm install --prefix /tmp/cloner-node gltf-validator",
)
def test_the_khronos_validator_finds_nothing(bronze: Clone, tmp_path: Path) -> None:
    (path,) = export(bronze, tmp_path)
    done = subprocess.run(["node", VALIDATOR, MODULES, path], capture_output=True, text=True, check=True, timeout=120)
    assert json.loads(done.stdout)["issues"]["messages"] == []


def test_usd_reads_roughness_and_metal_from_the_same_picture(bronze: Clone, tmp_path: Path) -> None:
    pxr = pytest.importorskip("pxr.UsdShade")
    usd = pytest.importorskip("pxr.Usd")
    (path,) = export_usd(bronze, tmp_path)
    stage = usd.Stage.Open(str(path))
    surfaces = {
        str(prim.GetPath()): pxr.Shader(prim)
        for prim in stage.Traverse()
        if prim.IsA(pxr.Shader) and pxr.Shader(prim).GetIdAttr().Get() == "UsdPreviewSurface"
    }
    body = next(shader for place, shader in surfaces.items() if "atlas" in place)
    for channel, output in (("roughness", "g"), ("metallic", "b")):
        source, name, _ = body.GetInput(channel).GetConnectedSource()
        assert name == output
        assert "roughness" in str(source.GetPath())
    hair = next(shader for place, shader in surfaces.items() if "hair" in place)
    assert hair.GetInput("metallic").Get() == pytest.approx(1.0)
    people = export_usd(dressed_toy(), tmp_path, name="person")
    stage = usd.Stage.Open(str(people[0]))
    for prim in stage.Traverse():
        if prim.IsA(pxr.Shader) and pxr.Shader(prim).GetIdAttr().Get() == "UsdPreviewSurface":
            assert pxr.Shader(prim).GetInput("metallic").Get() == 0.0
