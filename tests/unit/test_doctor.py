"""The doctor names what is missing and the line that mends it."""

from __future__ import annotations

import importlib
from typing import Any

import pytest

from cloner.machines import doctor


def broken_import(monkeypatch: pytest.MonkeyPatch, name: str, trouble: str) -> None:
    real = importlib.import_module

    def import_module(wanted: str, package: str | None = None) -> Any:
        if wanted == name:
            raise ImportError(trouble)
        return real(wanted, package)

    monkeypatch.setattr(importlib, "import_module", import_module)


@pytest.mark.parametrize(
    ("name", "trouble", "fix"),
    [
        ("scipy", "No module named 'scipy'", 'pip install "scipy"'),
        ("cv2", "libGL.so.1: cannot open shared object file", "apt-get install -y libgl1"),
        ("PySide6.QtWidgets", "libEGL.so.1: cannot open shared object file", "apt-get install -y libegl1"),
    ],
)
def test_a_missing_library_has_one_fix(monkeypatch: pytest.MonkeyPatch, name: str, trouble: str, fix: str) -> None:
    broken_import(monkeypatch, name, trouble)
    (finding,) = [found for found in doctor.examine_libraries() if not found.fine]
    assert fix in finding.fix
    assert finding.needed is (name != "PySide6.QtWidgets"), "only the window wants Qt"
    assert len(finding.line().splitlines()) == 2


def test_a_failing_test_program_is_told_in_one_line() -> None:
    assert doctor.trouble_of("import sys; sys.exit(0)", {}) == ""
    assert doctor.trouble_of("raise OSError('no EGL here')", {}) == "OSError: no EGL here"
    assert doctor.trouble_of("import os; os.kill(os.getpid(), 11)", {}) == "ended with code -11"


def test_a_machine_without_egl_is_told_though_pictures_can_be_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null")  # EGL then knows no driver
    (finding,) = [found for found in doctor.examine() if found.what == "drawing (EGL)"]
    assert not finding.fine
    assert "cannot draw" in finding.detail
    assert "libegl1" in finding.fix
    assert not finding.needed, "the fallback draws"
