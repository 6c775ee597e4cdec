"""Every bad file and folder gets one clear sentence, names what it concerns, and leaves nothing half-written."""

from __future__ import annotations

import os
import re
import signal
import sys
import time
from pathlib import Path

import pytest

from cloner import cli, terminal
from cloner.errors import ClonerError
from cloner.project.clone_file import save_clone
from hostile import cases_motion, cases_photos, cases_texts
from hostile.cases import COMMANDS, READERS, Case
from kit.clones import toy_clone

CASES: tuple[Case, ...] = (*cases_photos.CASES, *cases_texts.CASES, *cases_motion.CASES)
BAD = tuple(case for case in CASES if case.words)
SLOWEST_S = 20.0  # on a busy machine; a hang or a bomb that goes off takes far longer


def everything(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def is_one_plain_line(text: str) -> bool:
    return text.isprintable() and 0 < len(text) <= 1300


def test_the_corpus_is_large_and_its_names_differ() -> None:
    assert len(BAD) >= 150
    assert len({(case.kind, case.name) for case in CASES}) == len(CASES)
    assert {case.kind for case in CASES if case.command} >= set(COMMANDS) - {"shown"}


@pytest.mark.parametrize("case", [pytest.param(case, id=f"{case.kind}-{case.name}"[:60]) for case in CASES])
def test_one_sentence_says_what_where_and_what_to_do(case: Case, tmp_path: Path) -> None:
    path = case.make(tmp_path)
    before, start = everything(tmp_path), time.monotonic()
    if not case.words:
        READERS[case.kind](path)
        return
    with pytest.raises(ClonerError) as caught:
        READERS[case.kind](path)
    error = caught.value
    assert re.search(case.words, error.message), str(error)
    assert re.search(case.hint, error.hint), str(error)
    assert error.hint
    assert re.search(case.where, error.where) or case.where in error.where, str(error)
    assert error.where
    assert is_one_plain_line(str(error)), str(error)
    assert str(tmp_path) not in str(error), "messages must not tell home paths"
    assert everything(tmp_path) == before
    assert time.monotonic() - start < SLOWEST_S


@pytest.fixture(scope="module")
def good_clone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("good") / "clone.npz"
    save_clone(toy_clone(), path)
    return path


@pytest.mark.parametrize("case", [pytest.param(case, id=case.name[:60]) for case in BAD if case.command])
def test_the_command_line_says_it_too(
    case: Case, tmp_path: Path, good_clone: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "in").mkdir()
    path, out = case.make(tmp_path / "in"), tmp_path / "out"
    given = {
        "PATH": path,
        "CLONE": good_clone,
        "OUT": out,
        "OUT.glb": tmp_path / "o.glb",
        "OUT.png": tmp_path / "o.png",
    }
    monkeypatch.setattr(sys, "argv", ["cloner", *(os.fspath(given.get(word, word)) for word in COMMANDS[case.kind])])
    before = everything(tmp_path)
    handler, mask = signal.getsignal(signal.SIGTERM), os.umask(0o077)
    try:
        with pytest.raises(SystemExit) as caught:
            cli.main()
    finally:
        signal.signal(signal.SIGTERM, handler)
        os.umask(mask)
    told = capfd.readouterr()
    assert caught.value.code == terminal.EXIT_INPUT, told.err
    said = [line for line in told.err.splitlines() if line.startswith("cloner: ")]
    assert len(said) == 1, told.err
    assert re.search(case.words, said[0])
    assert "\x1b" not in told.err
    assert "Traceback" not in told.err + told.out
    assert everything(tmp_path) == before, "something half-written was left"
