"""One failure does not stop a batch, what is finished is not done again, and a dead worker costs only its visitor."""

from __future__ import annotations

import csv
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from cloner import batch
from cloner.batch import BatchOptions, batch_folder, summary_table
from cloner.cloning import CloneOutcome, stamp_options
from cloner.commands.clones import pace
from cloner.errors import Cancelled, ClonerError
from cloner.project.claims import claim
from cloner.project.manifest import find_visitors, shard
from cloner.project.stamps import input_stamp, output_digests
from kit import farming


def visit(root: Path, *names: str) -> None:
    for number, name in enumerate(names):
        (root / name).mkdir(parents=True)
        Image.new("RGB", (80, 120), (number, 0, 0)).save(root / name / "body_front.jpg")


@pytest.fixture
def visitors(tmp_path: Path) -> Path:
    root = tmp_path / "photos"
    visit(root, "anna", "day 2/boris", "carl")
    (root / "notes").mkdir()
    return root


@pytest.fixture
def cloned(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Replace cloning by writing a result; carl fails, and return who was cloned."""
    done: list[str] = []

    def clone_folder(
        photos: Path, out: Path, *, identifier: str, formats: Any, seed: int, texture_size: int, height_cm: Any
    ) -> CloneOutcome:
        if identifier == "carl":
            raise ClonerError("no person found", "Retake it", "body_front.jpg")
        done.append(identifier)
        folder = out / identifier
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "clone.npz").write_text(identifier)
        stamp = input_stamp(photos, stamp_options(height_cm, formats, seed, texture_size))
        report = {"warnings": ["w"] if identifier == "anna" else [], "silhouette_iou": {"body_front": 0.97}}
        told = {**report, "stamp": stamp, "outputs": output_digests(folder, ["clone.npz"])}
        (folder / "report.json").write_text(json.dumps(told))
        return CloneOutcome(identifier, folder, report, {})

    monkeypatch.setattr(batch, "clone_folder", clone_folder)
    return done


def statuses(rows: tuple[Any, ...]) -> list[tuple[str, str]]:
    return [(row.identifier, row.status) for row in rows]


def test_visitors_are_the_folders_that_hold_photos(visitors: Path) -> None:
    found = find_visitors(visitors)
    assert {one.identifier: one.photos.name for one in found} == {
        "anna": "anna",
        "carl": "carl",
        "day-2-boris": "boris",
    }


def test_one_failure_does_not_stop_the_rest_and_all_is_told(visitors: Path, tmp_path: Path, cloned: list[str]) -> None:
    out, seen = tmp_path / "out", []
    rows = batch_folder(visitors, out, report=lambda row, done, of: seen.append((row.identifier, done, of)))
    assert statuses(rows) == [("anna", "cloned"), ("carl", "failed"), ("day-2-boris", "cloned")]
    assert seen == [("anna", 1, 3), ("carl", 2, 3), ("day-2-boris", 3, 3)]
    assert "body_front.jpg: no person found. Retake it" in rows[1].message
    told = json.loads((out / "batch.json").read_text())
    assert [row["status"] for row in told["rows"]] == ["cloned", "failed", "cloned"]
    assert "2 cloned, 0 skipped, 1 failed" in summary_table(rows)
    table = list(csv.DictReader((out / "batch.csv").read_text().splitlines()))
    assert [row["worst_iou"] for row in table] == ["0.97", "", "0.97"]
    sheet = (out / "batch.html").read_text()
    assert sheet.index("carl") < sheet.index("anna"), "the worst come first"


def test_current_results_are_skipped_and_stale_or_damaged_ones_made_again(
    visitors: Path, tmp_path: Path, cloned: list[str]
) -> None:
    out = tmp_path / "out"
    batch_folder(visitors, out)
    assert statuses(batch_folder(visitors, out))[0::2] == [("anna", "skipped"), ("day-2-boris", "skipped")]
    (out / "anna" / "clone.npz").write_text("half a fi")
    assert statuses(batch_folder(visitors, out))[0::2] == [("anna", "cloned"), ("day-2-boris", "skipped")]
    Image.new("RGB", (80, 120), (9, 9, 9)).save(visitors / "day 2" / "boris" / "body_front.jpg")
    assert statuses(batch_folder(visitors, out))[0::2] == [("anna", "skipped"), ("day-2-boris", "cloned")]
    assert statuses(batch_folder(visitors, out, BatchOptions(seed=1)))[0] == ("anna", "cloned")
    assert statuses(batch_folder(visitors, out, BatchOptions(seed=1, again=True)))[0] == ("anna", "cloned")
    assert statuses(batch_folder(visitors, out, BatchOptions(seed=1, texture_size=512)))[0] == ("anna", "cloned")


def test_a_defect_is_a_row_too(visitors: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: Any, **__: Any) -> CloneOutcome:
        raise ZeroDivisionError

    monkeypatch.setattr(batch, "clone_folder", broken)
    rows = batch_folder(visitors, tmp_path / "out")
    assert [row.status for row in rows] == ["failed"] * 3
    assert "ZeroDivisionError" in rows[0].message


@pytest.mark.parametrize("stop", [KeyboardInterrupt, Cancelled])
def test_stopping_keeps_the_rows_so_far(
    visitors: Path, tmp_path: Path, cloned: list[str], stop: type[BaseException]
) -> None:
    def told(row: Any, done: int, of: int) -> None:
        if done == 2:
            raise stop

    with pytest.raises(stop):
        batch_folder(visitors, tmp_path / "out", report=told)
    rows = json.loads((tmp_path / "out" / "batch.json").read_text())
    assert [row["identifier"] for row in rows["rows"]] == ["anna", "carl"]
    assert rows["visitors"] == 3


def test_an_empty_root_and_two_of_one_name_are_refused(visitors: Path, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    with pytest.raises(ClonerError, match="no folder below it holds photos"):
        find_visitors(tmp_path / "empty")
    visit(visitors, "day-2-boris")
    with pytest.raises(ClonerError, match="both be called day-2-boris"):
        find_visitors(visitors)


def test_shards_are_disjoint_and_together_everybody(visitors: Path) -> None:
    everybody = find_visitors(visitors)
    parts = [shard(everybody, f"{number}/2") for number in (0, 1)]
    assert sorted(one.identifier for part in parts for one in part) == [one.identifier for one in everybody]
    for wrong in ("2/2", "1", "a/b", "-1/2", "1/0"):
        with pytest.raises(ClonerError, match="is no shard"):
            shard(everybody, wrong)


def test_a_shard_tells_in_files_of_its_own(visitors: Path, tmp_path: Path, cloned: list[str]) -> None:
    rows = batch_folder(visitors, tmp_path / "out", BatchOptions(shard="1/2"))
    assert statuses(rows) == [("carl", "failed")]
    assert (tmp_path / "out" / "batch-1-of-2.json").is_file()


@pytest.mark.parametrize("suffix", ["csv", "toml"])
def test_a_manifest_names_photos_ids_and_heights(visitors: Path, suffix: str) -> None:
    path = visitors / f"list.{suffix}"
    if suffix == "csv":
        path.write_text("photos,id,height_cm\nanna,A 1,158\nday 2/boris,,\n")
    else:
        path.write_text(
            '[[visitor]]\nphotos = "anna"\nid = "A 1"\nheight_cm = 158\n[[visitor]]\nphotos = "day 2/boris"\n'
        )
    first, second = find_visitors(path)
    assert (first.identifier, first.photos.name, first.height_cm) == ("A-1", "anna", 158.0)
    assert (second.identifier, second.height_cm) == ("boris", None)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("photos\n../../etc\n", "beside or below"),
        ("photos\n/etc\n", "beside or below"),
        ("photos\n\n,\n", "more cells"),
        ("photos,height_cm\nanna,tall\n", "no height"),
        ("photos,colour\nanna,red\n", "unknown column colour"),
        ("photos,id\nanna,x\ncarl,x\n", "both be called x"),
        ("photos\nan\x00na\n", "name|read|beside"),
    ],
)
def test_broken_manifests_are_refused_in_words(visitors: Path, text: str, words: str) -> None:
    path = visitors / "list.csv"
    path.write_text(text)
    with pytest.raises(ClonerError, match=words):
        find_visitors(path)


def test_two_runs_never_clone_one_visitor_at_once(visitors: Path, tmp_path: Path, cloned: list[str]) -> None:
    out = tmp_path / "out"
    script = "import sys,time; from pathlib import Path; from cloner.project.claims import claim\n"
    script += "with claim(Path(sys.argv[1]), 'anna') as ours: print(ours, flush=True); time.sleep(60)"
    other = subprocess.Popen([sys.executable, "-c", script, str(out)], stdout=subprocess.PIPE, text=True)
    try:
        assert other.stdout is not None
        assert other.stdout.readline().strip() == "True"
        rows = batch_folder(visitors, out)
        assert rows[0].message == "another run is cloning it just now"
    finally:
        other.kill()
        other.wait()
    with claim(out, "anna") as ours:
        assert ours, "a killed run leaves no lock"


def test_names_cannot_become_formulas_or_tags(tmp_path: Path, visitors: Path, cloned: list[str]) -> None:
    from cloner.records.batches import BatchRow
    from cloner.report.batch import write_summary

    write_summary([BatchRow("a", "failed", 0.0, 0, "=1+1 <script>x</script>")], 1, tmp_path)
    assert "\"'=1+1" in (tmp_path / "batch.csv").read_text() or "'=1+1" in (tmp_path / "batch.csv").read_text()
    assert "<script>" not in (tmp_path / "batch.html").read_text()


def test_the_pace_is_told_from_the_second_on() -> None:
    assert pace(1, 10, 0.0) == ""
    assert "an hour" in pace(2, 10, 0.0)
    assert pace(10, 10, 0.0) == ""


@pytest.mark.slow
def test_a_crash_and_a_hang_cost_only_their_visitors(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two real worker processes: one visitor always kills its worker, one only the first time, one never ends."""
    root, out = tmp_path / "photos", tmp_path / "out"
    visit(root, "anna", "boris", "crash", "hang", "once", "zoe")
    monkeypatch.setattr(batch, "clone_in_worker", farming.pretend)
    rows = batch_folder(root, out, BatchOptions(workers=2, retries=1, timeout_s=5.0))
    assert statuses(rows) == [
        ("anna", "cloned"), ("boris", "cloned"), ("crash", "failed"), ("hang", "failed"), ("once", "cloned"),
        ("zoe", "cloned"),
    ]  # fmt: skip
    failed = {row.identifier: row.message for row in rows if row.status == "failed"}
    assert all("--timeout" in message for message in failed.values())
    assert {row.message for row in rows if row.status == "cloned"} != {rows[0].message}, "several processes worked"


@pytest.mark.slow
def test_workers_killed_while_they_start_are_started_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """Every worker process of the first seconds is killed, most of them before they have reached their scheduler."""
    root, out = tmp_path / "photos", tmp_path / "out"
    visit(root, "anna", "boris", "zoe")
    monkeypatch.setattr(batch, "clone_in_worker", farming.pretend)
    shot: list[int] = []
    with farming.shooting(shot, seconds=6.0):
        rows = batch_folder(root, out, BatchOptions(workers=2, retries=20))
    assert statuses(rows) == [("anna", "cloned"), ("boris", "cloned"), ("zoe", "cloned")], rows
    assert len(shot) > 2, "also workers started in place of others were killed"
    assert not capfd.readouterr().err, "an operator sees no trace"
