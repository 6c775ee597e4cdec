"""How every command ends: its exit codes and signals, as docs/exit_codes.md has them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import pytest

from cloner import cli, terminal
from cloner.project.clone_file import save_clone
from cloner.terminal import EXIT_DEFECT, out_of_memory, run_command, sentence_of
from hostile.cases_photos import JPEG
from kit.clones import toy_clone

MAIN = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\nfrom cloner.cli import main; main()"
WINDOW = """
import signal, sys
from cloner.cli import main
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
app = QApplication(sys.argv[:1])
QTimer.singleShot(1500, lambda: print("open", flush=True))
sys.argv = ["cloner", "gui"]
main()
"""
STOPPING = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


def environment() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "QT_QPA_PLATFORM": "offscreen"}


def through_shell(redirection: str, arguments: Sequence[object], limit: str = "") -> subprocess.CompletedProcess[str]:
    """Run a command with its streams closed, full or lost."""
    script = f'{limit} "$0" -c "$1" "${{@:2}}" {redirection}'
    command = ["bash", "-c", script, sys.executable, MAIN, *map(str, arguments)]
    return subprocess.run(command, env=environment(), capture_output=True, text=True, check=False, timeout=120, cwd="/")


@pytest.fixture
def root(tmp_path: Path) -> Path:
    (tmp_path / "photos" / "anna").mkdir(parents=True)
    (tmp_path / "photos" / "anna" / "body_front.jpg").write_bytes(JPEG)
    return tmp_path / "photos"


@pytest.mark.slow
@pytest.mark.parametrize("number", STOPPING)
def test_a_clone_that_is_stopped_leaves_nothing(tmp_path: Path, samples: Path, number: signal.Signals) -> None:
    out = tmp_path / "out"
    arguments = ["clone", samples / "anna" / "plain", "--out", out]
    process = subprocess.Popen(
        [sys.executable, "-c", MAIN, *map(str, arguments)], env=environment(), stderr=subprocess.PIPE, text=True
    )
    over = time.monotonic() + 60
    while not list(out.glob(".*.partial-*")) and time.monotonic() < over and process.poll() is None:
        time.sleep(0.05)
    process.send_signal(number)
    _, told = process.communicate(timeout=60)
    assert process.returncode == terminal.EXIT_CANCELLED, told
    assert "stopped" in told
    assert not out.exists()


@pytest.mark.slow
@pytest.mark.gui
@pytest.mark.parametrize("number", STOPPING)
def test_a_window_that_is_asked_to_end_does(number: signal.Signals) -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", WINDOW], env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "open\n"
    process.send_signal(number)
    _, told = process.communicate(timeout=30)
    assert process.returncode == terminal.EXIT_CANCELLED, told
    assert "Traceback" not in told


def test_nohup_is_obeyed(tmp_path: Path, root: Path) -> None:
    code = "import os, signal; signal.signal(signal.SIGHUP, signal.SIG_IGN)\n"
    code += "from cloner import cli, terminal\n"
    code += "cli.run_command = lambda work: os.kill(os.getpid(), signal.SIGHUP) or 0\ncli.main()"
    assert subprocess.run([sys.executable, "-c", code], env=environment(), check=False).returncode == 0


@pytest.mark.parametrize(
    ("redirection", "code", "words"),
    [
        ("", 0, ""),
        (">&-", 2, "standard output: it is closed"),
        ("> /dev/full", 2, "No space left on device"),
        ("2>&-", 0, ""),
        ("2> /dev/full", 0, ""),
        ("2> >(exec true)", 0, ""),
        ("| head -c 1 > /dev/null; exit ${PIPESTATUS[0]}", 0, ""),
    ],
)
def test_streams_that_are_closed_full_or_left(root: Path, redirection: str, code: int, words: str) -> None:
    done = through_shell(redirection, ["list", "--photos", root])
    assert done.returncode == code, done.stderr
    assert words in done.stderr
    assert "Traceback" not in done.stderr
    assert "Exception ignored" not in done.stderr


@pytest.mark.parametrize("redirection", ["2>&-", "2> /dev/full", "2> >(exec true)"])
def test_a_complaint_that_nobody_hears_ends_with_its_own_code(root: Path, redirection: str) -> None:
    assert (
        through_shell(redirection, ["clone", root / "nobody", "--out", root / "out"]).returncode == terminal.EXIT_INPUT
    )
    assert through_shell(redirection, ["batch", root, "--out", root / "out"]).returncode == terminal.EXIT_SOME_FAILED


@pytest.fixture(scope="module")
def clone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("good") / "clone.npz"
    save_clone(toy_clone(), path)
    return path


@pytest.mark.parametrize("length", [300, 5000])
@pytest.mark.parametrize(
    "arguments",
    [
        ("clone", "LONG", "--out", "OUT"), ("clone", "PHOTOS", "--out", "LONG"), ("batch", "LONG", "--out", "OUT"),
        ("batch", "PHOTOS", "--out", "LONG"), ("render", "LONG", "--out", "OUT"), ("render", "CLONE", "--out", "LONG"),
        ("animate", "CLONE", "LONG.bvh", "--out", "OUT.glb"), ("animate", "CLONE", "CLONE", "--out", "LONG.glb"),
        ("list", "--photos", "LONG"), ("forget", "anna", "--out", "LONG"), ("export-data", "anna", "--to", "LONG",
        "--photos", "PHOTOS"), ("evaluate", "LONG"), ("cluster", "keys", "LONG"),
    ],
)  # fmt: skip
def test_paths_longer_than_any_file_system_takes_have_a_sentence(
    tmp_path: Path, root: Path, clone: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str],
    arguments: tuple[str, ...], length: int,
) -> None:  # fmt: skip
    given = {"PHOTOS": root, "CLONE": clone, "OUT": tmp_path / "out", "OUT.glb": tmp_path / "o.glb",
             "LONG": tmp_path / ("n" * length)}  # fmt: skip
    given |= {f"LONG{end}": f"{given['LONG']}{end}" for end in (".bvh", ".glb")}  # type: ignore[dict-item]
    monkeypatch.setattr(sys, "argv", ["cloner", *(str(given.get(word, word)) for word in arguments)])
    before, mask = [signal.getsignal(one) for one in STOPPING], os.umask(0o077)
    try:
        with pytest.raises(SystemExit) as caught:
            cli.main()
    finally:
        os.umask(mask)
        for number, handler in zip(STOPPING, before, strict=True):
            signal.signal(number, handler)
    told = [line for line in capfd.readouterr().err.splitlines() if line.startswith("cloner: ")]
    assert caught.value.code == terminal.EXIT_INPUT, told
    assert len(told) == 1
    assert len(told[0]) < 1500


@pytest.mark.parametrize("limit_kib", [700_000, 1_000_000, 1_800_000, 2_400_000])
def test_too_little_memory_has_a_sentence_before_anything_is_begun(
    tmp_path: Path, samples: Path, limit_kib: int
) -> None:
    # Whether a library raises an error or ends the process where memory ends is the machine's luck.
    arguments = ["clone", samples / "anna" / "plain", "--out", tmp_path / "out"]
    done = through_shell("", arguments, f"ulimit -v {limit_kib};")
    assert done.returncode == terminal.EXIT_INPUT, done.stderr[-2000:]
    assert "not enough memory" in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "error",
    [MemoryError(), OSError(12, "Cannot allocate memory"), RuntimeError("can't start new thread"),
     RuntimeError("std::bad_alloc"),
     RuntimeError("XNNPack delegate failed to reshape runtime"),
     ImportError("libx.so: failed to map segment from shared object")],
)  # fmt: skip
def test_every_way_of_having_no_memory_is_known(error: Exception) -> None:
    assert out_of_memory(error)
    assert "memory" in sentence_of(error)


def test_a_defect_is_called_one(capsys: pytest.CaptureFixture[str]) -> None:
    def broken() -> None:
        raise ZeroDivisionError

    assert run_command(broken) == EXIT_DEFECT
    assert "a defect of Cloner (ZeroDivisionError)" in capsys.readouterr().err


def test_the_page_of_exit_codes_is_the_programs() -> None:
    """Every number of the table is one of the program's, and the other way round."""
    page = (Path(__file__).resolve().parents[2] / "docs" / "exit_codes.md").read_text(encoding="utf-8")
    rows = [line.split("|")[1].strip() for line in page.splitlines() if line.startswith("| ")]
    codes = {int(row) for row in rows if row.isdigit()}
    assert codes == {0, terminal.EXIT_SOME_FAILED, terminal.EXIT_INPUT, EXIT_DEFECT, terminal.EXIT_CANCELLED}
    assert {"SIGINT", "SIGTERM", "SIGHUP", "SIGPIPE", "SIGKILL"} <= {row.strip("`") for row in rows}
