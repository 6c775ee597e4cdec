"""Garments worn over one another: what is below is met like skin."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pygltflib
import pytest
from scipy.spatial import cKDTree
from typer.testing import CliRunner

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cli import app
from cloner.cloth import dressing
from cloner.cloth.dressing import DressedClone, dress_clone, find_pattern
from cloner.cloth.glb import glb
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.layered import Under
from cloner.errors import ClonerError
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.project.clone_file import load_clone, save_clone
from cloner.project.flow_file import load_flow
from cloner.records.clones import Clone


@pytest.fixture(scope="module")
def eva() -> Clone:
    return centre_joints(clone_of_measures(BodySpecification("f", 1.68, {"waist_girth": 740.0}), 512))


@pytest.fixture(scope="module")
def worn(eva: Clone) -> tuple[DressedClone, DressedClone, DressedClone]:
    """A dress, a coat over it, and the same coat over nothing."""
    walk, made = own_motions(eva)[0], []
    for name, fabric, over in (("dress", "silk", False), ("coat", "wool", True), ("coat", "wool", False)):
        pattern, ring = find_pattern(eva, name, None)
        under = made[0] if over else None
        made.append(dress_clone(eva, pattern, ring, FABRICS[fabric], walk, cycles=4, step_m=0.045, under=under))
    return made[0], made[1], made[2]


def below(inner: DressedClone, outer: DressedClone) -> float:
    """Return the share of an outer garment's points that lie inside an inner one, of those near it, in all frames."""
    shares = []
    for cloth, points in zip(inner.loop.frames_m, outer.loop.frames_m, strict=True):
        outward = vertex_normals(cloth, inner.worn.cloth.faces.astype(np.int32))
        away, near = cKDTree(cloth).query(points)
        high = np.einsum("ij,ij->i", points - cloth[near], outward[near])
        shares.append((high[away < 0.05] < -0.002).mean())
    return float(np.mean(shares))


def test_a_coat_lies_over_the_dress(worn: tuple[DressedClone, DressedClone, DressedClone]) -> None:
    inner, outer, alone = worn
    assert below(inner, outer) < 0.06
    assert below(inner, alone) > 2.0 * below(inner, outer), "over nothing it would pass through the dress"
    assert outer.layers == (inner, outer)
    assert np.isfinite(outer.loop.frames_m).all()


def test_both_are_in_the_file_and_move(worn: tuple[DressedClone, DressedClone, DressedClone]) -> None:
    gltf = pygltflib.GLTF2.load_from_bytes(glb(worn[1]))
    names = [mesh.name for mesh in gltf.meshes if mesh.name.startswith("Garment")]
    assert names == ["Garment", "Garment 2"]
    moved = {gltf.nodes[one.target.node].name for one in gltf.animations[0].channels if one.target.path == "weights"}
    assert moved >= set(names)
    assert [one.name for one in gltf.materials][-2:] == ["silk", "wool"]


def test_what_is_below_goes_into_its_loop_within_the_first_cycle() -> None:
    put, loop = (
        np.arange(14.0)[:, None, None] * np.ones((1, 2, 3)),
        100.0 + np.arange(4.0)[:, None, None] * np.ones((1, 2, 3)),
    )
    under = Under(np.array([[0, 1, 0]]), put, loop)
    assert under.at(3)[0, 0] == 3.0
    assert under.at(10)[0, 0] == 10.0  # the first cycle begins where it was simulated
    assert 13.0 < under.at(13)[0, 0] < 103.0
    assert under.at(14)[0, 0] == 100.0
    assert under.at(19)[0, 0] == 101.0


def test_the_command_takes_what_is_worn_over_it(eva: Clone, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    usual = dressing.Dressing.__init__.__kwdefaults__
    monkeypatch.setattr(dressing.Dressing.__init__, "__kwdefaults__", usual | {"cycles": 4, "step_m": 0.13})
    monkeypatch.setattr(dressing.dress_clone, "__kwdefaults__", dressing.dress_clone.__kwdefaults__ | {"cycles": 4})
    monkeypatch.setattr("cloner.cloth.written.STEP_M", 0.13)
    monkeypatch.setattr("cloner.cloth.written.FOLDER_STEP_M", 0.13)
    save_clone(eva, tmp_path / "clone.npz")
    out = tmp_path / "both.glb"
    asked = ["dress", str(tmp_path), "--garment", "trousers", "--over", "tee:denim", "--out", str(out)]
    told = CliRunner().invoke(app, asked)
    assert told.exit_code == 0, told.output
    assert told.output.count("loop of") == 2
    assert out.is_file()
    folder = tmp_path / "worn"
    skirted = ["dress", str(tmp_path), "--garment", "skirt", "--out", str(folder)]
    told = CliRunner().invoke(app, [*skirted, "--integrator", "elements", "--format", "glb"])
    assert told.exit_code == 0, told.output
    assert {path.name for path in folder.iterdir()} >= {"clone.npz", "cloth.npz", "clone.glb", "report.json"}
    assert load_flow(folder, load_clone(folder / "clone.npz")) is not None
    wrong = CliRunner().invoke(app, [*asked, "--integrator", "magic"])
    assert isinstance(wrong.exception, ClonerError)
    assert "threads or elements" in wrong.exception.hint
    wrong = CliRunner().invoke(app, [*asked[:-1], str(tmp_path / "x.glb"), "--over", "hat"])
    assert wrong.exit_code != 0
    assert not (tmp_path / "x.glb").exists()
