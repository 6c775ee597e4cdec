"""Two people of paint, and a small pack of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from cloner.crowd.packs.pack import make_pack
from kit.crowds import WANTED, lively_pack, two_results


@pytest.fixture(scope="session")
def results(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A batch's output with two results."""
    return two_results(tmp_path_factory.mktemp("results"))


@pytest.fixture(scope="session")
def pack(results: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("packs") / "pack"
    make_pack([results], out, WANTED)
    return out


@pytest.fixture(scope="session")
def lively(results: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A pack with the walks of feelings and the acts."""
    return lively_pack(results, tmp_path_factory.mktemp("lively") / "pack")
