"""A body from measures is a result like any clone's."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cloner.bodies.made import remeasured_clone
from cloner.bodies.telling import BodySpecification
from cloner.bodies.written import body_folder
from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.motion.moves.own import own_motions
from cloner.personal_data.holdings import find_holding, holdings
from cloner.personal_data.privacy import forget
from cloner.picture import load_clone_at
from cloner.project.results import is_result
from cloner.records.heads import Shell
from cloner.records.regions import REGIONS


@pytest.fixture(scope="module")
def eva(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder, lines = body_folder(
        tmp_path_factory.mktemp("out"), "eva", sex="f", stature_cm=168.0, measures_cm={"bust": 92.0, "waist": 74.0},
        formats=("glb",), texture_size=512,
    )  # fmt: skip
    assert "bust_girth: told 92.0 cm, the mesh shows 92.0" in lines
    return folder


def test_it_is_listed_and_forgotten_like_a_clone(eva: Path, tmp_path: Path) -> None:
    assert is_result(eva)
    out = tmp_path / "out"
    out.mkdir()
    copy = out / "eva"
    copy.mkdir()
    for file in eva.rglob("*"):
        if file.is_file():
            place = copy / file.relative_to(eva)
            place.parent.mkdir(exist_ok=True)
            place.write_bytes(file.read_bytes())
    held = find_holding("eva", holdings(None, out))
    assert held.results == (copy,)
    assert not forget(held, None, out)
    assert not copy.exists()


def test_it_is_a_clone_that_moves_and_is_decent(eva: Path) -> None:
    clone = load_clone_at(eva)
    assert clone.stature_m == pytest.approx(1.68)
    assert clone.measures_mm["bust_girth"] == 920.0
    assert clone.consent  # a crowd takes it: nobody is shown
    assert "jawOpen" in clone.morph_names
    generic = load_generic()
    triangles, _ = generic.triangles()
    crotch = (triangles == generic.feature("crotch")).any(axis=1)
    assert set(clone.triangle_regions[crotch]) == {REGIONS.index("lower_clothes")}
    walk = own_motions(clone)[0]
    assert np.isfinite(walk.rotations).all()
    assert np.abs(walk.rotations).max() > 0.2


def test_a_clone_told_a_waist_keeps_its_head_and_its_ease(eva: Path) -> None:
    old = load_clone_at(eva)
    carried = np.zeros((3, 4), np.int32), np.tile([1.0, 0, 0, 0], (3, 1)), np.zeros((2, 2, 4), np.uint8)
    hair = Shell(old.vertices_m[:3] + 0.01, np.array([[0, 1, 2]], np.int32), np.zeros((3, 2)), *carried)
    dressed = replace(old, measures_mm=dict(old.measures_mm) | {"waist_girth": 700.0}, shells=(hair,))
    new = remeasured_clone(dressed, BodySpecification("f", old.stature_m, {"waist_girth": 800.0}))
    skull = load_generic().head_blend > 0.999
    assert np.ptp((new.vertices_m - old.vertices_m)[skull], axis=0).max() < 1e-5
    assert new.measures_mm["waist_girth"] == 800.0
    assert new.measures_mm["hip_girth"] > old.measures_mm["hip_girth"]  # people who have more there have more here
    assert np.abs(new.shells[0].vertices_m - hair.vertices_m).max() < 0.2
    assert new.atlas is old.atlas


def test_a_clone_told_its_stature_is_as_tall(eva: Path) -> None:
    old = load_clone_at(eva)
    new = remeasured_clone(old, BodySpecification("f", 1.80, {}))
    assert new.vertices_m[load_generic().feature("head_top"), 1] == pytest.approx(1.80, abs=1e-6)
    assert new.measures_mm["bust_girth"] == pytest.approx(old.measures_mm["bust_girth"] * 1.80 / 1.68, abs=2.0)


@pytest.mark.parametrize(
    ("sex", "stature", "told", "names"),
    [
        ("f", None, {}, "stature is missing"), ("f", 168.0, {"waist": 7.4}, "waist"),
        ("f", 168.0, {"wast": 74.0}, "wast"), ("", 168.0, {}, "sex"), ("f", float("inf"), {}, "stature"),
    ],
)  # fmt: skip
def test_what_cannot_be_leaves_nothing(
    tmp_path: Path, sex: str, stature: float | None, told: dict[str, float], names: str
) -> None:
    with pytest.raises(ClonerError, match=names):
        body_folder(
            tmp_path / "out", "x", sex=sex, stature_cm=stature, measures_cm=told, formats=("glb",), texture_size=512
        )
    assert not (tmp_path / "out").exists()


def test_a_changed_clone_belongs_to_the_same_visitor(eva: Path, tmp_path: Path) -> None:
    told = json.loads((eva / "report.json").read_text())
    told["stamp"]["photos"] = {"body_front": "a" * 64}
    source = tmp_path / "anna"
    source.mkdir()
    (source / "clone.npz").write_bytes((eva / "clone.npz").read_bytes())
    (source / "report.json").write_text(json.dumps(told))
    folder, _ = body_folder(
        tmp_path, "anna-stout", sex="", stature_cm=None, measures_cm={"waist": 80.0}, formats=(), texture_size=512,
        source=source,
    )  # fmt: skip
    assert json.loads((folder / "report.json").read_text())["stamp"]["photos"] == {"body_front": "a" * 64}
    assert load_clone_at(folder).stamp.startswith(load_clone_at(eva).stamp)
