"""Full disks, read-only folders, clocks that jump, two batches at once: said in a sentence, nothing half-written."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from hostile.cases_photos import JPEG
from kit import farming

#: Saves a clone as `cloner clone` does; then says what happened to it.
SAVE = """
import sys
from pathlib import Path
from cloner.errors import ClonerError
from cloner.exporters.gltf import gltf
from cloner.exporters.vrml import vrml97
from cloner.project.atomic import result_folder
from cloner.project.clone_file import save_clone
from kit.clones import toy_clone
clone, out = toy_clone(), Path(sys.argv[1])
try:
    with result_folder(out, "anna") as folder:
        (folder / "report.json").write_text("{}")
        save_clone(clone, folder / "clone.npz")
        gltf.export(clone, folder)
        vrml97.export(clone, folder)
except ClonerError as error:
    print(error)
"""
BATCH = "from cloner.cli import main; main()"
FULL = "mount -t tmpfs -o size=300k none {out}"
READ_ONLY = "mount --bind {out} {out} && mount -o remount,ro,bind {out}"


@cache
def can_mount() -> bool:
    """Return whether this machine lets us mount inside a namespace of our own."""
    try:
        done = subprocess.run(
            ["unshare", "-rm", "mount", "-t", "tmpfs", "none", "/mnt"], capture_output=True, check=False
        )
    except OSError:
        return False
    return done.returncode == 0


def run_on(mount: str, out: Path, code: str, *arguments: object) -> tuple[subprocess.CompletedProcess[str], list[str]]:
    """Run code with ``out`` mounted in a certain way and return what was said and what ``out`` holds afterwards."""
    if not can_mount():
        pytest.skip("this machine lets nobody mount a full or read-only disk")
    out.mkdir(exist_ok=True)
    script = mount.format(out=out) + ' && { "$@"; code=$?; echo; ls -A ' + str(out) + "; exit $code; }"
    command = ["unshare", "-rm", "sh", "-c", script, "sh", sys.executable, "-c", code, *map(str, arguments)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=300)
    assert "Traceback" not in done.stderr, done.stderr
    said, _, left = done.stdout.rpartition("\n\n")
    return subprocess.CompletedProcess(command, done.returncode, said, done.stderr), left.split()


def test_a_full_disk(tmp_path: Path) -> None:
    done, left = run_on(FULL, tmp_path / "out", SAVE, tmp_path / "out")
    assert "cannot be written" in done.stdout, done.stderr
    assert "space" in done.stdout
    assert left == [], "something half-written was left"


def test_a_disk_that_is_full_to_the_last_byte(tmp_path: Path) -> None:
    full = FULL + " && head -c 400k /dev/zero > {out}/filler 2>/dev/null || true"
    done, left = run_on(full, tmp_path / "out", SAVE, tmp_path / "out")
    assert "cannot be written" in done.stdout, done.stderr
    assert left == ["filler"]


@pytest.mark.parametrize("command", ["clone", "batch"])
def test_a_read_only_folder(tmp_path: Path, command: str) -> None:
    photos = tmp_path / "photos" / "anna"
    photos.mkdir(parents=True)
    (photos / "body_front.jpg").write_bytes(JPEG)
    given = photos if command == "clone" else photos.parent
    done, left = run_on(READ_ONLY, tmp_path / "out", BATCH, command, given, "--out", tmp_path / "out")
    assert done.returncode == 2, done.stderr
    assert done.stderr.count("cloner: ") == 1
    assert "out: the results cannot be written there" in done.stderr
    assert left == []


def test_photos_on_a_read_only_disk_are_read(tmp_path: Path) -> None:
    (tmp_path / "photos").mkdir()
    (tmp_path / "photos" / "body_front.jpg").write_bytes(JPEG)
    code = "import sys; from pathlib import Path; from cloner.project.folder import load_photos\n"
    code += "print(len(load_photos(Path(sys.argv[1])).photos))"
    done, left = run_on(READ_ONLY, tmp_path / "photos", code, tmp_path / "photos")
    assert (done.stdout.strip(), left) == ("1", ["body_front.jpg"])


def test_forgetting_on_a_read_only_disk_says_so(tmp_path: Path) -> None:
    (tmp_path / "photos" / "anna").mkdir(parents=True)
    (tmp_path / "photos" / "anna" / "body_front.jpg").write_bytes(JPEG)
    done, left = run_on(READ_ONLY, tmp_path / "photos", BATCH, "forget", "anna", "--photos", tmp_path / "photos")
    assert done.returncode == 1
    assert "anna (cannot be deleted: " in done.stderr
    assert left == ["anna"]


#: A batch whose cloning is replaced by writing who made it, a little later.
PRETEND = """
import os, sys, time
from pathlib import Path
from cloner import batch
from cloner.batch import BatchOptions, batch_folder
from kit import farming
root, out = Path(sys.argv[1]), Path(sys.argv[2])
batch.clone_folder = farming.write_result
for row in batch_folder(root, out, BatchOptions()):
    print(row.identifier, row.status, row.message, sep="|")
"""


def test_two_batches_on_one_folder_share_the_work(tmp_path: Path) -> None:
    root, out = tmp_path / "photos", tmp_path / "out"
    names = [f"v{number:02}" for number in range(12)]
    for name in names:
        (root / name).mkdir(parents=True)
        (root / name / "body_front.jpg").write_bytes(JPEG)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", PRETEND, str(root), str(out)]
    both = [subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    said = [process.communicate(timeout=120)[0].splitlines() for process in both]
    rows = [dict(zip(("name", "status", "message"), line.split("|"), strict=True)) for lines in said for line in lines]
    cloned = [row["name"] for row in rows if row["status"] == "cloned"]
    assert sorted(cloned) == names, "everybody exactly once"
    assert {row["status"] for row in rows} == {"cloned", "skipped"}
    assert all((out / name / "report.json").is_file() for name in names)
    assert not [path.name for path in out.iterdir() if path.name.startswith(".")]


def test_a_clock_that_jumps_makes_nothing_stale(tmp_path: Path) -> None:
    (tmp_path / "photos" / "anna").mkdir(parents=True)
    (tmp_path / "photos" / "anna" / "body_front.jpg").write_bytes(JPEG)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", PRETEND, str(tmp_path / "photos"), str(tmp_path / "out")]

    def status() -> str:
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        return done.stdout.split("|")[1]

    assert status() == "cloned"
    for year in (1971, 2100):
        moment = (year - 1970) * 365.25 * 86_400
        for path in tmp_path.rglob("*"):
            os.utime(path, (moment, moment))
        assert status() == "skipped", year


def test_a_summary_is_whole_or_absent(tmp_path: Path) -> None:
    """The summaries are written in one step, so a reader never sees half of one."""
    farming.watch_summaries(tmp_path)
    assert json.loads((tmp_path / "batch.json").read_text())["visitors"] == 50
