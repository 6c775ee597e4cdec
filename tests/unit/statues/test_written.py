"""A statue is a result like any clone's, and belongs to the same visitor."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cloner.cli import app
from cloner.crowd.clones.people import find_people, load_person
from cloner.errors import ClonerError
from cloner.picture import load_clone_at
from cloner.project.results import is_result, read_manifest
from cloner.report.write import write_report
from cloner.statues.written import statue_folder
from kit.crowds import dressed_toy, saved


@pytest.fixture(scope="module")
def visitor(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = saved(tmp_path_factory.mktemp("results") / "ada", dressed_toy())
    write_report({"format": 9, "source": "abc", "outputs": {}, "stamp": {"photos": {"body_front": "00ff"}}}, folder)
    return folder


def test_it_is_a_whole_result_of_the_same_visitor_and_fit_for_a_crowd(visitor: Path, tmp_path: Path) -> None:
    folder = statue_folder(visitor, tmp_path, material="stone", pose="guard", formats=("glb",))
    assert folder.name == "ada-stone"
    assert is_result(folder)
    manifest = read_manifest(folder)
    assert manifest is not None
    assert (manifest.source, manifest.inputs) == ("abc", {"body_front": "00ff"})
    assert manifest.stamp["options"] == {"material": "stone", "pose": "guard"}
    clone, _ = load_person(find_people([folder])[0], "")
    assert clone.consent
    assert clone.atlas.shine.size
    assert "stone" in clone.stamp


def test_the_command_takes_a_clone_as_its_first_word(visitor: Path, tmp_path: Path) -> None:
    for number, words in enumerate((["statue"], ["statue", "make"])):
        out = tmp_path / str(number)
        told = CliRunner().invoke(app, [*words, str(visitor), "--material", "clay", "--format", "", "--out", str(out)])
        assert told.exit_code == 0, told.output
        assert load_clone_at(out / "ada-clay").atlas.shine.size
    assert np.array_equal(*(load_clone_at(tmp_path / one / "ada-clay").atlas.rgb for one in "01"))


@pytest.mark.parametrize("wrong", [{"material": "jade"}, {"pose": "lotus"}, {"formats": ("doc",)}])
def test_what_is_not_known_is_refused_before_anything_is_written(visitor: Path, tmp_path: Path, wrong) -> None:
    wanted = {"material": "stone", "pose": "rest", "formats": ()} | wrong
    with pytest.raises(ClonerError):
        statue_folder(visitor, tmp_path, **wanted)
    assert not list(tmp_path.iterdir())
