"""What all tests share: where the samples lie, Qt without a screen, and one real clone a session."""

from __future__ import annotations

import fcntl
import os
import pickle
from pathlib import Path
from typing import TYPE_CHECKING, cast

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
    """Return the clone of samples/anna/plain, made once by the real pipeline in all formats; nobody writes into it.

    All processes of one run share it: the first that asks makes it, the others wait and read what it kept.
    """
    from cloner.cloning import clone_folder
    from cloner.exporters.table import EXPORTERS

    shared = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        shared = shared.parent  # a worker's own folder lies in the run's
    kept = shared / "cloned_anna.pickle"
    with (shared / "cloned_anna.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if kept.is_file():
            return cast("CloneOutcome", pickle.loads(kept.read_bytes()))
        made = clone_folder(SAMPLES / "anna" / "plain", shared / "cloned", formats=tuple(EXPORTERS), identifier="anna")
        kept.write_bytes(pickle.dumps(made))
        return made
