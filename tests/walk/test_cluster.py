"""Clusters that are there already: two give what one process gives, and one that vanishes loses nothing."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import pytest
from PIL import Image

from cloner import batch
from cloner.batch import BatchOptions, batch_folder
from cloner.errors import ClonerError
from cloner.machines.cluster import cluster
from cloner.machines.cluster_keys import make_keys
from kit import farming

pytestmark = pytest.mark.slow

NAMES = [f"v{number}" for number in range(6)]


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for number, name in enumerate(NAMES):
        (tmp_path / "photos" / name).mkdir(parents=True)
        Image.new("RGB", (80, 120), (number, 0, 0)).save(tmp_path / "photos" / name / "body_front.jpg")
    monkeypatch.setattr(batch, "clone_in_worker", farming.clone_pretended)
    monkeypatch.setattr(batch, "clone_folder", farming.write_result)
    return tmp_path / "photos"


@pytest.fixture
def keys(tmp_path: Path) -> Path:
    pytest.importorskip("cryptography", reason="certificates need the extra cluster")
    make_keys(tmp_path / "keys")
    return tmp_path / "keys"


@pytest.fixture
def clusters(keys: Path) -> Iterator[list[subprocess.Popen[str]]]:
    """Start two clusters of two workers each with certificates, in processes of their own."""
    started = [farming.start_cluster(str(keys)) for _ in range(2)]
    yield started
    for one in started:
        farming.end_cluster(one)


def contents(out: Path) -> dict[str, bytes]:
    return {path.relative_to(out).as_posix(): path.read_bytes() for path in sorted(out.glob("v*/*"))}


def test_two_clusters_give_what_one_process_gives_and_a_vanished_one_loses_nothing(
    root: Path, tmp_path: Path, keys: Path, clusters: list[subprocess.Popen[str]]
) -> None:
    places = [farming.address(cluster) for cluster in clusters]
    alone = tmp_path / "alone"
    assert {row.status for row in batch_folder(root, alone)} == {"cloned"}

    first = tmp_path / "first"
    rows = batch_folder(root, first, BatchOptions(scheduler=places[0], cluster_keys=keys))
    assert [(row.identifier, row.status) for row in rows] == [(name, "cloned") for name in NAMES]
    assert contents(first) == contents(alone)

    second = tmp_path / "second"
    done: list[str] = []

    def told(row: object, count: int, of: int) -> None:
        done.append(row.identifier)  # type: ignore[attr-defined]
        if count == 2:
            os.killpg(clusters[1].pid, signal.SIGKILL)

    with pytest.raises(ClonerError, match="scheduler has disappeared") as caught:
        batch_folder(root, second, BatchOptions(scheduler=places[1], cluster_keys=keys), report=told)
    assert "finished visitors are kept" in caught.value.hint
    assert 2 <= len(done) < len(NAMES)
    again = {
        row.identifier: row.status
        for row in batch_folder(root, second, BatchOptions(scheduler=places[0], cluster_keys=keys))
    }
    assert all(again[name] == "skipped" for name in done)
    assert contents(second) == contents(alone)


def test_the_sentence_survives_a_farewell_that_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    distributed = pytest.importorskip("distributed", reason="clusters need the extra cluster")
    client = SimpleNamespace(close=Mock(side_effect=RuntimeError("Cannot change state of expiring Timeout")))
    monkeypatch.setattr(distributed, "Client", lambda *_, **__: client)
    with pytest.raises(ClonerError, match="vanished"), cluster("tcp://127.0.0.1:1", unprotected=True):
        raise ClonerError("vanished", "Start it again", "cluster")
    client.close.assert_called_once()
