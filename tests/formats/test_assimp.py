"""Assimp and Open3D, which share a reader, take every GLB and VRM that does not say it needs an extension."""

from __future__ import annotations

from pathlib import Path

import pygltflib
import pytest

from cloner.exporters.table import EXPORTERS
from kit import readers
from kit.clones import toy_clone

STATURE_M = 1.64
FILES = ("clone.glb", "clone_mixamo.glb", "clone_vrm.glb")


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    made = tmp_path_factory.mktemp("assimp")
    for name in ("glb", "small", "mixamo", "vrm"):
        EXPORTERS.get(name)(toy_clone(STATURE_M), made)
    (made / "clone.vrm").rename(made / "clone_vrm.glb")  # both tell files by their last letters
    return made


@pytest.mark.parametrize("file", [*FILES, "clone_small.glb"])
def test_no_accessor_is_without_data(file: str, folder: Path) -> None:
    """The specification lets an accessor of zeros have neither view nor sparse values; Assimp 5 reads none such."""
    gltf = pygltflib.GLTF2().load_binary(str(folder / file))
    assert [a for a in gltf.accessors if a.bufferView is None and a.sparse is None] == []


@pytest.mark.skipif(not readers.HAS_ASSIMP, reason="assimp is not here; run: sudo apt-get install -y assimp-utils")
@pytest.mark.parametrize("file", FILES)
def test_assimp_reads_body_bones_and_motions(file: str, folder: Path) -> None:
    told = readers.assimp(folder / file)
    assert told["animations"] == 2
    assert told["meshes"] == 5
    assert told["bones"] > 50
    assert told["maximum_y"] - told["minimum_y"] == pytest.approx(STATURE_M + 0.01, abs=0.02)


@pytest.mark.parametrize("program", ["assimp_py", "open3d"])
@pytest.mark.parametrize("file", FILES)
def test_python_readers_take_all_meshes(program: str, file: str, folder: Path) -> None:
    if not readers.has_foreign(program):
        pytest.skip(f"{program} is not here; set CLONER_READERS_PYTHON to a Python that has it")
    told = readers.foreign(program, folder / file)
    assert told["meshes"] == 5
    assert told["height_m"] == pytest.approx(STATURE_M + 0.01, abs=0.02)
