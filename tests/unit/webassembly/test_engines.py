"""The engines are what their sources say."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path

import numpy as np
import pytest

from cloner.cloth.simulation.core.host import ClothEngine
from cloner.errors import ClonerError
from kit.scripts import script

BUILD = script("build_engine")
PACKAGES = Path(os.environ.get("CLONER_NODE_MODULES", "/nowhere"))
ENGINES = pytest.mark.parametrize("core", BUILD.ENGINES, ids=lambda core: core.relative_to(BUILD.CLONER).parts[0])


@ENGINES
def test_a_module_is_what_its_provenance_says(core: Path) -> None:
    told = json.loads((core / "PROVENANCE.json").read_text(encoding="utf-8"))[0]
    assert told["sha256"] == hashlib.sha256((core / BUILD.MODULE).read_bytes()).hexdigest()
    assert told["source"] == BUILD.source_digests(core), "generic_models/build/build_engine.py was not run"


@pytest.mark.skipif(not (PACKAGES / "node_modules" / "assemblyscript").is_dir(), reason="no AssemblyScript here")
@ENGINES
def test_a_module_is_built_again_to_the_byte(core: Path) -> None:
    assert BUILD.built(core, PACKAGES) == (core / BUILD.MODULE).read_bytes()


def test_arrays_outlive_their_engine() -> None:
    """Who holds an array holds the memory: it is neither freed nor moved, and no two are the same."""
    core = ClothEngine(vertices=3, skins=2)
    places = core.arrays["place"]
    places[:] = np.arange(9.0).reshape(3, 3)
    del core
    others = [ClothEngine(vertices=3) for _ in range(3)]
    assert places.tolist() == np.arange(9.0).reshape(3, 3).tolist()
    assert all(not other.arrays["place"].any() for other in others)


def test_more_than_fits_is_refused() -> None:
    with pytest.raises(ClonerError, match="memory"):
        ClothEngine(vertices=2**25)
