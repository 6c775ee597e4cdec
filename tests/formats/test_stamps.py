"""Every format says what made it, and the same clone gives the same bytes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from cloner import __version__
from cloner.exporters.table import EXPORTERS
from cloner.project.clone_file import load_clone, save_clone
from cloner.project.stamps import digest_of_models, stamp_text
from cloner.records.clones import Clone
from kit.clones import toy_clone

STAMP = stamp_text(7, 1024)


@pytest.fixture(scope="module")
def clone() -> Clone:
    return replace(toy_clone(), stamp=STAMP)


def test_a_stamp_says_version_models_generic_and_options() -> None:
    for words in (f"Cloner {__version__}", digest_of_models()[:16], "generic ", "seed 7", "texture 1024"):
        assert words in STAMP
    assert stamp_text(8, 1024) != STAMP


@pytest.mark.parametrize("name", list(EXPORTERS))
def test_every_format_carries_it_and_comes_out_the_same(name: str, clone: Clone, tmp_path: Path) -> None:
    files = EXPORTERS.get(name)(clone, tmp_path / "first")
    again = EXPORTERS.get(name)(clone, tmp_path / "second")
    assert any(STAMP.encode() in path.read_bytes() for path in files), f"{name} does not say what made it"
    for one, other in zip(files, again, strict=True):
        assert one.read_bytes() == other.read_bytes(), f"{one.name} differs"


def test_the_clones_own_file_keeps_it_and_lets_nothing_else_in(clone: Clone, tmp_path: Path) -> None:
    save_clone(clone, tmp_path / "a.npz")
    assert load_clone(tmp_path / "a.npz").stamp == STAMP
    save_clone(replace(clone, stamp='x"/><script>\n]'), tmp_path / "b.npz")
    assert load_clone(tmp_path / "b.npz").stamp == "xscript"
