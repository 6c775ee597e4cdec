"""Two people of paint, and a small pack of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from cloner.crowd.pack import make_pack
from kit.crowds import WANTED, dressed_toy, saved


@pytest.fixture(scope="session")
def results(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A batch's output with two results."""
    out = tmp_path_factory.mktemp("results")
    saved(out / "ada", dressed_toy())
    saved(out / "ben", dressed_toy(1.82, sleeves=True, shift=60))
    return out


@pytest.fixture(scope="session")
def pack(results: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("packs") / "pack"
    make_pack([results], out, WANTED)
    return out


@pytest.fixture(scope="session")
def lively(results: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A pack with the walks of feelings and the acts."""
    out = tmp_path_factory.mktemp("lively") / "pack"
    make_pack([results], out, replace(WANTED, vat=False, feelings=True))
    return out
