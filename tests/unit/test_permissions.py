"""What doctor says of a folder: who else may read, own or move it."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from cloner.machines.permissions import examine_folder

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="permissions of POSIX")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    place = tmp_path / "photos" / "anna"
    place.mkdir(parents=True)
    (place / "body_front.jpg").write_bytes(b"x")
    for path, mode in ((place / "body_front.jpg", 0o600), (place, 0o700), (place.parent, 0o700)):
        path.chmod(mode)
    for parent in tmp_path.parents:
        if parent.owner() == tmp_path.owner() and parent != Path(parent.anchor) and "pytest" in str(parent):
            parent.chmod(0o755)
    tmp_path.chmod(0o755)
    return place.parent


def told(folder: Path) -> str:
    return "\n".join(finding.line() for finding in examine_folder(folder))


def test_a_private_folder_is_fine(folder: Path) -> None:
    assert all(finding.fine for finding in examine_folder(folder)), told(folder)


def test_what_others_may_read_or_change_is_told_with_the_line_that_mends_it(folder: Path) -> None:
    folder.chmod(0o755)
    (folder / "anna").chmod(0o777)
    (folder / "anna" / "body_front.jpg").chmod(0o644)
    assert "may read 3 and change 1 of 3" in told(folder)
    assert f"chmod -R go= {folder}" in told(folder)
    folder.chmod(0o700)
    assert "optional" not in told(folder), "nobody comes through to what lies inside"


def test_a_folder_above_in_which_others_write_is_told(folder: Path) -> None:
    folder.parent.chmod(0o777)
    assert "may move it away" in told(folder)
    folder.parent.chmod(0o1777)
    assert "may move it away" not in told(folder), "the sticky bit keeps them off"


@pytest.mark.skipif(not hasattr(os, "getuid") or os.getuid() != 0, reason="only root gives files away")
def test_files_of_another_user_are_told(folder: Path) -> None:
    os.chown(folder / "anna" / "body_front.jpg", 65534, 65534)
    assert "1 files and folders are another user's" in told(folder)


def test_a_missing_folder_is_told(tmp_path: Path) -> None:
    assert "it is not there" in told(tmp_path / "nowhere")
