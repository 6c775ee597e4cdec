"""Results appear whole or not at all."""

from __future__ import annotations

import errno
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from cloner.errors import ClonerError
from cloner.project import atomic
from cloner.project.atomic import result_folder, safe_output, write_text
from cloner.project.stamps import output_digests


def finish(out: Path, text: str = "new", photos: Path | None = None) -> None:
    with result_folder(out, "anna", photos) as folder:
        (folder / "clone.glb").write_text(text)
        told = {"format": 3, "stamp": {"photos": {}}, "outputs": output_digests(folder, ["clone.glb"])}
        (folder / "report.json").write_text(json.dumps(told))


def test_a_result_appears_only_at_the_end(tmp_path: Path) -> None:
    out = tmp_path / "deep" / "out"
    with result_folder(out, "anna") as folder:
        (folder / "report.json").write_text("x")
        assert not (out / "anna").exists()
    assert sorted(path.name for path in out.iterdir()) == ["anna"]
    assert (out / "anna" / "report.json").read_text() == "x"


def fail_half_way(folder: Path, error: BaseException) -> None:
    (folder / "clone.glb").write_text("half")
    raise error


@pytest.mark.parametrize("error", [KeyboardInterrupt(), ClonerError("m", "h", "w"), RuntimeError("defect")])
def test_failure_leaves_nothing_not_even_the_folder_it_made(tmp_path: Path, error: BaseException) -> None:
    out = tmp_path / "deep" / "out"
    with pytest.raises(type(error)), result_folder(out, "anna") as folder:
        fail_half_way(folder, error)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("call", ["mkdir", "recover", "lock"])
def test_a_request_to_end_while_the_folder_is_made_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: str
) -> None:
    """Just after each of the calls that make it, where a signal reached a clone in CI."""
    owner = Path if call == "mkdir" else atomic
    done = getattr(owner, call)

    def ended_after(path: Path, *arguments: object, **named: object) -> None:
        done(path, *arguments, **named)
        if call != "mkdir" or "partial" in path.name:
            raise KeyboardInterrupt

    monkeypatch.setattr(owner, call, ended_after)
    with pytest.raises(KeyboardInterrupt), result_folder(tmp_path / "deep" / "out", "anna"):
        pass
    assert list(tmp_path.iterdir()) == []


def test_failure_keeps_the_older_result(tmp_path: Path) -> None:
    finish(tmp_path, "old")
    with pytest.raises(KeyboardInterrupt), result_folder(tmp_path, "anna"):
        raise KeyboardInterrupt
    assert (tmp_path / "anna" / "clone.glb").read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["anna"]


def test_a_newer_result_replaces_the_older_wholly(tmp_path: Path) -> None:
    finish(tmp_path, "old")
    finish(tmp_path, "new")
    assert sorted(path.name for path in (tmp_path / "anna").iterdir()) == ["clone.glb", "report.json"]
    assert (tmp_path / "anna" / "clone.glb").read_text() == "new"


def test_photos_are_never_replaced(tmp_path: Path) -> None:
    photos = tmp_path / "anna"
    photos.mkdir()
    (photos / "body_front.jpg").write_bytes(b"precious")
    with pytest.raises(ClonerError, match="no earlier result") as caught, result_folder(tmp_path, "anna"):
        pytest.fail("must not start")
    assert caught.value.where == "anna"
    assert (photos / "body_front.jpg").read_bytes() == b"precious"


def add_a_note(result: Path) -> None:
    (result / "notes.txt").write_text("precious")


def add_a_photo(result: Path) -> None:
    (result / "body_front.jpg").write_bytes(b"precious")


def add_a_hidden_folder(result: Path) -> None:
    (result / ".raw").mkdir()


def add_a_link(result: Path) -> None:
    (result / "clone.glb").unlink()
    (result / "clone.glb").symlink_to(result.parent)


@pytest.mark.parametrize("add", [add_a_note, add_a_photo, add_a_hidden_folder, add_a_link])
def test_what_somebody_put_into_a_result_is_never_replaced(tmp_path: Path, add: Callable[[Path], None]) -> None:
    finish(tmp_path, "old")
    add(tmp_path / "anna")
    before = sorted(path.name for path in (tmp_path / "anna").iterdir())
    with pytest.raises(ClonerError, match="somebody's own"):
        finish(tmp_path, "new")
    assert sorted(path.name for path in (tmp_path / "anna").iterdir()) == before


def test_what_somebody_puts_into_a_result_while_it_is_made_again_stays(tmp_path: Path) -> None:
    finish(tmp_path, "old")
    making = result_folder(tmp_path, "anna")
    (making.__enter__() / "report.json").write_text("{}")
    add_a_photo(tmp_path / "anna")
    with pytest.raises(ClonerError, match="somebody's own"):
        making.__exit__(None, None, None)
    assert (tmp_path / "anna" / "body_front.jpg").read_bytes() == b"precious"
    assert (tmp_path / "anna" / "clone.glb").read_text() == "old"


def test_photos_with_a_manifest_beside_them_are_photos(tmp_path: Path) -> None:
    """Somebody copied a report.json beside the photos; in one case it even lists them."""
    photos = tmp_path / "anna"
    photos.mkdir()
    (photos / "body_front.jpg").write_bytes(b"precious")
    for outputs in ({}, {"body_front.jpg": "ab"}):
        (photos / "report.json").write_text(json.dumps({"format": 3, "stamp": {"photos": {}}, "outputs": outputs}))
        for told in (photos, None):
            with pytest.raises(ClonerError):
                finish(tmp_path, photos=told)
        assert (photos / "body_front.jpg").read_bytes() == b"precious"


def test_photos_inside_the_result_are_never_replaced(tmp_path: Path) -> None:
    finish(tmp_path, "old")
    with pytest.raises(ClonerError, match="photos lie where"):
        finish(tmp_path, "new", photos=tmp_path / "anna" / "photos")


def test_single_files_are_never_replaced(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(b"precious")
    (tmp_path / "link.png").symlink_to("nowhere")
    for name, words in (("a.png", "exists"), ("link.png", "exists"), ("n" * 300, "called")):
        with pytest.raises(ClonerError, match=words):
            safe_output(tmp_path / name)
    assert safe_output(tmp_path / "b.png") == tmp_path / "b.png"


def test_output_below_a_file_is_refused_before_any_work(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    with pytest.raises(ClonerError, match="cannot be written") as caught, result_folder(tmp_path / "file" / "out", "a"):
        pytest.fail("must not start")
    assert "--out" in caught.value.hint


def test_a_read_only_place_is_refused() -> None:
    # /proc refuses even root, whom permission bits do not stop
    with pytest.raises(ClonerError, match="cannot be written"), result_folder(Path("/proc/cloner-out"), "a"):
        pytest.fail("must not start")


def test_a_full_disk_is_the_operators_to_mend(tmp_path: Path) -> None:
    with pytest.raises(ClonerError, match="cannot be written"), result_folder(tmp_path, "anna"):
        raise OSError(errno.ENOSPC, "No space left on device")
    assert list(tmp_path.iterdir()) == []


def killed_run(out: Path, code: str) -> None:
    """Start a run in another process that is killed in its middle."""
    script = f"""
import os, signal
from collections.abc import Callable
from pathlib import Path
from cloner.project.atomic import result_folder
with result_folder(Path({str(out)!r}), "anna") as folder:
    (folder / "half").write_text("x")
    {code}
    os.kill(os.getpid(), signal.SIGKILL)
"""
    paths = os.pathsep.join(sys.path)
    done = subprocess.run([sys.executable, "-c", script], env={**os.environ, "PYTHONPATH": paths}, check=False)
    assert done.returncode == -9


def test_what_a_killed_run_left_is_swept_at_the_next_start(tmp_path: Path) -> None:
    killed_run(tmp_path, "pass")
    assert any("partial" in path.name for path in tmp_path.iterdir())
    finish(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["anna"]


def test_a_result_moved_aside_by_a_killed_run_comes_back(tmp_path: Path) -> None:
    finish(tmp_path, "old")
    killed_run(tmp_path, f'os.rename({str(tmp_path / "anna")!r}, folder.parent / "replaced")')
    assert not (tmp_path / "anna").exists()
    with pytest.raises(KeyboardInterrupt), result_folder(tmp_path, "anna"):
        raise KeyboardInterrupt
    assert (tmp_path / "anna" / "clone.glb").read_text() == "old"


def test_a_running_neighbour_is_left_alone(tmp_path: Path) -> None:
    with result_folder(tmp_path, "anna") as first:
        (first / "report.json").write_text("first")
        finish(tmp_path, "second")
        assert first.is_dir(), "the second run swept the first one's folder"
        shutil.rmtree(tmp_path / "anna")
    assert (tmp_path / "anna" / "report.json").read_text() == "first"


def test_small_files_are_written_in_one_step(tmp_path: Path) -> None:
    write_text(tmp_path / "a.json", "1")
    write_text(tmp_path / "a.json", "2")
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("a.json", "2")]
    with pytest.raises(ClonerError) as caught:
        write_text(tmp_path / "none" / "a.json", "3")
    assert caught.value.where == "a.json"
