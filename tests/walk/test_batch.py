"""One failure does not stop a batch, and what is finished is not done again."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from cloner import batch
from cloner.cloning import CloneOutcome
from cloner.errors import Cancelled, ClonerError


@pytest.fixture
def visitors(tmp_path: Path) -> Path:
    root = tmp_path / "photos"
    for name in ("anna", "day 2/boris", "carl", "notes"):
        (root / name).mkdir(parents=True)
    for name in ("anna", "day 2/boris", "carl"):
        Image.new("RGB", (80, 120)).save(root / name / "body_front.jpg")
    return root


@pytest.fixture
def cloned(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Replace cloning by writing a result; carl fails, and return who was cloned."""
    done: list[str] = []

    def clone_folder(photos: Path, out: Path, *, identifier: str, **options: Any) -> CloneOutcome:
        options["progress"]("views", 0.5)
        if identifier == "carl":
            raise ClonerError("no person found", "Retake it", "body_front.jpg")
        done.append(identifier)
        folder = out / identifier
        folder.mkdir(parents=True, exist_ok=True)
        for name in ("report.json", "clone.npz"):
            (folder / name).write_text("{}")
        return CloneOutcome(identifier, folder, {"warnings": ["w"] if identifier == "anna" else []}, {})

    monkeypatch.setattr(batch, "clone_folder", clone_folder)
    return done


def test_visitors_are_the_folders_that_hold_photos(visitors: Path) -> None:
    found = batch.find_visitors(visitors)
    assert {name: path.name for name, path in found.items()} == {"anna": "anna", "carl": "carl", "day-2-boris": "boris"}


def test_one_failure_does_not_stop_the_rest(visitors: Path, tmp_path: Path, cloned: list[str]) -> None:
    out = tmp_path / "out"
    fractions: list[float] = []
    rows = batch.batch_folder(visitors, out, progress=lambda step, fraction: fractions.append(fraction))
    assert [(row.identifier, row.status) for row in rows] == [
        ("anna", "cloned"),
        ("carl", "failed"),
        ("day-2-boris", "cloned"),
    ]
    assert "body_front.jpg: no person found. Retake it" in rows[1].message
    assert fractions == sorted(fractions)
    told = json.loads((out / "batch.json").read_text())
    assert [row["status"] for row in told["rows"]] == ["cloned", "failed", "cloned"]
    assert "2 cloned, 0 skipped, 1 failed" in batch.summary_table(rows)


def test_finished_visitors_are_skipped_unless_again(visitors: Path, tmp_path: Path, cloned: list[str]) -> None:
    out = tmp_path / "out"
    batch.batch_folder(visitors, out)
    rows = batch.batch_folder(visitors, out)
    assert [row.status for row in rows] == ["skipped", "failed", "skipped"]
    batch.batch_folder(visitors, out, again=True)
    assert cloned == ["anna", "day-2-boris", "anna", "day-2-boris"]


def test_a_defect_is_a_row_too(visitors: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: Any, **__: Any) -> CloneOutcome:
        raise ZeroDivisionError

    monkeypatch.setattr(batch, "clone_folder", broken)
    rows = batch.batch_folder(visitors, tmp_path / "out")
    assert [row.status for row in rows] == ["failed"] * 3
    assert "ZeroDivisionError" in rows[0].message


@pytest.mark.parametrize("stop", [KeyboardInterrupt, Cancelled])
def test_stopping_keeps_the_rows_so_far(
    visitors: Path, tmp_path: Path, cloned: list[str], stop: type[BaseException]
) -> None:
    def progress(step: str, fraction: float) -> None:
        if step.startswith("day-2-boris"):
            raise stop

    with pytest.raises(stop):
        batch.batch_folder(visitors, tmp_path / "out", progress=progress)
    told = json.loads((tmp_path / "out" / "batch.json").read_text())
    assert [row["identifier"] for row in told["rows"]] == ["anna", "carl"]
    assert told["visitors"] == 3


def test_an_empty_root_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ClonerError, match="no folder below it holds photos"):
        batch.find_visitors(tmp_path)


def test_two_visitors_of_one_name_are_refused(visitors: Path) -> None:
    (visitors / "day-2-boris").mkdir()
    Image.new("RGB", (80, 120)).save(visitors / "day-2-boris" / "body_front.jpg")
    with pytest.raises(ClonerError, match="both be called day-2-boris"):
        batch.find_visitors(visitors)
