"""What is held can be listed, handed out and forgotten, and nobody but the owner reads it."""

from __future__ import annotations

import json
import os
import shutil
import stat
import subprocess
import sys
import zipfile
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from PIL import Image

from cloner.errors import ClonerError
from cloner.personal_data.holdings import find_holding, holdings, older_than, table
from cloner.personal_data.privacy import export_data, forget
from cloner.project.atomic import result_folder
from cloner.project.claims import claim
from cloner.project.results import file_digest, place_digest
from cloner.project.stamps import output_digests
from cloner.records.batches import BatchRow
from cloner.report.batch import write_summary


def write_manifest(result: Path, photos: Path, digests: dict[str, str], person: str = "") -> None:
    """Write the manifest of a result as clones have it, listing what is there."""
    files = [path.relative_to(result).as_posix() for path in result.rglob("*") if path.is_file()]
    told = {"format": 3, "person": person, "photos": digests, "stamp": {"photos": digests}}
    told |= {"outputs": output_digests(result, files), "source": place_digest(photos)}
    (result / "report.json").write_text(json.dumps(told))


@pytest.fixture
def held(tmp_path: Path) -> tuple[Path, Path]:
    """Two visitors with photos, results and rows in the batch's summaries."""
    root, out = tmp_path / "photos", tmp_path / "out"
    rows = []
    for number, (name, person) in enumerate((("anna", "Anna Muster"), ("boris", "Boris Beispiel"))):
        (root / name).mkdir(parents=True)
        Image.new("RGB", (80, 120), (number, 7, 9)).save(root / name / "body_front.jpg")
        (root / name / "person.toml").write_text(
            f'name = "{person}"\nheight_cm = 160\nconsent = "cloning and showing, 2026-11-21 10:00"\n'
        )
        result = out / name / "previews"
        result.mkdir(parents=True)
        digest = file_digest(root / name / "body_front.jpg")
        (out / name / "report.html").write_text(f"<h1>Clone of {person}</h1>")
        (result / "face.jpg").write_bytes(f"picture {number}".encode())
        write_manifest(out / name, root / name, {"body_front": digest}, person)
        (out / f".{name}.claim").touch()
        rows.append(BatchRow(name, "cloned", 1.0, 0, "fine", 0.98))
    write_summary(rows, 2, out)
    return root, out


def test_everything_is_listed_with_its_consent(held: tuple[Path, Path]) -> None:
    anna, boris = holdings(*held)
    assert (anna.identifier, boris.identifier) == ("anna", "boris")
    assert anna.files == 5
    told = table((anna, boris))
    assert "cloning and showing, 2026-11-21" in told
    assert told.count("yes") == 4


def test_everything_is_handed_out_in_one_file(held: tuple[Path, Path], tmp_path: Path) -> None:
    path = export_data(find_holding("anna", holdings(*held)), tmp_path / "anna.zip")
    with zipfile.ZipFile(path) as archive:
        assert sorted(archive.namelist()) == [
            "anna/photos/body_front.jpg", "anna/photos/person.toml", "anna/result/previews/face.jpg",
            "anna/result/report.html", "anna/result/report.json",
        ]  # fmt: skip
    with pytest.raises(ClonerError, match="the file exists"):
        export_data(find_holding("anna", holdings(*held)), path)


def test_a_forgotten_visitor_leaves_no_file_name_or_digest(held: tuple[Path, Path]) -> None:
    root, out = held
    digest = file_digest(root / "anna" / "body_front.jpg")
    assert forget(find_holding("anna", holdings(root, out)), root, out) == ()
    everything = [path for folder in held for path in folder.rglob("*")]
    assert not [path for path in everything if "anna" in path.name.lower() or "forgotten" in path.name]
    for path in everything:
        if path.is_file():
            content = path.read_bytes()
            for trace in (b"anna", b"Anna Muster", digest.encode()):
                assert trace not in content, path
    assert [one.identifier for one in holdings(root, out)] == ["boris"], "nobody else is touched"
    assert json.loads((out / "batch.json").read_text())["visitors"] == 1


def test_what_somebody_copied_elsewhere_is_told(held: tuple[Path, Path]) -> None:
    root, out = held
    (out / "notes.txt").write_text("Anna Muster liked it")
    assert forget(find_holding("anna", holdings(root, out)), root, out) == ("notes.txt",)


def test_a_photo_or_thumbnail_that_somebody_copied_is_told(held: tuple[Path, Path]) -> None:
    root, out = held
    (out / "best").mkdir()
    shutil.copy(root / "anna" / "body_front.jpg", out / "best" / "1.jpg")
    shutil.copy(out / "anna" / "previews" / "face.jpg", root / "winner.jpg")
    shutil.copy(root / "boris" / "body_front.jpg", out / "best" / "2.jpg")
    told = forget(find_holding("anna", holdings(root, out)), root, out)
    assert sorted(told) == ["best/1.jpg", "winner.jpg"]


def test_broken_files_do_not_keep_anybody(held: tuple[Path, Path]) -> None:
    root, out = held
    (root / "anna" / "person.toml").write_text("name = [[[")
    (root / "anna" / "body_front.png").write_bytes(b"a second one")
    (out / "batch-other.json").write_text("[]")
    assert "unreadable" in table(holdings(root, out))
    assert forget(find_holding("anna", holdings(root, out)), root, out) == ()
    assert not (root / "anna").exists()


def test_a_result_whose_manifest_is_broken_is_told_not_deleted(held: tuple[Path, Path]) -> None:
    """Nobody can tell which of its files are Cloner's."""
    root, out = held
    (out / "anna" / "report.json").write_text("{")
    told = forget(find_holding("anna", holdings(root, out)), root, out)
    assert {one.split(" ")[0] for one in told} >= {"anna/report.json", "anna/previews/face.jpg"}
    assert (out / "anna" / "previews" / "face.jpg").is_file()
    assert not (root / "anna").exists()


def test_nobody_is_forgotten_under_a_running_clones_feet(held: tuple[Path, Path]) -> None:
    root, out = held
    anna = find_holding("anna", holdings(root, out))
    with claim(out, "anna"), pytest.raises(ClonerError, match="just now"):
        forget(anna, root, out)
    with result_folder(out, "anna"), pytest.raises(ClonerError, match="just now"):
        forget(anna, root, out)
    assert (root / "anna" / "body_front.jpg").is_file()


def test_lines_of_the_log_go_and_a_running_window_writes_on(held: tuple[Path, Path]) -> None:
    root, out = held
    log = root / "cloner.log"
    with log.open("a") as window:
        window.write("INFO cloner.cloning: anna: 12.0 s\nINFO cloner.cloning: anna-2: 13.0 s\nINFO anna.\n")
        window.flush()
        forget(find_holding("anna", holdings(root, out)), root, out)
        window.write("INFO later\n")
    assert log.read_text() == "INFO cloner.cloning: anna-2: 13.0 s\nINFO later\n"


def test_a_longer_name_is_somebody_else(held: tuple[Path, Path]) -> None:
    root, out = held
    with claim(out, "anna.b"), result_folder(out, "anna.b") as folder:
        forget(find_holding("anna", holdings(root, out)), root, out)
        assert folder.is_dir()
        assert (out / ".anna.b.claim").exists()


def test_files_of_the_future_are_kept_until_somebody_looks(held: tuple[Path, Path]) -> None:
    """A clock that jumped back must not make yesterday's visitors look a month old, nor the other way round."""
    root, out = held
    later = (datetime.now(UTC) + timedelta(days=400)).timestamp()
    os.utime(out / "anna" / "report.json", (later, later))
    assert older_than(holdings(root, out), 0.5) == ()
    assert f"{datetime.fromtimestamp(later, UTC):%Y-%m-%d}" in table(holdings(root, out))


def test_a_kill_half_way_is_finished_by_the_next_call(held: tuple[Path, Path]) -> None:
    root, out = held
    (root / "anna").rename(root / ".forgotten-1-2")
    assert find_holding("anna", holdings(root, out)).photos == ()
    forget(find_holding("anna", holdings(root, out)), root, out)
    assert not list(root.glob(".forgotten*"))


def test_retention_finds_the_old_ones(held: tuple[Path, Path]) -> None:
    root, out = held
    old = (datetime.now(UTC) - timedelta(days=40)).timestamp()
    for folder in (root / "anna", out / "anna"):
        for path in folder.rglob("*"):
            os.utime(path, (old, old))
    assert [one.identifier for one in older_than(holdings(root, out), 30)] == ["anna"]


def test_unknown_names_and_missing_folders_are_told(held: tuple[Path, Path], tmp_path: Path) -> None:
    with pytest.raises(ClonerError, match="nothing is held"):
        find_holding("zoe", holdings(*held))
    with pytest.raises(ClonerError, match="no such folder"):
        holdings(tmp_path / "nowhere", None)
    with pytest.raises(ClonerError, match="nowhere to look"):
        holdings(None, None)


def run(*arguments: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", "from cloner.cli import main; main()", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)


def test_the_commands_do_it(held: tuple[Path, Path], tmp_path: Path) -> None:
    root, out = held
    where = ("--photos", root, "--out", out)
    assert "boris" in run("list", *where).stdout
    assert run("export-data", "boris", "--to", tmp_path / "boris.zip", *where).returncode == 0
    assert stat.S_IMODE((tmp_path / "boris.zip").stat().st_mode) == 0o600
    done = run("forget", "boris", *where)
    assert done.returncode == 0, done.stderr
    assert not (root / "boris").exists()
    assert not (out / "boris").exists()
    assert run("forget", *where).returncode == 2


def test_results_are_the_owners_alone(cloned_anna, tmp_path: Path) -> None:
    """A result made by the command is private; the fixture is made by the library, which leaves that to its caller."""
    picture = tmp_path / "anna.png"
    assert run("render", cloned_anna.folder, "--out", picture, "--size", "64x64").returncode == 0
    assert stat.S_IMODE(picture.stat().st_mode) == 0o600
    assert stat.S_IMODE((cloned_anna.folder / "clone.glb").stat().st_mode) & 0o077 == 0


def test_no_camera_serial_or_place_reaches_the_results(tmp_path: Path, samples: Path, cloned_anna) -> None:
    """The samples carry EXIF; none of it but the focal length is in what a clone leaves."""
    for path in cloned_anna.folder.rglob("*"):
        if path.suffix == ".jpg":
            with Image.open(path) as image:
                assert not image.getexif()
