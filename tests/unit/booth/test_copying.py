"""What is copied to a stick is there whole and right, or not at all."""

import os
import signal
import subprocess
import sys

import pytest

from cloner.booth.handover import copying
from cloner.errors import Cancelled, ClonerError


def quiet(step, fraction):
    pass


@pytest.fixture
def source(tmp_path):
    folder = tmp_path / "made"
    (folder / "previews").mkdir(parents=True)
    (folder / "clone.glb").write_bytes(bytes(range(256)) * 9000)
    (folder / "previews" / "face.jpg").write_bytes(b"face")
    return folder


def test_a_folder_arrives_with_every_byte_and_tells_how_far_it_is(source, tmp_path):
    told = []
    target = copying.copy_verified(source, tmp_path / "stick-7", lambda *one: told.append(one))
    assert (target / "clone.glb").read_bytes() == bytes(range(256)) * 9000
    assert (target / "previews" / "face.jpg").read_bytes() == b"face"
    assert [step for step, _ in told] == sorted(step for step, _ in told), "all is copied, then all is read back"
    fractions = [fraction for _, fraction in told]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0
    assert {path.name for path in tmp_path.iterdir()} == {"made", "stick-7"}


def test_a_stick_that_loses_what_is_written_on_it_is_found_out(source, tmp_path, monkeypatch):
    true = os.fsync

    def lie(number):
        true(number)
        path = os.readlink(f"/proc/self/fd/{number}")
        if path.endswith("clone.glb"):
            with open(path, "r+b") as file:
                file.seek(1_000_000)
                file.write(b"\xff\xfe")

    monkeypatch.setattr(copying.os, "fsync", lie)
    with pytest.raises(ClonerError, match="reads differently"):
        copying.copy_verified(source, tmp_path / "stick-7", quiet)
    assert {path.name for path in tmp_path.iterdir()} == {"made"}


def test_stopped_in_the_middle_nothing_is_left(source, tmp_path):
    def stop(step, fraction):
        if step == "verify":
            raise Cancelled

    with pytest.raises(Cancelled):
        copying.copy_verified(source, tmp_path / "stick-7", stop)
    assert {path.name for path in tmp_path.iterdir()} == {"made"}


def test_killed_while_copying_there_is_no_half_file_and_the_next_copy_clears_up(source, tmp_path):
    code = (
        "import sys, time; from pathlib import Path; from cloner.booth.handover.copying import copy_verified\n"
        "def slow(step, fraction): print(step, flush=True); time.sleep(0.3)\n"
        "copy_verified(Path(sys.argv[1]), Path(sys.argv[2]), slow)"
    )
    target = tmp_path / "stick-7"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    process = subprocess.Popen(
        [sys.executable, "-c", code, str(source), str(target)], stdout=subprocess.PIPE, env=environment
    )
    assert process.stdout.readline() == b"copy\n"
    process.send_signal(signal.SIGKILL)
    process.wait()
    assert not target.exists()
    assert len(list(tmp_path.glob(".stick-7.partial-*"))) == 1
    copying.copy_verified(source, target, quiet)
    assert {path.name for path in tmp_path.iterdir()} == {"made", "stick-7"}
