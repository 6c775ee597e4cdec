"""What all tests share: where the samples lie, Qt without a screen, and one real clone a session."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import settings

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

# a busy machine is slow, not wrong; on CI every run tries the same examples
settings.register_profile("cloner", deadline=None, derandomize="CI" in os.environ)
settings.load_profile("cloner")

if TYPE_CHECKING:
    from cloner.cloning import CloneOutcome

SAMPLES = Path(__file__).resolve().parents[1] / "samples"


@pytest.fixture(scope="session")
def samples() -> Path:
    """Return the folder of the sample visitors."""
    return SAMPLES


@pytest.fixture(scope="session")
def cloned_anna(tmp_path_factory: pytest.TempPathFactory) -> CloneOutcome:
    """Return the clone of samples/anna/plain, made once a session by the real pipeline in all formats."""
    from cloner.cloning import clone_folder
    from cloner.exporters.table import EXPORTERS

    out = tmp_path_factory.mktemp("cloned")
    return clone_folder(SAMPLES / "anna" / "plain", out, formats=tuple(EXPORTERS), identifier="anna")
